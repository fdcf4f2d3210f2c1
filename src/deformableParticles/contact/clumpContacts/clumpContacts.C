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
    laws_(getDict(clumpProperties, "contactModel"), types)
{}


Foam::scalar Foam::clumpContacts::distance
(
    const clumpImage& A,
    const label i,
    const clumpImage& B,
    const label j
) const
{
    const clumpType& ta = types_[A.typeId];
    const clumpType& tb = types_[B.typeId];
    const scalar r = ta.radii()[i] + tb.radii()[j];
    const bool mirrored = A.transform.mirrors() || B.transform.mirrors();
    if (A.pieceOf < 0 || A.pieceOf != B.pieceOf || A.id == B.id || mirrored)
    {
        return r;
    }
    const pointField& c = types_[ta.whole(A.typeId)].centres();
    return min(r, mag(c[ta.numberInWhole(i)] - c[tb.numberInWhole(j)]));
}


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
    const scalar usual = max
    (
        0.1, placement.getOrDefault<scalar>("maxOverlap", 0)
    );
    scalar deepest = 0;
    string said;
    sphereGrid::forEachContact
    (
        images, nOwn, types_,
        [&](const label a, const label i, const label b, const label j)
        {
            const clumpType& ta = types_[images[a].typeId];
            const clumpType& tb = types_[images[b].typeId];
            if (!ta.ofSpheres() || !tb.ofSpheres())
            {
                // Their kinds have contacts of their own
                return;
            }
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
            const scalar depth =
                (
                    ta.radii()[i] + tb.radii()[j]
                  - mag(images[a].x[i] - images[b].x[j])
                )
               /min(ta.radii()[i], tb.radii()[j]);
            if (depth > max(usual, deepest))
            {
                deepest = depth;
                OStringStream os;
                os  << "Entry 'position': clumps " << images[a].id.second()
                    << " and " << images[b].id.second() << " overlap by "
                    << label(100*depth + 0.5) << " % of a radius at "
                    << images[a].x[i] << ". Contact will push them apart in the"
                    << " first steps, but rings that are linked cannot part.";
                said = os.str();
            }
        }
    );
    const scalar most = returnReduce(deepest, maxOp<scalar>());
    if (deepest > 0 && deepest == most)
    {
        IOWarningInFunction(placement) << said.c_str() << endl;
    }
}
