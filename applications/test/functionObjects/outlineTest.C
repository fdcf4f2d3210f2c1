/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clump/closedSurfaces.H"
#include "membrane/testMembrane.H"
#include "outline.H"

using namespace Foam;

namespace
{

const scalar pi = constant::mathematical::pi;

//- Discs in the plane
struct discs
{
    List<vector2D> centres;
    scalarField radii;

    discs(const std::initializer_list<vector>& given)
    :
        centres(given.size()),
        radii(given.size())
    {
        label n = 0;
        for (const vector& d : given)
        {
            centres[n] = vector2D(d.x(), d.y());
            radii[n++] = d.z();
        }
    }

    //- Turned around the origin
    discs turned(const scalar angle) const
    {
        discs result(*this);
        const scalar c = Foam::cos(angle);
        const scalar s = Foam::sin(angle);
        for (vector2D& p : result.centres)
        {
            p = vector2D(c*p.x() - s*p.y(), s*p.x() + c*p.y());
        }
        return result;
    }

    outline whole() const { return outline::ofDiscs(centres, radii); }
    outline hull() const { return outline::hull(centres, radii); }
};


closedSurface surfaceOf(const triSurface& s)
{
    List<triFace> triangles(s.size());
    forAll(s, n)
    {
        triangles[n] = triFace(s[n][0], s[n][1], s[n][2]);
    }
    return closedSurface(s.points(), triangles, dictionary::null);
}


void checkSame(const outline& a, const outline& b, const scalar error)
{
    CHECK(a.area() == Approx(b.area()).epsilon(error));
    CHECK(a.perimeter() == Approx(b.perimeter()).epsilon(error));
    CHECK(a.inertiaRatio() == Approx(b.inertiaRatio()).epsilon(error));
}

}


TEST_CASE("outline: a disc, twice or hidden", "[tables][outline][serial]")
{
    const discs given = GENERATE
    (
        discs({{3, -2, 1.5}}),
        discs({{3, -2, 1.5}, {3, -2, 1.5}}),
        discs({{3.4, -2, 1}, {3, -2, 1.5}, {3, -1, 0.5}})
    );
    for (const bool hull : {false, true})
    {
        const outline o(hull ? given.hull() : given.whole());
        CHECK(o.area() == Approx(pi*sqr(1.5)));
        CHECK(o.perimeter() == Approx(2*pi*1.5));
        CHECK(o.circularity() == Approx(1));
        CHECK(o.inertiaRatio() == Approx(1));
    }
}


TEST_CASE("outline: two discs, and the stadium around them", "[tables][outline][serial]")
{
    const scalar r = 1.5;
    const scalar d = 2;
    const scalar turn = GENERATE(0.0, 0.7, 3.141592653589793, 1.5707963267948966);
    const discs given(discs({{-1, 0.3, r}, {1, 0.3, r}}).turned(turn));

    // Each without the segment beyond the line between the crossings
    const scalar half = Foam::acos(0.5*d/r);
    const outline whole(given.whole());
    CHECK
    (
        whole.area() == Approx(2*sqr(r)*(pi - half + Foam::sin(half)*Foam::cos(half)))
    );
    CHECK(whole.perimeter() == Approx(4*r*(pi - half)));

    const outline hull(given.hull());
    CHECK(hull.area() == Approx(pi*sqr(r) + 2*r*d));
    CHECK(hull.perimeter() == Approx(2*pi*r + 2*d));
    const scalar across = pow3(2*r)*d/12 + pi*pow4(r)/4;
    const scalar along =
        pow3(d)*2*r/12 + pi*pow4(r)/4 + 4.0/3.0*d*pow3(r) + sqr(d)/4*pi*sqr(r);
    if (turn == 0)
    {
        CHECK(hull.inertiaRatio() == Approx(Foam::sqrt(along/across)));
    }
    if (mag(turn - 0.5*pi) < 1e-9)
    {
        CHECK(hull.inertiaRatio() == Approx(Foam::sqrt(across/along)));
    }
}


TEST_CASE("outline: two discs of different size", "[tables][outline][serial]")
{
    const discs given(discs({{0, 0, 2}, {4, 0, 1}}).turned(GENERATE(0.0, 2.1)));
    const scalar between = Foam::sqrt(scalar(16 - 1));
    const scalar half = Foam::acos(1.0/4);
    const outline hull(given.hull());
    CHECK(hull.perimeter() == Approx(4*(pi - half) + 2*half + 2*between));
    CHECK(hull.area() == Approx(4*(pi - half) + half + 3*between));

    // Apart from each other: two curves
    const outline whole(given.whole());
    CHECK(whole.perimeter() == Approx(6*pi));
    CHECK(whole.area() == Approx(5*pi));
}


