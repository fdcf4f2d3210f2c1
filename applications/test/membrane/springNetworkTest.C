/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "mathematicalConstants.H"
#include "triangleElasticity.H"

using namespace Foam;

namespace
{

//- Two hexagons of six equilateral triangles each, one on the other, joined at the rim
struct doubleSheet
{
    pointField x0;
    autoPtr<closedSurface> surface;

    doubleSheet()
    {
        x0 = pointField(8, Zero);
        List<triFace> triangles(12);
        for (label k = 0; k < 6; ++k)
        {
            const scalar angle = k*constant::mathematical::pi/3;
            x0[k] = point(Foam::cos(angle), Foam::sin(angle), 0);
            triangles[k] = triFace(6, k, (k + 1) % 6);
            triangles[6 + k] = triFace(7, (k + 1) % 6, k);
        }
        x0[6].z() = 1e-5;
        x0[7].z() = -1e-5;
        surface.reset(new closedSurface(x0, triangles, dictionary::null));
    }

    //- Energy per area at rest of a model, strained in the plane
    scalar W(const string& model, const tensor& strain) const
    {
        const auto law = selectModel<membraneModel>(dictOf(model), surface(), x0);
        vectorField unused(x0.size(), Zero);
        return
            law->add(pointField(x0 + (strain & x0)), unused, nullptr)
           /surface().area(x0);
    }
};

}


TEST_CASE("springNetwork: moduli of a sheet of equilateral triangles",
    "[membrane][serial]")
{
    const doubleSheet sheet;
    const scalar Gs = 3;
    const scalar e = 1e-4;
    const tensor shear(e, 0, 0, 0, -e, 0, 0, 0, 0);
    const tensor oblique(0, e, 0, e, 0, 0, 0, 0, 0);
    const tensor dilation(e, 0, 0, 0, e, 0, 0, 0, 0);
    for (const string stretch : {"", "largestStretch 1.3;", "largestStretch 5;"})
    {
        INFO(stretch);
        const string model("type springNetwork; shearModulus 3; " + stretch);

        // 2 Gs e^2 in every direction, and 2 K e^2 with K = 2 Gs
        CHECK(sheet.W(model, shear) == Approx(2*Gs*sqr(e)).epsilon(1e-3));
        CHECK(sheet.W(model, oblique) == Approx(2*Gs*sqr(e)).epsilon(1e-3));
        CHECK(sheet.W(model, dilation) == Approx(4*Gs*sqr(e)).epsilon(2e-3));
    }

    // A sheet that keeps its area, on its own against shear it does nothing
    const string area("type triangleArea; areaModulus 7;");
    const scalar J = sqr(1 + e);
    CHECK(sheet.W(area, dilation) == Approx(0.5*7*sqr(J - 1)).epsilon(1e-6));
    CHECK(sheet.W(area, oblique) < 1e-6*sheet.W(area, dilation));
}


TEST_CASE("springNetwork: springs stiffen up to their largest length",
    "[membrane][serial]")
{
    const doubleSheet sheet;
    const auto tension = [&](const scalar s)
    {
        // W = 2 sqrt(3) psi k for three springs to an area sqrt(3)/4 of a triangle, each
        // shared by two
        const string model("type springNetwork; shearModulus 1;");
        const auto W = [&](const scalar r)
        {
            return sheet.W(model, tensor(r - 1, 0, 0, 0, r - 1, 0, 0, 0, 0));
        };
        const scalar h = 1e-5;
        return (W(s + h) - W(s - h))/(2*h);
    };

    // The chain with the largest length 2.2 and a repulsion as 1/length^2, both written
    // down by their definitions. The stiffness at rest is that of Gs: 8 per length
    const scalar m = 2.2;
    const auto chain = [&](const scalar s)
    {
        return 1/(4*sqr(1 - s/m)) - 0.25 + s/m;
    };
    const auto force = [&](const scalar s) { return chain(s) - chain(1)/sqr(s); };
    const scalar h = 1e-5;
    const scalar atRest = (force(1 + h) - force(1 - h))/(2*h);
    for (const scalar s : {0.5, 0.8, 1.4, 1.9, 2.05})
    {
        INFO(s);
        CHECK(tension(s) == Approx(8*force(s)/atRest).epsilon(1e-5));
    }

    // Linear beyond 19/20 of the largest length
    const scalar slope = tension(2.4) - tension(2.3);
    CHECK(tension(5.4) - tension(5.3) == Approx(slope).epsilon(1e-4));
    CHECK(slope > 0.1*100*8);
}


TEST_CASE("springNetwork: as a continuum of the same moduli on an uneven surface",
    "[membrane][serial]")
{
    // A sphere that becomes a spheroid; Skalak's law with C = 1/2 has K = 2 Gs. The
    // triangles of an icosphere differ by a tenth in their areas and angles
    const string shape("type icosphere; radius 1; subdivisions 3;");
    const testMembrane springs("a { type springNetwork; shearModulus 2; }", shape);
    const testMembrane skalak
    (
        "a { type skalak; shearModulus 2; areaRatio 0.5; }", shape
    );
    const auto energy = [](const testMembrane& m, const direction d)
    {
        pointField x(m.type.centres());
        for (point& p : x)
        {
            p[d] *= 1.001;
            p[(d + 1) % 3] /= 1.001;
        }
        vectorField unused(x.size(), Zero);
        return m.mechanics.add(x, unused);
    };
    for (const direction d : {0, 1, 2})
    {
        CHECK(energy(springs, d) == Approx(energy(skalak, d)).epsilon(0.01));
    }
}


TEST_CASE("springNetwork: a largest stretch near one is refused",
    "[membrane][serial]")
{
    CHECK_THROWS
    (
        testMembrane("a { type springNetwork; shearModulus 2; largestStretch 1.05; }")
    );
}
