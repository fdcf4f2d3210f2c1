/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "gapForces.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

const gapModel::medium plasma{1.2e-3, 0.7e-6, false};
const scalar R = 0.7e-6;
const scalar unit = 6*constant::mathematical::pi*1.2e-3*sqr(R);

autoPtr<gapModel> film(const string& more = "")
{
    return selectModel<gapModel>
    (
        dictOf("type squeezeFilm; roughness 1e-8;" + more)
    );
}

}


TEST_CASE("gap models: a step has a potential", "[gap][serial]")
{
    // Force and stiffness are its derivatives
    const auto model(film());
    const scalar h = 1e-13;

    for (const scalar start : {-2e-8, 3e-9, 2e-8, 1.5e-7, 5e-7, 9e-7})
    {
        for (scalar gap = -4.03e-8; gap < 9e-7; gap += 0.77e-8)
        {
            const auto w = model->step(gap, start, 1e-4, R, plasma);
            const auto more = model->step(gap + h, start, 1e-4, R, plasma);
            const auto less = model->step(gap - h, start, 1e-4, R, plasma);
            INFO(start << ' ' << gap);
            const scalar size = unit/1e-4;
            CHECK
            (
                -w.force
             == Approx((more.energy - less.energy)/(2*h))
                .epsilon(1e-4).margin(1e-7*size)
            );
            CHECK
            (
                w.stiffness
             == Approx(max((less.force - more.force)/(2*h), scalar(0)))
                .epsilon(1e-3).margin(1e-6*size)
            );
        }
    }
}


TEST_CASE("squeeze film: resistance of lubrication theory", "[gap][serial]")
{
    const auto model(film());
    const scalar dt = 1e-6, limit = 0.85*plasma.cellWidth;
    CHECK(model->range(plasma.cellWidth, false) == Approx(limit));
    CHECK(model->range(plasma.cellWidth, true) == Approx(1.3*plasma.cellWidth));

    // 1/g less what the mesh resolves, no more below the roughness
    const auto c = [&](const scalar g)
    {
        return model->step(g, g, dt, R, plasma).stiffness*dt;
    };
    const auto lacking = [&](const scalar g) { return 1 - Foam::sqrt(g/limit); };
    CHECK(c(2e-8) == Approx(unit/2e-8*lacking(2e-8)));
    CHECK(c(0.25*limit) == Approx(2*unit/limit));
    CHECK(c(1e-9) == Approx(unit*1e8*lacking(1e-8)));
    CHECK(c(-1e-7) == c(1e-9));
    CHECK(c(1.01*limit) == 0);

    // Two spheres against a sphere and a wall
    const scalar r = 2*R;
    CHECK
    (
        model->step(1e-7, 1.01e-7, dt, r, plasma).force
     == Approx(4*model->step(1e-7, 1.01e-7, dt, R, plasma).force)
    );

    // Equal to Simeonov and Calantoni's form for unequal spheres
    const scalar R1 = 1e-6, k = 3, g = 3e-8, speed = 1e-4, small = 1e-10;
    const scalar e = g/R1, ec = limit/R1;
    CHECK
    (
        model->step
        (
            g - speed*small, g, small,
            contactModel::reduced(R1, k*R1), plasma
        ).force
     == Approx
        (
            6*constant::mathematical::pi*plasma.viscosity*R1
           *sqr(k/(1 + k))/e*(1 - Foam::sqrt(e/ec))*speed
        ).epsilon(1e-5)
    );
}


TEST_CASE("squeeze film: resistance at curved walls", "[gap][serial]")
{
    const auto model(film());
    const scalar dt = 1e-6, g = 2e-8, limit = 0.85*plasma.cellWidth;

    // Over that of a sphere at a plane
    const auto relative = [&](const gapModel::radii& radii)
    {
        return
            model->step(g, g, dt, radii, plasma).stiffness*dt
           /(unit/g*(1 - Foam::sqrt(g/limit)));
    };
    const auto atWall = [&](const scalar k1, const scalar k2)
    {
        const vector e1(0.6, 0.8, 0), e2(0, 0, 1);
        return relative
        (
            gapModel::radii(R, (k1*sqr(e1) + k2*sqr(e2))/R)
        );
    };
    CHECK(atWall(0, 0) == Approx(1));
    CHECK(atWall(1, 1) == Approx(0.25));
    CHECK(relative(contactModel::reduced(R, 3*R)) == Approx(9.0/16));

    // A sphere held by the inside of a larger one
    CHECK(atWall(-0.5, -0.5) == Approx(4));

    // Outside a cylinder and inside a tube of twice the radius; crossed cylinders of
    // equal radii are a sphere and a plane
    CHECK(atWall(0.5, 0) == Approx(1/(1.25*Foam::sqrt(1.5))));
    CHECK(atWall(-0.5, 0) == Approx(1/(0.75*Foam::sqrt(0.5))));
    CHECK(atWall(0, 0.5) == Approx(atWall(0.5, 0)));
    CHECK(atWall(3, 0) == Approx(relative({0.25*R, R})));

    // No more where the wall fits the sphere
    CHECK(atWall(-1, 0) == Approx(2/(Foam::sqrt(0.1)*1.1)));
    CHECK(atWall(-5, 0) == Approx(atWall(-0.9, 0)));

    // The pressure A/h^2 solves Reynolds' equation, and its integral over x and y is
    // the force. Lengths over R, the viscosity and the speed of approach are 1
    for (const scalar R2 : {0.2, 0.65, 1.0, 4.0})
    {
        const scalar gap = 0.05, A = 6*R2/(1 + R2), d = 1e-4;
        const auto h = [&](const scalar x, const scalar y)
        {
            return gap + 0.5*sqr(x) + 0.5*sqr(y)/R2;
        };
        const auto p = [&](const scalar x, const scalar y)
        {
            return A/sqr(h(x, y));
        };
        for (const point& at : {point(0, 0, 0), point(0.2, 0.1, 0), point(0.1, -0.4, 0)})
        {
            scalar divergence = 0;
            for (const vector& to : {vector(d, 0, 0), vector(0, d, 0)})
            {
                for (const scalar side : {1, -1})
                {
                    const point end(at + side*to), face(at + 0.5*side*to);
                    divergence +=
                        pow3(h(face.x(), face.y()))
                       *(p(end.x(), end.y()) - p(at.x(), at.y()))/sqr(d);
                }
            }
            CHECK(divergence == Approx(-12).epsilon(1e-4));
        }

        // x = s cos(a), y = s sin(a) and s = tan(q)
        scalar force = 0;
        const label n = 400;
        for (label i = 0; i < n; ++i)
        {
            const scalar q = constant::mathematical::piByTwo*(i + 0.5)/n;
            const scalar s = Foam::tan(q);
            for (label k = 0; k < n; ++k)
            {
                const scalar a = constant::mathematical::twoPi*k/n;
                force +=
                    p(s*Foam::cos(a), s*Foam::sin(a))*s/sqr(Foam::cos(q))
                   *constant::mathematical::piByTwo*constant::mathematical::twoPi
                   /sqr(scalar(n));
            }
        }
        INFO(R2);
        CHECK
        (
            relative({R, R2*R})
         == Approx(force*gap/(6*constant::mathematical::pi)).epsilon(1e-3)
        );
    }
}


