/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "catch2/catch.hpp"
#include "testCase.H"
#include "accuracyPreset.H"
#include "StringStream.H"

using namespace Foam;

TEST_CASE("accuracyPreset: fills what is missing only", "[accuracy][serial]")
{
    const dictionary given
    (
        dictOf
        (
            "accuracy standard; couplingScheme { type explicitCoupling; }"
            "immersedBoundary { forcing { type continuous; } interiorDilation no; }"
        )
    );
    const dictionary all(accuracyPreset(given).completed(given));

    // The user's, without the coefficient of another type
    const dictionary& coupling = all.subDict("couplingScheme");
    CHECK(coupling.get<word>("type") == "explicitCoupling");
    CHECK(!coupling.found("coefficient"));

    const dictionary& ib = all.subDict("immersedBoundary");
    CHECK(ib.subDict("forcing").get<word>("type") == "continuous");
    CHECK(!ib.get<bool>("interiorDilation"));
    CHECK(ib.subDict("solidFraction").found("type"));
    CHECK(all.subDict("rotation").found("type"));
}


TEST_CASE("accuracyPreset: nothing without the entry", "[accuracy][serial]")
{
    const dictionary given(dictOf("rotation { type none; }"));
    const accuracyPreset none(given);
    CHECK(!none.chosen());
    CHECK(none.completed(given) == given);
    CHECK(none.limit("maxCo", 7) == 7);
}


TEST_CASE("accuracyPreset: finer is not looser in anything", "[accuracy][serial]")
{
    CHECK_THROWS(accuracyPreset(dictOf("accuracy precise;")));
    CHECK_THROWS(accuracyPreset(dictOf("accuracy common;")));

    const accuracyPreset draft(dictOf("accuracy draft;"));
    const accuracyPreset standard(dictOf("accuracy standard;"));
    const accuracyPreset fine(dictOf("accuracy fine;"));
    for (const word key : {"maxCo", "maxDisplacement", "maxDeltaT"})
    {
        CHECK(draft.limit(key, 0) >= standard.limit(key, 0));
        CHECK(standard.limit(key, 0) >= fine.limit(key, 0));
        CHECK(fine.limit(key, 0) > 0);
    }
}


TEST_CASE("accuracyPreset: says what the case has", "[accuracy][serial]")
{
    const accuracyPreset standard(dictOf("accuracy standard;"));
    OStringStream said;
    standard.print(said, 10, 5);
    CHECK_THAT(said.str(), Catch::Contains("Accuracy standard"));
    CHECK_THAT(said.str(), Catch::Contains("nOuterCorrectors"));
    CHECK_THAT(said.str(), Catch::Contains("5 cells per sphere diameter"));
}
