/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "sphereGrid.H"
#include "contactShares.H"
#include <algorithm>

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


//- The same with the shares of what the two clumps press each other with
DynamicList<contactShares::pair> touchingPairs
(
    const ghostExchange& ghosts,
    const PtrList<clumpType>& types
)
{
    typedef contactShares::pair pair;
    DynamicList<pair> pairs;

    forEachTouching
    (
        ghosts, types,
        [&]
        (
            const label a, const label i, const clumpType& ta,
            const label b, const label j, const clumpType& tb,
            const vector& d
        )
        {
            // Coincident centres have no direction to part in
            const scalar r = ta.radii()[i];
            const scalar distance = mag(d);
            const vector n(distance > SMALL*r ? d/distance : vector::zero);
            pairs.append
            (
                {a, i, b, j, n, r + tb.radii()[j] - distance, 0, 0}
            );
        }
    );

    // Clump by clump
    std::stable_sort
    (
        pairs.begin(), pairs.end(),
        [](const pair& p, const pair& q)
        {
            return p.a != q.a ? p.a < q.a : p.b < q.b;
        }
    );
    const UList<clumpImage>& images = ghosts.images();
    for (label start = 0, end = 0; start < pairs.size(); start = end)
    {
        const label a = pairs[start].a;
        const label b = pairs[start].b;
        while (end < pairs.size() && pairs[end].a == a && pairs[end].b == b)
        {
            ++end;
        }
        UList<pair> ofTwo(&pairs[start], end - start);
        contactShares::set
        (
            ofTwo,
            images[a].x, types[images[a].typeId].radii(),
            images[b].x, types[images[b].typeId].radii()
        );
    }

    return pairs;
}

}


void Foam::deformableCloud::addContacts
(
    List<integrator::externals>& ext
) const
{
    const UList<clumpImage>& images = contactGhosts_.images();

    for (const contactShares::pair& p : touchingPairs(contactGhosts_, types_))
    {
        const clumpImage& A = images[p.a];
        const clumpImage& B = images[p.b];
        const clumpType& ta = types_[A.typeId];
        const clumpType& tb = types_[B.typeId];

        ext[p.a].f[p.i] += p.share*p.normal*contactModel_->force
        (
            p.depth,
            (B.u[p.j] - A.u[p.i]) & p.normal,
            ta.radii()[p.i],
            tb.radii()[p.j],
            contactShares::mass(p.i, A.x, ta.radii(), ta.masses()),
            contactShares::mass(p.j, B.x, tb.radii(), tb.masses())
        );
    }
}


void Foam::deformableCloud::addWalls(List<integrator::externals>& ext) const
{
    const effects::timer t(effects_, "walls");

    label index = 0;
    for (const clumpParcel& parcel : *this)
    {
        const scalarField& r = type(parcel).radii();
        const scalarField& masses = type(parcel).masses();
        const pointField x(parcel.centres());
        integrator::externals& e = ext[index++];

        for (const auto& c : contactShares::ofWalls(*walls_, x, r))
        {
            const vector& n = c.wall.normal;
            e.f[c.i] += c.share*n*wallContactModel_->force
            (
                c.depth,
                -(parcel.state().u[c.i] & n),
                r[c.i],
                contactShares::mass(c.i, x, r, masses)
            );
            e.k[c.i] +=
                c.share*wallContactModel_->stiffness(c.depth, r[c.i])*sqr(n);
        }
    }
}


Foam::label Foam::deformableCloud::contactSubSteps
(
    const List<integrator::externals>& ext,
    const scalar dt
) const
{
    // Contacts between clumps are explicit: a sub-step h is stable while
    // m/h^2 + zeta/h exceeds twice the stiffness, which is that of all contacts
    // of a sphere, of either side
    const UList<clumpImage>& images = ghosts_.images();
    List<scalarField> stiffness(ghosts_.nOwn());
    List<scalarField> lightest(ghosts_.nOwn());

    for (const contactShares::pair& p : touchingPairs(ghosts_, types_))
    {
        const clumpType& ta = types_[images[p.a].typeId];
        const clumpType& tb = types_[images[p.b].typeId];
        scalarField& k = stiffness[p.a];
        scalarField& m = lightest[p.a];
        if (k.empty())
        {
            k.setSize(ta.size(), Zero);
            m = ta.masses();
        }

        k[p.i] +=
            4*p.share*contactShares::stiffening(p.share)
           *contactModel_->stiffness
            (
                p.depth, ta.radii()[p.i], tb.radii()[p.j]
            );
        m[p.i] = min(m[p.i], tb.masses()[p.j]);
    }

    label nSub = 1;
    forAll(stiffness, a)
    {
        forAll(stiffness[a], i)
        {
            const scalar k = stiffness[a][i];
            if (k > 0)
            {
                const scalar m = lightest[a][i];
                const scalar z = ext[a].zeta[i];
                const scalar h = (z + Foam::sqrt(sqr(z) + 4*k*m))/(2*k);

                nSub = max(nSub, label(min(std::ceil(dt/h), scalar(1000000))));
            }
        }
    }

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
