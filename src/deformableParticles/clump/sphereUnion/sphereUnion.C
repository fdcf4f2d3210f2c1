/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereUnion.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- Directions of equal weight: a spiral of equal steps in height and of the golden
//  angle
const pointField& directions()
{
    static const pointField result = []()
    {
        using constant::mathematical::pi;
        pointField n(400);
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


//- Axes of the directions of sphere i, as rows: outwards the last one
tensor frame
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


//- Remove from grad the part that does work on a rotation of all points
void removeTorque
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

}


Foam::scalar Foam::sphereUnion::volume
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const label nColumns
)
{
    const vector span(bounds(centres, radii).span());
    scalar result = 0;
    forEachChord
    (
        centres, radii, span.x()/nColumns, span.y()/nColumns,
        [&](const scalar, const scalar, const label, const scalar V)
        {
            result += V;
        }
    );
    return result;
}


Foam::boundBox Foam::sphereUnion::bounds
(
    const UList<point>& centres,
    const UList<scalar>& radii
)
{
    boundBox box;
    forAll(centres, i)
    {
        box.add(centres[i] - radii[i]*vector::one);
        box.add(centres[i] + radii[i]*vector::one);
    }
    return box;
}


Foam::scalar Foam::sphereUnion::smoothVolume
(
    const pointField& x,
    const scalarField& radii,
    vectorField& grad
)
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
        const scalar r = radii[i];
        const tensor T(frame(x, centre, i).T());

        near.clear();
        d.clear();
        a.clear();
        forAll(x, j)
        {
            const vector dij(x[j] - x[i]);
            const scalar d2 = magSqr(dij);
            if (j != i && d2 < sqr(r + radii[j]) && d2 > sqr(1e-6*r))
            {
                near.append(j);
                d.append(T.T() & dij);
                a.append(max(0.5*(d2 + sqr(r) - sqr(radii[j])), 1e-6*sqr(r)));
            }
        }

        // Contributions of the plane of a neighbour to the gradient, along the
        // directions and along d, in the frame of the sphere
        vectorField along(near.size(), Zero);
        scalarField across(near.size(), Zero);
        scalarField part(near.size());

        for (const vector& nk : n)
        {
            // The sum of y^16 is dominated by the nearest plane
            scalar S = 0;
            forAll(near, k)
            {
                const scalar y = r*(d[k] & nk)/a[k];
                part[k] = y > 0 ? sqr(sqr(y))*sqr(sqr(y)) : 0;
                S += sqr(part[k]);
            }
            const scalar t3 = pow3(r)*Foam::pow(1 + S, -3.0/16);
            sum += weight*t3/3;

            // d(t^3/3) = -t^3/(1 + S) sum y^16 (n.delta/(d.n) - d.delta/a),
            // delta = dx_j - dx_i
            forAll(near, k)
            {
                if (part[k] > 0)
                {
                    const scalar w = weight*t3/(1 + S)*sqr(part[k]);
                    along[k] += w/(d[k] & nk)*nk;
                    across[k] += w/a[k];
                }
            }
        }

        forAll(near, k)
        {
            const vector g(T & (across[k]*d[k] - along[k]));
            grad[near[k]] += g;
            grad[i] -= g;
        }
    }

    removeTorque(x, grad);
    return sum;
}