TEST_CASE("squeeze film: dissipates, and knows no length of a step", "[gap][serial]")
{
    const auto model(film());
    const scalar gaps[] = {-3e-8, 5e-9, 1.5e-8, 1e-7, 5e-7, 8e-7};
    for (const scalar from : gaps)
    {
        for (const scalar to : gaps)
        {
            const auto w = model->step(to, from, 1e-3, R, plasma);
            INFO(from << ' ' << to);
            CHECK(w.energy >= 0);
            CHECK(w.stiffness >= 0);
            CHECK(w.force*(to - from) <= 0);

            // The impulse of a way is that of its parts, forth and back none
            for (const scalar middle : gaps)
            {
                const scalar parts =
                    2e-3*model->step(middle, from, 2e-3, R, plasma).force
                  + 5e-4*model->step(to, middle, 5e-4, R, plasma).force;
                CHECK
                (
                    1e-3*w.force == Approx(parts).margin(1e-12*unit)
                );
            }
        }
    }
}


namespace
{

//- Two types of beads
PtrList<clumpType> beads()
{
    PtrList<clumpType> types;
    for (const word name : {"a", "b"})
    {
        types.append
        (
            new clumpType
            (
                name,
                dictOf("density 1; shape { type chain; nSpheres 1; sphereRadius 1e-6; }")
            )
        );
    }
    return types;
}

}


TEST_CASE("gap forces: only what is on acts", "[gap][serial]")
{
    const PtrList<clumpType> types(beads());
    const polyBoundaryMesh& patches = testMesh().boundaryMesh();
    gapForces forces
    (
        dictOf("lubrication { type squeezeFilm; roughness 1e-8; }"), types, patches
    );
    forces.setViscosity(1e-3);
    const auto force = [&]()
    {
        return forces.step(1e-7, 2e-7, 1e-4, R, {0, 0, true, 0.5e-6}).force;
    };
    CHECK(!forces.active());
    CHECK(force() == 0);
    CHECK(forces.range(0.5e-6, true) == 0);

    forces.setFilm(true);
    CHECK(forces.active());
    CHECK(force() > 0);
    CHECK(forces.range(0.5e-6, true) == Approx(0.65e-6));

    gapForces none(dictionary(), types, patches);
    CHECK(!none.film());
    none.setFilm(true);
    CHECK(!none.active());
}


TEST_CASE("gap forces: laws act between the types and at the walls that they name",
    "[gap][serial]")
{
    const PtrList<clumpType> types(beads());
    const polyBoundaryMesh& patches = testMesh().boundaryMesh();
    const label walls = patches.findPatchID("walls"), inlet = patches.findPatchID("inlet");
    const gapForces forces
    (
        dictOf
        (
            "surfaceForces"
            "{"
            "    all    { type depletion; energy 1e-6; }"
            "    mixed  { type depletion; energy 2e-6; types (a b); }"
            "    onWall { type depletion; energy 4e-6; types (b); patches (\"w.*\"); }"
            "}"
        ),
        types, patches
    );
    CHECK(forces.active());
    CHECK(forces.hasLaws());
    CHECK(forces.lawRange(2e-6) == Approx(1e-6));

    // In units of 2 pi R and 1e-6 J/m2, where surfaces touch
    const auto force = [&](const label first, const label second, const bool atWall)
    {
        const gapForces::place where{first, second, atWall, 2e-6};
        const auto w(forces.step(0, 0, 1, 1e-6, where));
        const auto p(forces.surfacePressure(0, 0, 1, 1e-6, where));
        CHECK(w.force == Approx(2*constant::mathematical::pi*1e-6*p.energy).margin(1e-20));
        return -p.energy/1e-6;
    };
    CHECK(force(0, 0, false) == Approx(1));
    CHECK(force(1, 1, false) == Approx(1));
    CHECK(force(0, 1, false) == Approx(3));
    CHECK(force(1, 0, false) == Approx(3));
    CHECK(force(0, walls, true) == 0);
    CHECK(force(1, walls, true) == Approx(4));
    CHECK(force(1, inlet, true) == 0);
}
