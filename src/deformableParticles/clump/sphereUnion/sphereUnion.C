/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereUnion.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"
#include <Eigen/Dense>
#include <Eigen/StdVector>
#include <vector>

namespace
{

using namespace Foam;

constexpr int nDirections = 400;

//- One number for every direction
typedef Eigen::Array<scalar, nDirections, 1> perDirection;

//- The components of directions, one in a row
typedef Eigen::Matrix<scalar, nDirections, 3> directionMatrix;

//- Directions of equal weight: a spiral of equal steps in height and of the golden
//  angle
const directionMatrix& directions()
{
    static const directionMatrix result = []()
    {
        using constant::mathematical::pi;
        directionMatrix n;
        for (int k = 0; k < nDirections; ++k)
        {
            const scalar z = 1 - (2*k + 1.0)/nDirections;
            const scalar angle = pi*(1 + Foam::sqrt(5.0))*(k + 0.5);
            const scalar s = Foam::sqrt(1 - sqr(z));
            n.row(k) << s*Foam::cos(angle), s*Foam::sin(angle), z;
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


//- The plane between sphere i and sphere j
struct dividingPlane
{
    label j;
    scalar a;           // d.n times its distance along n from the centre of i [m2]
    scalar w;           // see weightOfPlane
    scalar slope;       // dw/d|d|, d = x_j - x_i [1/m]
    perDirection y;     // r d.n/a, 0 where it is negative
};


//- Weight of the plane between two spheres at a distance of x times the sum of their
//  radii: 1 where they touch, 0 from 1.5 times that distance on, with two continuous
//  derivatives. slope: dw/dx
scalar weightOfPlane(const scalar x, scalar& slope)
{
    const scalar s = min(max(2*(x - 1), 0), 1);
    slope = -60*sqr(s*(1 - s));
    return 1 - pow3(s)*(10 - 15*s + 6*sqr(s));
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


namespace
{

//- Integrals of 1, x and xx over a body
struct integrals
{
    scalar V = 0;
    vector first = Zero;
    symmTensor second = Zero;

    //- Add a span from a to b of a column around x, y
    void add
    (
        const scalar x, const scalar y, const scalar a, const scalar b,
        const scalar dx, const scalar dy
    )
    {
        const scalar v = (b - a)*dx*dy;
        const vector c(x, y, 0.5*(a + b));
        V += v;
        first += v*c;
        second +=
            v
           *(
                sqr(c)
              + symmTensor(sqr(dx), 0, 0, sqr(dy), 0, sqr(b - a))/12
            );
    }
};

}


Foam::bodyMoments Foam::sphereUnion::moments
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const label nColumns
)
{
    bodyMoments result;
    const boundBox box(bounds(centres, radii));
    const point middle(box.midpoint());
    const scalar dx = box.span().x()/nColumns;
    const scalar dy = box.span().y()/nColumns;

    // The columns give what the overlaps take off the sum of the spheres
    integrals part;
    integrals whole;
    forEachInterval
    (
        centres, radii, dx, dy,
        [&]
        (
            const scalar x, const scalar y, const label,
            const scalar bottom, const scalar from, const scalar top
        )
        {
            const scalar X = x - middle.x();
            const scalar Y = y - middle.y();
            const scalar Z = middle.z();
            whole.add(X, Y, bottom - Z, top - Z, dx, dy);
            if (top > from)
            {
                result.volume += (top - from)*dx*dy;
                part.add(X, Y, from - Z, top - Z, dx, dy);
            }
        }
    );
    scalar V = part.V - whole.V;
    vector first(part.first - whole.first);
    symmTensor second(part.second - whole.second);
    forAll(centres, i)
    {
        const scalar v = constant::mathematical::pi*4/3*pow3(radii[i]);
        const vector c(centres[i] - middle);
        V += v;
        first += v*c;
        second += v*(sqr(c) + 0.2*sqr(radii[i])*symmTensor(I));
    }
    if (!(V > 0) || !(result.volume > 0))
    {
        result.volume = 0;
        return result;
    }
    const vector c(first/V);
    result.centre = middle + c;
    result.second = result.volume*(second/V - sqr(c));
    result.accuracy = 1e-4;
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
    typedef Eigen::Matrix<scalar, 3, 1> column;

    const directionMatrix& n = directions();
    const point centre(average(x));
    const scalar weight = 4*constant::mathematical::pi/nDirections;

    grad = Zero;
    scalar result = 0;
    std::vector<dividingPlane, Eigen::aligned_allocator<dividingPlane>> planes;
    perDirection S, t3, y2, y4, y15;

    forAll(x, i)
    {
        const scalar r = radii[i];
        const tensor T(frame(x, centre, i));

        planes.clear();
        S = 1;
        forAll(x, j)
        {
            const vector d(x[j] - x[i]);
            const scalar d2 = magSqr(d);
            const scalar contactDistance = r + radii[j];
            if (j == i || d2 >= sqr(1.5*contactDistance) || d2 <= sqr(1e-6*r))
            {
                continue;
            }
            planes.emplace_back();
            dividingPlane& plane = planes.back();
            plane.j = j;
            plane.w = weightOfPlane(Foam::sqrt(d2)/contactDistance, plane.slope);
            plane.slope /= contactDistance;
            plane.a = max(0.5*(d2 + sqr(r) - sqr(radii[j])), 1e-6*sqr(r));
            const vector along(r/plane.a*(T & d));
            plane.y =
                (n*column(along.x(), along.y(), along.z())).array().max(0.0);

            // The sum of y^16 is dominated by the nearest plane
            S += plane.w*plane.y.square().square().square().square();
        }

        // t^3 = r^3 S^(-3/16)
        t3 = pow3(r)*S.sqrt().sqrt().sqrt().sqrt().inverse().cube();
        result += weight/3*t3.sum();
        t3 /= S;

        // d(t^3/3) = -t^3/S sum_j y^16 (w (n.delta/(d.n) - d.delta/a)
        //   + dw/dd d.delta/(16 |d|)), delta = dx_j - dx_i
        for (const dividingPlane& plane : planes)
        {
            y2 = plane.y.square();
            y4 = y2.square();
            y15 = weight*t3*y4.square()*y4*y2*plane.y;

            const column along(plane.w*r/plane.a*(n.transpose()*y15.matrix()));
            const vector d(x[plane.j] - x[i]);
            const vector g
            (
                (y15*plane.y).sum()*(plane.w/plane.a - plane.slope/(16*mag(d)))*d
              - (T.T() & vector(along[0], along[1], along[2]))
            );
            grad[plane.j] += g;
            grad[i] -= g;
        }
    }

    removeTorque(x, grad);
    return result;
}
