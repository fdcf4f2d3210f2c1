/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "boundModel.H"
#include "testCase.H"

using namespace Foam;

TEST_CASE("solutes: Hill's curve and the root of free and bound", "[solutes]")
{
    const scalar n = GENERATE(1.0, 2.7, 6.0);
    const scalar h = 0.0358;
    OStringStream os;
    os << "type Hill; capacity 20.3; halfConcentration " << h << "; exponent " << n << ";";
    const autoPtr<boundModel> model(selectModel<boundModel>(dictOf(os.str())));
    CHECK(model->bound(0) == 0);
    CHECK(model->bound(h) == Approx(10.15));
    CHECK(model->bound(3*h) == Approx(20.3*std::pow(3, n)/(std::pow(3, n) + 1)));
    CHECK(model->bound(1e30) == Approx(20.3));
    CHECK(model->capacity(0) == Approx(n > 1 ? 0 : 20.3/h));
    for (const scalar c : {1e-4, 0.02, 0.0358, 0.1, 3.0})
    {
        const scalar e = 1e-5*c;
        CHECK
        (
            model->capacity(c)
         == Approx((model->bound(c + e) - model->bound(c - e))/(2*e)).epsilon(1e-6).margin(1e-7)
        );
        CHECK(model->chord(c, c*(1 + 1e-7)) == Approx(model->capacity(c)).epsilon(1e-5));
        CHECK(model->chord(c, 2*c) == Approx((model->bound(2*c) - model->bound(c))/c));
        CHECK(model->chord(-c, c) == Approx(model->bound(c)/c));
        for (const scalar a : {1e-6, 1.0, 1e6})
        {
            CHECK(model->free(a, a*c + model->bound(c)) == Approx(c).epsilon(1e-9));
        }
    }
    CHECK(model->free(2, -1) == -0.5);
    CHECK(model->free(2, 0) == 0);
}
