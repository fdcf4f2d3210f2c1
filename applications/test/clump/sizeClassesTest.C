/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "sizeClasses.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

//- A moment of the radius over that of the lognormal distribution,
//  E r^k = m^k (1 + (d/m)^2)^(k (k - 1)/2)
scalar relativeMoment
(
    const sizeClasses& classes,
    const label k,
    const scalar mean,
    const scalar deviation
)
{
    const scalarField powers(pow(classes.radii(), scalar(k)));
    return
        sum(classes.fractions()*powers)
       /(
            Foam::pow(mean, scalar(k))
           *Foam::pow(1 + sqr(deviation/mean), scalar(0.5*k*(k - 1)))
        );
}


sizeClasses lognormal(const scalar mean, const scalar deviation, const label n)
{
    dictionary dict(dictOf("distribution lognormal;"));
    dict.set("mean", mean);
    dict.set("deviation", deviation);
    dict.set("number", n);
    return sizeClasses(dict);
}

}


TEST_CASE("sizeClasses: moments of a lognormal distribution", "[serial][sizes]")
{
    const scalar m = 2e-6;
    const scalar d = GENERATE(as<scalar>{}, 0.05, 0.3, 0.6, 1.2)*m;

    // The volume for any number of classes, the others with its square
    scalar before[2] = {GREAT, GREAT};
    for (const label n : {8, 16, 32})
    {
        const sizeClasses classes(lognormal(m, d, n));
        CHECK(sum(classes.fractions()) == Approx(1).epsilon(1e-12));
        CHECK(relativeMoment(classes, 3, m, d) == Approx(1).epsilon(1e-10));
        for (label k = 0; k + 1 < n; ++k)
        {
            CHECK(classes.radii()[k] < classes.radii()[k + 1]);
        }
        const scalar errors[2] =
        {
            mag(relativeMoment(classes, 1, m, d) - 1),
            mag(relativeMoment(classes, 4, m, d) - 1)
        };
        for (label i = 0; i < 2; ++i)
        {
            CHECK(errors[i] < before[i]);
            before[i] = errors[i];
        }
    }
    // The mean radius by number, and that by volume, E r^4/E r^3: ln r is uniform in a
    // class of the width h, whose radius is (E r^3)^(1/3)
    const sizeClasses usual(lognormal(m, d, 8));
    const scalar s = Foam::sqrt(Foam::log(1 + sqr(d/m)));
    const scalar v = sqr(s*(5 + 3*s)/8)/12;
    CHECK(relativeMoment(usual, 1, m, d) - 1 == Approx(v).epsilon(0.15));
    CHECK(relativeMoment(usual, 4, m, d) - 1 == Approx(-2*v).epsilon(0.15));
}


TEST_CASE("sizeClasses: types of an entry with sizes", "[serial][sizes]")
{
    const dictionary types
    (
        dictOf
        (
            "bead { shape { type chain; nSpheres 2; spacing 1e-6; sphereRadius 1e-6; }"
            " density 1000; nominalVolume 3e-18; bondModel { type elastic;"
            " youngModulus 1; shearModulus 1; multipliers { normal 1; tangential 1;"
            " bending 1; torsional 1; } } dampingModel { type none; }"
            " sizes { distribution list; radii (1e-6 2e-5); fractions (0.7 0.3); } }"
            "other { shape { type chain; nSpheres 1; sphereRadius 1e-6; } density 1; }"
        )
    );
    const dictionary expanded(sizeClasses::expanded(types));
    CHECK(expanded.toc() == wordList({"bead_1", "bead_2", "other"}));

    const scalar radii[2] = {1e-6, 2e-5};
    const scalar fractions[2] = {0.7, 0.3};
    const word names[2] = {"bead_1", "bead_2"};
    for (label k = 0; k < 2; ++k)
    {
        const clumpType type(names[k], expanded.subDict(names[k]));
        CHECK(type.family() == "bead");
        CHECK(type.share() == fractions[k]);
        CHECK
        (
            type.volume()
         == Approx(constant::mathematical::pi*4/3*pow3(radii[k])).epsilon(1e-6)
        );
        CHECK
        (
            type.nominalVolume()/type.volume()
         == Approx
            (
                3e-18/clumpType("plain", [&]()
                {
                    dictionary plain(types.subDict("bead"));
                    plain.remove("sizes");
                    return plain;
                }()).volume()
            )
        );
    }
    const clumpType other("other", expanded.subDict("other"));
    CHECK(other.family() == "other");
    CHECK(other.share() == 1);
}


TEST_CASE("sizeClasses: entries that are refused", "[serial][sizes]")
{
    const auto made = [](const string& entries)
    {
        return sizeClasses(dictOf("distribution " + entries));
    };
    CHECK_NOTHROW(made("lognormal; mean 1; deviation 0.5;"));
    CHECK_THROWS(made("normal; mean 1; deviation 0.5;"));
    CHECK_THROWS(made("lognormal; mean 1; deviation 3;"));
    CHECK_THROWS(made("lognormal; mean 1; deviation 0.5; number 1;"));
    CHECK_NOTHROW(made("list; radii (1 2); fractions (0.5 0.5);"));
    CHECK_THROWS(made("list; radii (1 2); fractions (0.5 0.6);"));
    CHECK_THROWS(made("list; radii (2 1); fractions (0.5 0.5);"));
    CHECK_THROWS(made("list; radii (1 2); fractions (1);"));
    CHECK_THROWS(made("list; radii (1 2); fractions (1 0);"));
}
