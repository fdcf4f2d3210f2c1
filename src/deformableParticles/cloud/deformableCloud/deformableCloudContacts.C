/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "sphereGrid.H"

namespace
{

using namespace Foam;

//- Spheres i of image a and j of image b that touch, with their types and what
//  leads from j to i
template<class Action>
void forEachTouching
(
    const ghostExchange& ghosts,
    const PtrList<clumpType>& types,
    const Action& action
)
{
    const UList<clumpImage>& images = ghosts.images();

    sphereGrid::forEachContact
    (
        images, ghosts.nOwn(), types,
        [&](const label a, const label i, const label b, const label j)
        {
            action
            (
                a, i, types[images[a].typeId],
                b, j, types[images[b].typeId],
                images[a].x[i] - images[b].x[j]
            );
        }
    );
}

}


void Foam::deformableCloud::addContacts
(
    List<integrator::externals>& ext
) const
{
    const UList<clumpImage>& images = contactGhosts_.images();

    forEachTouching
    (
        contactGhosts_, types_,
        [&]
        (
            const label a, const label i, const clumpType& ta,
            const label b, const label j, const clumpType& tb,
            const vector& d
        )
        {
            const scalar distance = mag(d);

            // Coincident centres have no direction to part in
            if (distance > SMALL*ta.radii()[i])
            {
                const vector n(d/distance);
                ext[a].f[i] += n*contactModel_->force
                (
                    ta.radii()[i] + tb.radii()[j] - distance,
                    (images[b].u[j] - images[a].u[i]) & n,
                    ta.radii()[i],
                    tb.radii()[j],
                    ta.masses()[i],
                    tb.masses()[j]
                );
            }
        }
    );
}


void Foam::deformableCloud::addWalls(List<integrator::externals>& ext) const
{
    const effects::timer t(effects_, "walls");

    label index = 0;
    for (const clumpParcel& parcel : *this)
    {
        const clumpType& ct = type(parcel);
        const pointField centres(parcel.centres());

        forAll(centres, i)
        {
            for (const auto& c : walls_->contacts(centres[i], ct.radii()[i]))
            {
                ext[index].f[i] += c.normal*wallContactModel_->force
                (
                    c.overlap,
                    -(parcel.state().u[i] & c.normal),
                    ct.radii()[i],
                    ct.masses()[i]
                );
                ext[index].k[i] +=
                    wallContactModel_->stiffness(c.overlap, ct.radii()[i])
                   *sqr(c.normal);
            }
        }
        ++index;
    }
}


Foam::label Foam::deformableCloud::contactSubSteps
(
    const List<integrator::externals>& ext,
    const scalar dt
) const
{
    // Contacts between clumps are explicit: a sub-step h is stable while
    // m/h^2 + zeta/h exceeds twice the stiffness
    label nSub = 1;
    forEachTouching
    (
        ghosts_, types_,
        [&]
        (
            const label a, const label i, const clumpType& ta,
            const label b, const label j, const clumpType& tb,
            const vector& d
        )
        {
            const scalar overlap =
                ta.radii()[i] + tb.radii()[j] - mag(d);

            const scalar k =
                4*contactModel_->stiffness
                (
                    overlap, ta.radii()[i], tb.radii()[j]
                );
            const scalar m = min(ta.masses()[i], tb.masses()[j]);
            const scalar z = ext[a].zeta[i];
            const scalar h = (z + Foam::sqrt(sqr(z) + 4*k*m))/(2*k);

            nSub = max(nSub, label(min(std::ceil(dt/h), scalar(1000000))));
        }
    );

    return returnReduce(nSub, maxOp<label>());
}


void Foam::deformableCloud::checkOverlaps(const dictionary& dict) const
{
    if (!contactModel_->active() || !effects_.active("contact"))
    {
        return;
    }

    const UList<clumpImage>& images = ghosts_.images();

    forEachTouching
    (
        ghosts_, types_,
        [&]
        (
            const label a, const label i, const clumpType& ta,
            const label b, const label j, const clumpType& tb,
            const vector& d
        )
        {
            if (mag(d) < max(ta.radii()[i], tb.radii()[j]))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry position: sphere " << i << " of clump "
                    << images[a].id.second() << " of type " << ta.name()
                    << " and sphere " << j << " of clump "
                    << images[b].id.second() << " of type " << tb.name()
                    << " lie inside each other at " << images[a].x[i]
                    << exit(FatalIOError);
            }
        }
    );
}