TEST_CASE("outline: the hole of a ring is filled", "[tables][outline][serial]")
{
    discs ring({});
    ring.centres.setSize(12);
    ring.radii = scalarField(12, 1);
    forAll(ring.centres, k)
    {
        ring.centres[k] =
            vector2D(1, 2) + 3*vector2D(Foam::cos(k*pi/6), Foam::sin(k*pi/6));
    }
    discs filled(ring);
    filled.centres.append(vector2D(1, 2));
    filled.radii.append(3);
    checkSame(ring.whole(), filled.whole(), 1e-9);

    // The polygon of the centres, dilated by a disc
    const scalar side = 6*Foam::sin(pi/12);
    CHECK(ring.hull().perimeter() == Approx(12*side + 2*pi));
    CHECK
    (
        ring.hull().area()
     == Approx(6*9*Foam::sin(pi/6) + 12*side + pi)
    );
}


TEST_CASE("outline: hulls follow from their support function", "[tables][outline][serial]")
{
    Random random(3);
    for (label trial = 0; trial < 20; ++trial)
    {
        discs given({});
        given.centres.setSize(15);
        given.radii.setSize(15);
        forAll(given.radii, k)
        {
            const vector v(randomVector(random));
            given.centres[k] = vector2D(v.x(), v.y());
            given.radii[k] = trial % 2 ? mag(v.z()) : 0;
        }
        const label n = 20000;
        scalar perimeter = 0;
        scalar squares = 0;
        scalar last = 0;
        for (label k = 0; k <= n; ++k)
        {
            const vector2D e(Foam::cos(2*pi*k/n), Foam::sin(2*pi*k/n));
            scalar h = -GREAT;
            forAll(given.radii, i)
            {
                h = max(h, (given.centres[i] & e) + given.radii[i]);
            }
            if (k)
            {
                perimeter += 0.5*(h + last)*2*pi/n;
                squares += sqr(0.5*(h + last))*2*pi/n - sqr(h - last)*n/(2*pi);
            }
            last = h;
        }
        CHECK(given.hull().perimeter() == Approx(perimeter).epsilon(1e-6));
        CHECK(given.hull().area() == Approx(0.5*squares).epsilon(1e-3));
    }
}


TEST_CASE("outline: a sphere of triangles", "[tables][outline][serial]")
{
    Random random(11);
    const tensor R(randomRotation(random).R());
    scalar last = 0;
    for (const label n : {2, 3, 4})
    {
        const testMembrane m
        (
            "a { type neoHookean; shearModulus 1; }",
            "type icosphere; radius 2; subdivisions " + Foam::name(n) + ";"
        );
        const closedSurface& surface = m.type.surface();
        const pointField& x = m.type.centres();
        const outline o(outline::ofSurface(surface, x, R.x(), R.y()));
        const scalar error = 1 - o.circularity();
        CHECK(error > 0);
        CHECK(error < 0.012/pow(4.0, n - 2));
        if (last)
        {
            CHECK(error < 0.35*last);
        }
        last = error;
        CHECK(o.area() == Approx(4*pi).epsilon(0.03/pow(4.0, n - 2)));
        CHECK(o.inertiaRatio() == Approx(1).epsilon(0.02/pow(4.0, n - 2)));

        // It is convex
        List<vector2D> places(x.size());
        forAll(places, i)
        {
            places[i] = vector2D(R.x() & x[i], R.y() & x[i]);
        }
        checkSame(o, outline::hull(places, scalarField(x.size(), Zero)), 1e-6);

        // Seen along an axis of the mesh, where triangles are edge on
        const outline along
        (
            outline::ofSurface(surface, x, vector(1, 0, 0), vector(0, 1, 0))
        );
        CHECK(along.circularity() == Approx(1).epsilon(0.012/pow(4.0, n - 2)));
    }
}


TEST_CASE("outline: an ellipsoid in any frame is an ellipse", "[tables][outline][serial]")
{
    const testMembrane m
    (
        "a { type neoHookean; shearModulus 1; }",
        "type icosphere; radius 1; subdivisions 4;"
    );
    const vector axes(3, 2, 1.2);
    Random random(GENERATE(1, 2, 3));
    const tensor R(randomRotation(random).R());
    const tensor frame(randomRotation(random).R());
    const pointField x
    (
        (R & cmptMultiply(axes, m.type.centres())) + vector(100, -30, 7)
    );
    const outline o(outline::ofSurface(m.type.surface(), x, frame.x(), frame.y()));

    // Squares of the widths of the projection
    const symmTensor M
    (
        symm(R & tensor(symmTensor(sqr(axes.x()), 0, 0, sqr(axes.y()), 0, sqr(axes.z())))
      & R.T())
    );
    const scalar xx = frame.x() & (M & frame.x());
    const scalar xy = frame.x() & (M & frame.y());
    const scalar yy = frame.y() & (M & frame.y());
    const scalar apart = Foam::sqrt(sqr(0.5*(xx - yy)) + sqr(xy));
    const scalar a = Foam::sqrt(0.5*(xx + yy) + apart);
    const scalar b = Foam::sqrt(0.5*(xx + yy) - apart);
    CHECK(o.area() == Approx(pi*a*b).epsilon(3e-3));
    CHECK(o.inertiaRatio() == Approx(Foam::sqrt(xx/yy)).epsilon(2e-3));

    // Ramanujan's length, to 1e-5 or better here
    const scalar h = sqr((a - b)/(a + b));
    const scalar length = pi*(a + b)*(1 + 3*h/(10 + Foam::sqrt(4 - 3*h)));
    CHECK(o.perimeter() == Approx(length).epsilon(2e-3));
}


