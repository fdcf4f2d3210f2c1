/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "bondModel.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

autoPtr<bondModel> modelOf(const string& text)
{
    return selectModel<bondModel>
    (
        dictOf
        (
            text + " rigidities { normal 2; tangential 0.5; bending 3;"
            " torsional 4; }"
        )
    );
}

}


TEST_CASE("bond models: the axial law is the gradient of its energy", "[bonds][serial]")
{
    // NOTE: a new bond model needs a line here; its force and tangent are tested by this
    const string text = GENERATE
    (
        "type elastic;",
        "type timoshenko;",
        "type strainStiffening; stiffening 1.5;",
        "type cubicBond; cubic 2;"
    );
    const auto model(modelOf(text));
    const scalar length = 0.7;
    const scalar Kn = 3;
    const scalar h = 1e-7;

    // At rest: no force, no energy, stiffness K_n
    const auto rest(model->axial(0, length, Kn));
    CHECK(mag(rest.force) < 1e-14);
    CHECK(mag(rest.energy) < 1e-14);
    CHECK(rest.tangent == Approx(Kn).epsilon(1e-12));

    for (const scalar a : {-0.69, -0.4, -0.01, 0.02, 0.3, 0.8, 2.0, 10.0})
    {
        const auto plus(model->axial(a + h, length, Kn));
        const auto minus(model->axial(a - h, length, Kn));
        const auto here(model->axial(a, length, Kn));
        CHECK(here.force == Approx((plus.energy - minus.energy)/(2*h)).epsilon(1e-6));
        CHECK(here.tangent == Approx((plus.force - minus.force)/(2*h)).epsilon(1e-6));
        CHECK(here.energy > 0);
        CHECK(here.tangent > 0);
        if (text == "type elastic;" || text == "type timoshenko;")
        {
            CHECK(here.force == Approx(Kn*a).epsilon(1e-12));
        }
    }
}


TEST_CASE("bond models: moduli and rigidities say the same", "[bonds][serial]")
{
    const scalar pi = constant::mathematical::pi;
    const auto moduli
    (
        selectModel<bondModel>
        (
            dictOf
            (
                "type elastic; youngModulus 5; shearModulus 2; multipliers"
                " { normal 1; tangential 0.9; bending 0.8; torsional 0.7; }"
            )
        )
    );
    const scalar r = 0.3, l = 0.4;
    const auto k(moduli->stiffness(l, r));

    // Eq. 9, A = pi r^2, I = pi r^4/4, J = 2 I
    CHECK(k.normal == Approx(5*pi*r*r/l));
    CHECK(k.tangential == Approx(0.9*2*pi*r*r/l));
    CHECK(k.bending == Approx(0.8*5*pi*pow4(r)/4/l));
    CHECK(k.torsional == Approx(0.7*2*pi*pow4(r)/2/l));

    const auto given(modelOf("type elastic;")->stiffness(l, r));
    CHECK(given.normal == Approx(2/l));
    CHECK(given.bending == Approx(3/l));

    CHECK_THROWS
    (
        modelOf("type elastic; youngModulus 5; shearModulus 2;")
    );
}


TEST_CASE("bond models: shear of a beam in series with its bending", "[bonds][serial]")
{
    const scalar l = 0.4;
    const string text = GENERATE
    (
        "type timoshenko;",
        "type strainStiffening; stiffening 1.5; residualBending yes;"
    );
    const auto k(modelOf(text)->stiffness(l, 0.1));
    CHECK(1/k.tangential == Approx(l/0.5 + pow3(l)/(12*3)));
    CHECK(k.bending == Approx(3/l));

    const auto plain(modelOf("type strainStiffening; stiffening 1.5;"));
    CHECK(plain->stiffness(l, 0.1).tangential == Approx(0.5/l));
}


TEST_CASE("bond models: linearElastic is read as elastic", "[bonds][serial]")
{
    const bondedClump former("cell", cellDict("type none;", "type linearElastic;"));
    const bondedClump present("cell", cellDict("type none;", "type elastic;"));

    CHECK(former.bonds.law().type() == "elastic");
    CHECK
    (
        former.bonds.bonds()[0].stiffness.bending
     == present.bonds.bonds()[0].stiffness.bending
    );
}
