/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "unionVolume.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace conservationModels
{
    defineTypeNameAndDebug(unionVolume, 0);
    addToRunTimeSelectionTable(conservationModel, unionVolume, dictionary);
}
}


Foam::conservationModels::unionVolume::unionVolume
(
    const dictionary& dict,
    const pointField& centres,
    const scalarField& radii
)
:
    volumeModulus_(getPositive(dict, "volumeModulus")),
    radii_(radii),
    volume0_(0)
{
    checkEntries(dict, {"type", "volumeModulus"});

    forAll(centres, i)
    {
        forAll(centres, j)
        {
            const scalar d2 = magSqr(centres[j] - centres[i]);
            if (j != i && d2 + sqr(radii[i]) <= sqr(radii[j]))
            {
                FatalIOErrorInFunction(dict)
                    << "conservationModel unionVolume: sphere " << i
                    << " lies too deep inside of sphere " << j
                    << exit(FatalIOError);
            }
        }
    }

    vectorField grad(centres.size());
    volume0_ = volume(centres, grad);
}


const Foam::pointField& Foam::conservationModels::unionVolume::directions()
{
    // A spiral of equal steps in height and of the golden angle
    static const pointField result = []()
    {
        using constant::mathematical::pi;
        pointField n(200);
        forAll(n, k)
        {
            const scalar z = 1 - (2*k + 1.0)/n.size();
            const scalar angle = pi*(1 + Foam::sqrt(5.0))*(k + 0.5);
            const scalar s = Foam::sqrt(1 - sqr(z));
            n[k] = point(s*Foam::cos(angle), s*Foam::sin(angle), z);
        }
        return n;
    }();
    return result;
}


Foam::tensor Foam::conservationModels::unionVolume::frame
(
    const pointField& x,
    const point& centre,
    const label i
)
{
    // Along the neighbours in the list, and away from the centre
    vector along(x[x.fcIndex(i)] - x[x.rcIndex(i)]);
    if (mag(along) < SMALL*mag(x[x.fcIndex(i)] - x[i]))
    {
        along = x[x.fcIndex(i)] - x[i];
    }
    if (mag(along) < VSMALL)
    {
        return tensor::I;
    }
    const vector e3(normalised(along));
    vector out(x[i] - centre);
    out -= (out & e3)*e3;
    const scalar size = mag(x[i] - centre);
    if (mag(out) < 1e-6*size + VSMALL)
    {
        out = e3 ^ (mag(e3.x()) < 0.7 ? vector(1, 0, 0) : vector(0, 1, 0));
    }
    const vector e1(normalised(out));

    // The spiral's axis points outwards: its rows then do not follow the planes
    // between neighbours
    return tensor(e3 ^ e1, e3, e1);
}


void Foam::conservationModels::unionVolume::removeTorque
(
    const pointField& x,
    vectorField& grad
)
{
    const point centre(average(x));
    vector torque(Zero);
    tensor I(Zero);
    forAll(x, i)
    {
        const vector r(x[i] - centre);
        torque += r ^ grad[i];
        I += magSqr(r)*tensor::I - r*r;
    }

    // A straight chain has no inertia about its axis, and no torque either
    const scalar scale = tr(I);
    if (scale < VSMALL)
    {
        return;
    }
    const vector alpha
    (
        inv(I/scale + 1e-9*tensor::I) & (torque/scale)
    );
    forAll(x, i)
    {
        grad[i] -= alpha ^ (x[i] - centre);
    }
}


Foam::scalar Foam::conservationModels::unionVolume::volume
(
    const pointField& x,
    vectorField& grad
) const
{
    const pointField& n = directions();
    const point centre(average(x));
    const scalar weight = 4*constant::mathematical::pi/n.size();

    grad = Zero;
    scalar sum = 0;
    DynamicList<label> near;
    DynamicList<vector> d;
    DynamicList<scalar> a;

    forAll(x, i)
    {
        const scalar r = radii_[i];
        const tensor T(frame(x, centre, i).T());

        near.clear();
        d.clear();
        a.clear();
        forAll(x, j)
        {
            const vector dij(x[j] - x[i]);
            if (j != i && magSqr(dij) < sqr(r + radii_[j]))
            {
                near.append(j);
                d.append(T.T() & dij);
                a.append(0.5*(magSqr(dij) + sqr(r) - sqr(radii_[j])));
            }
        }

        // Sums by the neighbours' planes, in the sphere's frame
        vectorField byNormal(near.size(), Zero);
        scalarField byDistance(near.size(), Zero);

        for (const vector& nk : n)
        {
            scalar t = r;
            label nearest = -1;
            forAll(near, k)
            {
                const scalar dn = d[k] & nk;
                if (a[k] < t*dn)
                {
                    t = max(a[k], scalar(0))/dn;
                    nearest = k;
                }
            }
            sum += weight*pow3(t)/3;

            // dt = d.delta/(d.n) - a n.delta/(d.n)^2, delta = dx_j - dx_i
            if (nearest >= 0)
            {
                const scalar dn = d[nearest] & nk;
                byDistance[nearest] += weight*sqr(t)/dn;
                byNormal[nearest] += weight*sqr(t)*a[nearest]/sqr(dn)*nk;
            }
        }

        forAll(near, k)
        {
            const vector g(T & (byDistance[k]*d[k] - byNormal[k]));
            grad[near[k]] += g;
            grad[i] -= g;
        }
    }

    removeTorque(x, grad);
    return sum;
}
