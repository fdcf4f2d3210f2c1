/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "compression.H"
#include "enclosedArea.H"
#include "mathematicalConstants.H"
#include "equilibrium.H"
#include "bondForces.H"
#include "sphereUnion.H"
#include "unionVolume.H"

using namespace Foam;

namespace
{

dictionary shellDict(const string& conservation)
{
    return dictOf
    (
        "shape { type shell; nSpheres 42; shellRadius 3e-6; sphereRadius 1e-6; }"
        "density 1000; massModel union; motion free;"
        "bondModel { type elastic; rigidities { normal 1e-10; tangential 3e-11;"
        " bending 1e-23; torsional 1e-23; } }"
        "dampingModel { type none; }" + conservation
    );
}

}


TEST_CASE("conservation: gradients, net force and torque", "[conservation][serial]")
{
    const clumpType type("cell", cellDict());

    const autoPtr<conservationModel> model
    (
        selectModel<conservationModel>
        (
            dictOf("type enclosedArea; areaModulus 1e-4;"),
            type.centres(),
            type.radii()
        )
    );

    Random random(6);
    clumpState s(type);
    disturb(type, s, 0.2, random);
    vectorField grad(type.size()), unused(type.size());
    CHECK(mag(model->deviation(type.centres(), unused)) < 1e-14*pow3(type.reach()));
    model->deviation(s.x, grad);

    const vector torque(sum(s.x ^ grad));
    CHECK(mag(sum(grad)) < 1e-13*sum(mag(grad)));
    CHECK(mag(torque) < 1e-13*sum(mag(grad))*type.reach());

    const scalar h = 1e-6*type.reach();
    for (const label i : {0, 1, 7})
    {
        for (label c = 0; c < 3; ++c)
        {
            pointField plus(s.x), minus(s.x);
            plus[i][c] += h;
            minus[i][c] -= h;
            const scalar slope =
                (model->deviation(plus, unused) - model->deviation(minus, unused))
               /(2*h);
            CHECK(mag(slope - grad[i][c]) < 1e-6*max(mag(grad)));
        }
    }
}


TEST_CASE("conservation: the volume of the union, folded or not", "[conservation][serial]")
{
    const clumpType type("cell", cellDict());
    const conservationModels::unionVolume model
    (
        dictOf("volumeModulus 1;"), type.centres(), type.radii()
    );
    const scalar V0 = 1/model.stiffness();
    CHECK(V0/type.volume() == Approx(1).epsilon(0.02));

    // Flattened until the strands overlap, and turned
    const scalar part = GENERATE(0.9, 0.6, 0.35);
    pointField x(type.centres());
    for (point& p : x)
    {
        p.x() *= 2 - part;
        p.y() *= part;
    }
    vectorField grad(x.size()), turnedGrad(x.size());
    const scalar V = V0 + model.deviation(x, grad);
    CHECK
    (
        V/V0
     == Approx
        (
            sphereUnion::volume(x, type.radii())/type.volume()
        ).epsilon(0.01)
    );

    const tensor R(rotation(vector(0.3, -1.1, 0.7)).R());
    const scalar turned = V0 + model.deviation(R & x, turnedGrad);
    CHECK(turned/V == Approx(1).epsilon(1e-10));
    CHECK(max(mag(turnedGrad - (R & grad))) < 1e-10*max(mag(grad)));

    // Neither sum nor torque
    const vector torque(sum(x ^ grad));
    CHECK(mag(sum(grad)) < 1e-13*sum(mag(grad)));
    CHECK(mag(torque) < 1e-8*sum(mag(grad))*type.reach());

    // The slope along any displacement, to the rotation of the frame that the gradient leaves out
    Random random(3);
    vectorField step(x.size());
    for (vector& d : step)
    {
        d = 1e-3*type.reach()*randomVector(random);
    }
    vectorField unused(x.size());
    const scalar slope =
        model.deviation(x + step, unused) - model.deviation(x - step, unused);
    const scalar largest =
        Foam::sqrt(sum(magSqr(grad))*sum(magSqr(step)));
    CHECK(mag(0.5*slope - sum(grad & step)) < 0.05*largest);
}


TEST_CASE("conservation: the volume is continuous where spheres meet", "[conservation][serial]")
{
    // A large sphere that moves through the gap of two others: its gradient times its path is
    // the change of volume in every small step
    const scalarField radii({1, 1, 1.3});
    const label n = 2000;
    const vector step(0, 3.2e-3, 0.4e-3);
    pointField x({point(-1.2, 0, 0), point(1.2, 0.1, 0), point(0, -3.2, 0.2)});
    vectorField grad(3), before(3);
    const scalar first = sphereUnion::smoothVolume(x, radii, before);
    scalar V = first;
    scalar range = 0, worst = 0;
    for (label k = 0; k < n; ++k)
    {
        x[2] += step;
        const scalar next = sphereUnion::smoothVolume(x, radii, grad);
        worst = max(worst, mag(next - V - 0.5*((grad[2] + before[2]) & step)));
        range = max(range, mag(next - first));
        V = next;
        before = grad;
    }
    CHECK(range > 1);
    CHECK(worst < 1e-4*range);

    // Far apart the union is the sum
    x[2].y() = 10;
    x[1].x() = 2;
    CHECK
    (
        sphereUnion::smoothVolume(x, radii, grad)
     == Approx(4*constant::mathematical::pi/3*sum(pow3(radii))).epsilon(1e-12)
    );
    CHECK(max(mag(grad)) == 0);
}


