/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clump/closedSurfaces.H"
#include "testCase.H"
#include "bodyMoments.H"
#include "clumpState.H"
#include "clumpType.H"
#include "massDistribution.H"
#include "mathematicalConstants.H"
#include "OSspecific.H"
#include "sphereUnion.H"

using namespace Foam;

namespace
{

using constant::mathematical::pi;

clumpType typeOf(const string& shape, const string& entries = "density 1000;")
{
    return clumpType("a", dictOf("shape { " + shape + " } " + entries));
}

//- Of a clump at rest, about its centre of mass
tensor inertiaOf(const clumpType& type)
{
    return clumpState(type).inertia(type);
}

//- Largest component of the difference, over the largest moment
scalar deviation(const tensor& a, const tensor& b)
{
    const tensor d(a - b);
    scalar worst = 0;
    for (direction k = 0; k < tensor::nComponents; ++k)
    {
        worst = max(worst, mag(d[k]));
    }
    return worst/tr(b);
}

}


TEST_CASE("inertia: bodies from surfaces", "[inertia][serial][sizes]")
{
    // A cube, a bar and a plate of 1000 kg/m3, sides in mm; and a tetrahedron, whose
    // principal axes are not those of the shape
    const vector sides[] = {{2, 2, 2}, {8, 2, 2}, {8, 8, 2}};
    const fileName file(getEnv("FOAM_CASE")/"body.stl");
    for (const vector& side : sides)
    {
        cube(2, [&](const point& x) { return cmptMultiply(0.5*side, x); }).write(file);
        const clumpType type
        (
            typeOf("type fromSurface; file \"body.stl\"; scale 1e-3; error 0.1;")
        );
        const scalar m = 1e-6*cmptProduct(side);
        const vector squares(cmptMultiply(side, side));
        const tensor exact
        (
            1e-6*m/12*(tr(diagTensor(squares.x(), squares.y(), squares.z()))*tensor::I
          - tensor(squares.x(), 0, 0, 0, squares.y(), 0, 0, 0, squares.z()))
        );
        INFO("bar of " << side.x() << " x " << side.y() << " x " << side.z() << " mm");
        CHECK(type.mass() == Approx(m).epsilon(1e-9));
        CHECK(type.volume() == Approx(m/1000).epsilon(1e-9));
        CHECK(deviation(inertiaOf(type), exact) < 1e-5);
        CHECK(min(type.masses()) > 0);
        CHECK(min(type.inertias()) > 0);

        // So has what lies inside of it
        CHECK(sum(type.volumes()) == Approx(type.volume()).epsilon(1e-12));
        CHECK(mag(sum(type.volumes()*type.centres())) < 1e-9*m*1e-3);
        CHECK
        (
            sum(1000*type.volumeInertias())
         == Approx(sum(type.inertias())).epsilon(1e-12)
        );
    }
}


TEST_CASE("inertia: moments of a skewed body", "[inertia][serial]")
{
    // A shear of a cube keeps its volume; S = F S_0 F^T
    const tensor F(1, 0.5, 0.2, 0, 1, -0.3, 0, 0, 1);
    const point away(3, 1, 2);
    const bodyMoments body(cube(2, [&](const point& x) { return away + (F & x); }));
    CHECK(body.volume == Approx(8).epsilon(1e-12));
    CHECK(mag(body.centre - away) < 1e-12);
    const symmTensor exact(symm(8.0/3*(F & F.T())));
    CHECK(mag(body.second - exact) < 1e-9);
}