TEST_CASE("outline: a cube, edge on and along its diagonal", "[tables][outline][serial]")
{
    const triSurface s(cube(4, [](const point& x) { return x; }));
    const closedSurface surface(surfaceOf(s));
    Random random(8);
    const tensor R(GENERATE(false, true) ? randomRotation(random).R() : tensor(tensor::I));
    const pointField x((R & s.points()) + vector(5, 5, 5));

    const outline square(outline::ofSurface(surface, x, R & vector(1, 0, 0), R & vector(0, 1, 0)));
    CHECK(square.area() == Approx(4).epsilon(1e-6));
    CHECK(square.perimeter() == Approx(8).epsilon(1e-6));
    CHECK(square.inertiaRatio() == Approx(1).epsilon(1e-6));

    const scalar side = 2*Foam::sqrt(2.0/3.0);
    const vector e1(vector(1, -1, 0)/Foam::sqrt(2.0));
    const vector e2(vector(1, 1, -2)/Foam::sqrt(6.0));
    const outline hexagon(outline::ofSurface(surface, x, R & e1, R & e2));
    CHECK(hexagon.area() == Approx(1.5*Foam::sqrt(3.0)*sqr(side)).epsilon(1e-6));
    CHECK(hexagon.perimeter() == Approx(6*side).epsilon(1e-6));
}


TEST_CASE("outline: a surface that is not convex", "[tables][outline][serial]")
{
    // A bar that is bent to an arc, seen along its axis: two polygons
    const label n = 16;
    const scalar widest = 2;
    const triSurface s
    (
        cube
        (
            n,
            [&](const point& x)
            {
                const scalar angle = widest*x.x();
                return (3 + x.y())*point(Foam::cos(angle), Foam::sin(angle), 0)
                  + point(0, 0, x.z());
            }
        )
    );
    const closedSurface surface(surfaceOf(s));
    const pointField x(s.points());
    const outline o(outline::ofSurface(surface, x, vector(1, 0, 0), vector(0, 1, 0)));
    const scalar step = 2*widest/n;
    CHECK(o.area() == Approx(0.5*n*Foam::sin(step)*(16 - 4)).epsilon(1e-6));
    CHECK(o.perimeter() == Approx(2*n*Foam::sin(0.5*step)*(4 + 2) + 4).epsilon(1e-6));

    // From other sides, against the points of a grid that a triangle covers
    Random random(21);
    for (label trial = 0; trial < 4; ++trial)
    {
        const tensor R(randomRotation(random).R());
        const outline seen(outline::ofSurface(surface, x, R.x(), R.y()));
        const label m = 300;
        const scalar width = 12.0/m;
        label covered = 0;
        boolList inside(m*m, false);
        for (const triFace& t : surface.triangles())
        {
            FixedList<vector2D, 3> p;
            forAll(t, k)
            {
                p[k] =
                    (vector2D(R.x() & x[t[k]], R.y() & x[t[k]]) + vector2D(6, 6))/width;
            }
            const auto side = [&](const label k, const vector2D& at)
            {
                const vector2D e(p[(k + 1) % 3] - p[k]);
                const vector2D d(at - p[k]);
                return e.x()*d.y() - e.y()*d.x();
            };
            const vector2D low(min(min(p[0], p[1]), p[2]));
            const vector2D high(max(max(p[0], p[1]), p[2]));
            for (label i = label(low.x()); i <= label(high.x()); ++i)
            {
                for (label j = label(low.y()); j <= label(high.y()); ++j)
                {
                    const vector2D at(i + 0.5, j + 0.5);
                    const scalar a = side(0, at);
                    if (a*side(1, at) >= 0 && a*side(2, at) >= 0)
                    {
                        inside[i*m + j] = true;
                    }
                }
            }
        }
        for (const bool b : inside)
        {
            covered += b;
        }
        CHECK(seen.area() == Approx(covered*sqr(width)).epsilon(0.01));
    }
}
