/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpContacts.H"
#include "sphereGrid.H"
#include <algorithm>

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
    const scalar dt
) const
{
    scalarField margins(nOwn);
    forAll(margins, a)
    {
        margins[a] = 2*max(mag(images[a].u))*dt;
    }
    bool found = false;
    sphereGrid::forEachNear
    (
        images, nOwn, margins, [&](const label, const label) { found = true; }
    );
    return found;
}


Foam::DynamicList<Foam::contactShares::pair> Foam::clumpContacts::touchingPairs
(
    const UList<clumpImage>& images,
    const label nOwn
) const
{
    typedef contactShares::pair pair;
    DynamicList<pair> pairs;

    sphereGrid::forEachContact
    (
        images, nOwn, types_,
        [&](const label a, const label i, const label b, const label j)
        {
            // Coincident centres have no direction to part in
            const scalar r = types_[images[a].typeId].radii()[i];
            const vector d(images[a].x[i] - images[b].x[j]);
            const scalar distance = mag(d);
            const vector n(distance > SMALL*r ? d/distance : vector::zero);
            const scalar rj = types_[images[b].typeId].radii()[j];
            pairs.append({a, i, b, j, n, r + rj - distance, 0, 0});
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
            images[a].x, types_[images[a].typeId].radii(),
            images[b].x, types_[images[b].typeId].radii()
        );
    }

    return pairs;
}


void Foam::clumpContacts::addForces
(
    UList<clumpImage>& images,
    const label nOwn
) const
{
    for (const contactShares::pair& p : touchingPairs(images, nOwn))
    {
        clumpImage& A = images[p.a];
        const clumpImage& B = images[p.b];
        const clumpType& ta = types_[A.typeId];
        const clumpType& tb = types_[B.typeId];

        A.force[p.i] += p.share*p.normal*law_->force
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


Foam::label Foam::clumpContacts::subSteps
(
    const UList<clumpImage>& images,
    const UPtrList<const externalForces>& forces,
    const scalar dt
) const
{
    // The stiffness is that of all contacts of a sphere, of either side
    List<scalarField> stiffness(forces.size());
    List<scalarField> lightest(forces.size());

    for (const contactShares::pair& p : touchingPairs(images, forces.size()))
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
           *law_->stiffness(p.depth, ta.radii()[p.i], tb.radii()[p.j]);
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
                const scalar z = forces[a].zeta[i];
                const scalar h = (z + Foam::sqrt(sqr(z) + 4*k*m))/(2*k);

                nSub = max(nSub, label(min(std::ceil(dt/h), scalar(1000000))));
            }
        }
    }

    return returnReduce(nSub, maxOp<label>());
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