TEST_CASE("inertia: unions of spheres", "[inertia][serial]")
{
    // Two caps that overlap against the integrals of bodies of revolution
    const scalar r = 1, h = 0.5;
    const bodyMoments body
    (
        sphereUnion::moments(pointField({{-h, 0, 0}, {h, 0, 0}}), scalarList({r, r}))
    );
    const label n = 200000;
    scalar V = 0, along = 0, across = 0;
    for (label k = 0; k < n; ++k)
    {
        const scalar x = (k + 0.5)*(r + h)/n;
        const scalar A = pi*(sqr(r) - sqr(x - h));
        V += 2*A*(r + h)/n;
        along += 2*A*sqr(x)*(r + h)/n;
        across += 2*sqr(A)/(4*pi)*(r + h)/n;
    }
    CHECK(body.volume == Approx(V).epsilon(1e-4));
    CHECK(body.second.xx() == Approx(along).epsilon(2e-4));
    CHECK(body.second.yy() == Approx(across).epsilon(2e-4));
    CHECK(body.second.zz() == Approx(across).epsilon(2e-4));

    // Spheres that do not overlap have their own moments, m and 2/5 m r^2
    const clumpType pair
    (
        typeOf("type chain; nSpheres 2; spacing 3e-6; sphereRadius 1e-6;")
    );
    CHECK(pair.masses()[0] == Approx(pair.masses()[1]).epsilon(1e-9));
    CHECK
    (
        pair.inertias()[0]
     == Approx(0.4*pair.masses()[0]*1e-12).epsilon(1e-9)
    );

    // A chain that overlaps has those of the union, and all of its mass
    const clumpType chain
    (
        typeOf("type chain; nSpheres 6; spacing 1e-6; sphereRadius 1e-6;")
    );
    const bodyMoments whole(sphereUnion::moments(chain.centres(), chain.radii()));
    CHECK(deviation(inertiaOf(chain), 1000*tensor(whole.inertia())) < 1e-4);
    CHECK(chain.mass() == Approx(1000*chain.volume()).epsilon(1e-12));
}


TEST_CASE("inertia: red cells and full spheres keep shares of r^3", "[inertia][serial]")
{
    const string shape("type ring; nSpheres 10; ringRadius 2.5e-6; sphereRadius 1.4e-6;");
    for
    (
        const string& entries :
        {
            string("density 1098; nominalVolume 94e-18;"),
            string("density 1098; massModel fullSpheres;")
        }
    )
    {
        const clumpType type(typeOf(shape, entries));
        CHECK(max(type.masses()) == min(type.masses()));
        CHECK
        (
            type.inertias()[3]
         == Approx(0.4*type.masses()[3]*sqr(1.4e-6)).epsilon(1e-12)
        );
    }
}


TEST_CASE("inertia: given as entries", "[inertia][serial]")
{
    const string bar("type chain; nSpheres 5; spacing 2e-3; sphereRadius 1e-3;");
    const clumpType heavy(typeOf(bar, "mass 1e-4;"));
    CHECK(heavy.mass() == Approx(1e-4).epsilon(1e-12));
    CHECK
    (
        deviation
        (
            inertiaOf(heavy),
            1e-4/typeOf(bar).mass()*inertiaOf(typeOf(bar))
        ) < 1e-9
    );

    const clumpType given(typeOf(bar, "mass 1e-4; inertia (4e-11 1e-9 1e-9);"));
    CHECK
    (
        deviation(inertiaOf(given), tensor(4e-11, 0, 0, 0, 1e-9, 0, 0, 0, 1e-9)) < 1e-5
    );

    // The displaced fluid is where it was
    CHECK(max(mag(given.volumes() - typeOf(bar).volumes())) < 1e-9*given.volume());

    const clumpType six(typeOf(bar, "mass 1e-4; inertia (4e-11 0 0 1e-9 0 1e-9);"));
    CHECK(deviation(inertiaOf(six), inertiaOf(given)) < 1e-12);

    for
    (
        const string& wrong :
        {
            string("density 1000; mass 1e-4;"),
            string("mass 1e-4; massModel union;"),
            string("mass 1e-4; nominalVolume 1e-8;"),
            string("mass -1;"),
            string("mass 1e-4; inertia (1e-9 1e-9);"),
            string("mass 1e-4; inertia (1e-9 -1e-9 1e-9);"),
            string("mass 1e-4; inertia (1e-11 1e-9 2e-9);"),
            string("mass 1e-4; inertia (0 0 0);"),
            string("mass 1e-4; inertia (1e-9 1e-9 1.5e-9);")
        }
    )
    {
        INFO(wrong);
        CHECK_THROWS(typeOf(bar, wrong));
    }
}


TEST_CASE("inertia: the volume of loads is that of the weight", "[inertia][serial]")
{
    const string shape("type ring; nSpheres 10; ringRadius 2.5e-6; sphereRadius 1.4e-6;");
    const clumpType cell(typeOf(shape, "density 1098; nominalVolume 94e-18;"));
    CHECK(sum(cell.nominalVolumes()) == Approx(94e-18).epsilon(1e-12));
    CHECK
    (
        sum(cell.excessMasses(1000, cell.centres()))
     == Approx(98*sum(cell.nominalVolumes())).epsilon(1e-12)
    );
    const clumpType plain(typeOf(shape));
    CHECK(sum(plain.nominalVolumes()) == Approx(plain.volume()).epsilon(1e-12));
}
