/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "testCatch.H"
#include "depletion.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

const scalar w0 = 3;

autoPtr<gapModel> law(const scalar range)
{
    return selectModel<gapModel>
    (
        dictOf("type depletion; energy 3; range " + Foam::name(range) + ';')
    );
}

}


TEST_CASE("depletion: forces are derivatives of the energies", "[contact][serial]")
{
    const auto model(law(0.5));
    const gapModel::medium between{0, 0.8, false};
    const gapModel::layer layer{0, 0.4, 0};
    const gapModel::radii R(0.7, 1.3);
    const scalar h = 1e-6;
    for (const scalar g : {-0.1, 0.01, 0.1, 0.25, 0.39, 0.5})
    {
        INFO(g);
        const auto up = model->step(g + h, 0, 1, R, between);
        const auto down = model->step(g - h, 0, 1, R, between);
        const auto here = model->step(g, 0, 1, R, between);
        CHECK(here.force == Approx(-(up.energy - down.energy)/(2*h)).margin(1e-6));
        CHECK(here.force <= 0);

        const auto p = model->surfacePressure(g, 0, 1, 1, layer);
        const auto more = model->surfacePressure(g + h, 0, 1, 1, layer);
        const auto less = model->surfacePressure(g - h, 0, 1, 1, layer);
        CHECK(p.value == Approx(-(more.energy - less.energy)/(2*h)).margin(1e-5));
        CHECK(p.stiffness == Approx(-(more.value - less.value)/(2*h)).margin(1e-3));

        // Derjaguin's approximation joins both
        const scalar radius = Foam::sqrt(0.7*1.3);
        CHECK
        (
            here.force
         == Approx(constant::mathematical::twoPi*radius*p.energy).margin(1e-9)
        );
    }
}


TEST_CASE("depletion: the energy per area does not depend on the range",
    "[contact][serial]")
{
    const scalar range = GENERATE(0.05, 0.3, 2);
    const auto model(law(range));
    const gapModel::layer layer{0, range, 0};
    CHECK(model->surfacePressure(0, 0, 1, 1, layer).energy == Approx(-w0));
    CHECK(model->surfacePressure(range, 0, 1, 1, layer).energy == 0);

    // Work of parting two surfaces, from the pressure
    scalar work = 0;
    const label n = 10000;
    for (label k = 0; k < n; ++k)
    {
        work -=
            model->surfacePressure(range*(k + 0.5)/n, 0, 1, 1, layer).value*range/n;
    }
    CHECK(work == Approx(w0));
}