TEST_CASE("conservation: a squeezed ring keeps the volume of its union", "[conservation][serial]")
{
    // Pulled apart with force enough to lay its strands into each other
    const auto change = [](const string& conservation)
    {
        dictionary dict(cellDict());
        if (conservation.size())
        {
            dict.set("conservationModel", dictOf(conservation));
        }
        const bondedClump clump("cell", dict);
        const clumpType& type = clump.type;
        clumpState s(type);
        REQUIRE
        (
            equilibrium().find
            (
                clump.bonds,
                equilibrium::stretch(type, vector(1.5e-10, 0, 0)),
                s
            )
        );
        return mag
        (
            sphereUnion::volume(s.x, type.radii())/type.volume() - 1
        );
    };
    const scalar loose = change("");
    const scalar held = change("type unionVolume; volumeModulus 1e4;");
    CHECK(loose > 0.02);
    CHECK(held < 0.25*loose);
}


TEST_CASE("conservation: compression is resisted, extension is not", "[conservation][serial]")
{
    const label n = GENERATE(8, 10, 16);
    const clumpType type
    (
        "cell",
        dictOf
        (
            "shape { type ring; nSpheres " + Foam::name(n) + "; diameter 7.82e-6;"
            " volume 94e-18; } density 1000; massModel union; motion free;"
            "bondModel { type elastic; rigidities { normal 1e-10; tangential 3e-11;"
            " bending 1e-23; torsional 1e-23; } } dampingModel { type none; }"
        )
    );
    const conservationModels::compression model
    (
        dictOf("volumeModulus 1;"), type.centres(), type.radii()
    );
    vectorField grad(n), unused(n);

    // Smaller in its plane, narrower, bent out of its plane, as far as the model lets it: the
    // volume of the union
    const auto shape = GENERATE
    (
        std::array<scalar, 3>{{1, 1, 0}},
        std::array<scalar, 3>{{0.96, 0.96, 0}},
        std::array<scalar, 3>{{1.05, 0.85, 0}},
        std::array<scalar, 3>{{0.98, 0.93, 0.3}},
        std::array<scalar, 3>{{1.3, 0.9, 0}}
    );
    pointField x(type.centres());
    for (point& p : x)
    {
        const scalar bend = shape[2]*sqr(p.x())/type.reach();
        p = point(shape[0]*p.x(), shape[1]*p.y(), p.z() + bend);
    }
    const scalar V = model.volume(x, grad);
    CHECK
    (
        V/type.volume()
     == Approx(sphereUnion::volume(x, type.radii())/type.volume()).epsilon(0.01)
    );

    // Neither sum nor torque; the slope along a displacement
    const vector torque(sum(x ^ grad));
    CHECK(mag(sum(grad)) < 1e-13*sum(mag(grad)));
    CHECK(mag(torque) < 1e-13*sum(mag(grad))*type.reach());

    Random random(4);
    vectorField step(n);
    for (vector& d : step)
    {
        d = 1e-6*type.reach()*randomVector(random);
    }
    const scalar slope =
        0.5*(model.volume(x + step, unused) - model.volume(x - step, unused));
    CHECK
    (
        mag(slope - sum(grad & step))
      < 1e-6*Foam::sqrt(sum(magSqr(grad))*sum(magSqr(step)))
    );

    // One side only
    const scalar V0 = 1/model.stiffness();
    const scalar Q = model.deviation(x, unused);
    CHECK(Q == Approx(min(V - 0.999*V0, 0)).margin(1e-12*V0));
    CHECK((Q < 0 || max(mag(unused)) == 0));
}


TEST_CASE("conservation: compression refuses what pairs cannot measure", "[conservation][serial]")
{
    // Triangles of spheres: three at a time overlap
    const string shape("shape { sphereRadius 1.5e-6; }");
    CHECK_NOTHROW(bondedClump("shell", shellDict(shape)));
    CHECK_THROWS
    (
        bondedClump
        (
            "shell",
            shellDict
            (
                shape
              + "conservationModel { type compression; volumeModulus 1000; }"
            )
        )
    );
}


TEST_CASE("conservation: a ring that is pressed together pushes back", "[conservation][serial]")
{
    // Four per cent smaller: the force of the model, outwards, against the slope of its energy
    const auto forces = [](const string& conservation, scalar& energy)
    {
        dictionary dict(cellDict());
        dict.set("shape", dictOf("type ring; nSpheres 10; diameter 7.82e-6; volume 94e-18;"));
        dict.set("conservationModel", dictOf(conservation));
        const bondedClump clump("cell", dict);
        clumpState s(clump.type);
        s.x *= 0.96;
        vectorField F(clump.type.size()), T(clump.type.size());
        energy = bondForces(clump.bonds, s).explicitForces(s, F, T);
        return scalarField((F & s.x)/mag(s.x));
    };
    scalar loose = 0, held = 0;
    const scalarField ofBonds(forces("type none;", loose));
    const scalarField all
    (
        forces("type compression; volumeModulus 1e4;", held)
    );
    const scalar V0 = 94e-18;

    // E = k (V - V1)^2/(2 V0): a pressure of some 3 % of the modulus, which acts on the
    // discs in which neighbours meet
    const scalar Q = Foam::sqrt(2*(held - loose)*V0/1e4);
    CHECK(Q/V0 == Approx(0.033).margin(0.01));
    const scalar r2 = sqr(1.4746e-6) - sqr(0.5*0.96*2.4355e-6*0.61803);
    const scalar disc = constant::mathematical::pi*r2;
    const scalar outwards = 1e4*Q/V0*disc*2*0.30902;
    for (const scalar f : scalarField(all - ofBonds))
    {
        CHECK(f == Approx(outwards).epsilon(0.03));
    }
}
