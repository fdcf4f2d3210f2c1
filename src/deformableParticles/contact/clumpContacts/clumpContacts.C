/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpContacts.H"
#include "sphereGrid.H"

Foam::clumpContacts::clumpContacts
(
    const PtrList<clumpType>& types,
    const dictionary& clumpProperties
)
:
    types_(types),
    law_(selectModel<contactModel>(getDict(clumpProperties, "contactModel")))
{}


bool Foam::clumpContacts::near
(
    const UList<clumpImage>& images,
    const label nOwn,
    const scalar dt,
    const scalar range
) const
{
    scalarField margins(nOwn);
    forAll(margins, a)
    {
        margins[a] = 2*max(mag(images[a].u))*dt + range;
    }
    bool found = false;
    sphereGrid::forEachNear
    (
        images, nOwn, margins, [&](const label, const label) { found = true; }
    );
    return found;
}


void Foam::clumpContacts::refuseOverlaps
(
    const UList<clumpImage>& images,
    const label nOwn,
    const dictionary& placement
) const
{
    sphereGrid::forEachContact
    (
        images, nOwn, types_,
        [&](const label a, const label i, const label b, const label j)
        {
            const clumpType& ta = types_[images[a].typeId];
            const clumpType& tb = types_[images[b].typeId];
            if
            (
                mag(images[a].x[i] - images[b].x[j])
              < max(ta.radii()[i], tb.radii()[j])
            )
            {
                FatalIOErrorInFunction(placement)
                    << "Entry 'position': sphere " << i << " of clump "
                    << images[a].id.second() << " (type " << ta.name()
                    << ") contains the centre of sphere " << j << " of clump "
                    << images[b].id.second() << " (type " << tb.name()
                    << "), or the reverse, at " << images[a].x[i]
                    << "; move the clumps apart."
                    << exit(FatalIOError);
            }
        }
    );
}
