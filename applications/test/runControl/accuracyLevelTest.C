/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "accuracyLevel.H"
#include "IFstream.H"
#include "OSspecific.H"

using namespace Foam;

namespace
{

//- A file of a level as it is in the sources
dictionary levelFile(const word& level, const word& file)
{
    IFstream is
    (
        getEnv("DEFORMABLE_SRC")/".."/".."/"etc"/"accuracy"/level/file
    );
    return dictionary(is);
}

//- What a case has that includes the file and overrides it
dictionary caseFile
(
    const word& level, const word& file, const string& own = string()
)
{
    const fileName path
    (
        getEnv("DEFORMABLE_SRC")/".."/".."/"etc"/"accuracy"/level/file
    );
    return dictOf("#include \"" + path + "\"\n" + own);
}

}

TEST_CASE("accuracyLevel: what the case writes overrides it", "[accuracy][serial]")
{
    const dictionary clumps
    (
        caseFile
        (
            "draft", "clumpProperties",
            "immersedBoundary { forcing { type continuous; } }"
            "#remove couplingScheme\n couplingScheme { type explicitCoupling; }"
        )
    );
    const dictionary& ib = clumps.subDict("immersedBoundary");
    CHECK(ib.subDict("forcing").get<word>("type") == "continuous");
    CHECK(clumps.subDict("couplingScheme").get<word>("type") == "explicitCoupling");
    CHECK(!clumps.subDict("couplingScheme").found("coefficient"));

    const dictionary solution
    (
        caseFile
        (
            "draft", "fvSolution",
            "PISO { nOuterCorrectors 4; }\n"
            "solvers { \"p.*\" { relTol 0.2; } U { solver PBiCG; } }"
        )
    );
    CHECK(solution.subDict("PISO").get<label>("nOuterCorrectors") == 4);

    // A case has PISO or PIMPLE, so that a level may have neither
    for (const char* level : {"draft", "standard", "fine"})
    {
        CHECK(!levelFile(level, "fvSolution").found("PISO"));
        CHECK(!levelFile(level, "fvSolution").found("PIMPLE"));
    }

    const dictionary& solvers = solution.subDict("solvers");
    CHECK(solvers.subDict("pFinal").get<scalar>("relTol") == 0.2);
    CHECK(solvers.subDict("pFinal").get<word>("solver") == "GAMG");
    CHECK(solvers.subDict("U").get<word>("solver") == "PBiCG");
    CHECK(solvers.subDict("UFinal").get<word>("solver") == "PBiCGStab");
}

TEST_CASE("accuracyLevel: finer is not looser in anything", "[accuracy][serial]")
{
    const wordList levels({"draft", "standard", "fine"});
    for (label i = 0; i < 2; ++i)
    {
        const auto limit = [&](const label level, const char* key)
        {
            return levelFile(levels[level], "controlDict").get<scalar>(key);
        };
        for (const char* key : {"maxCo", "maxDisplacement", "maxViscousNumber"})
        {
            INFO(levels[i] << ' ' << key);
            CHECK(limit(i, key) >= limit(i + 1, key));
            CHECK(limit(i + 1, key) > 0);
        }
        const auto tolerance = [&](const label level, const char* field)
        {
            return levelFile(levels[level], "fvSolution").subDict("solvers")
                .subDict(field).get<scalar>("relTol");
        };
        CHECK(tolerance(i, "U") >= tolerance(i + 1, "U"));
        CHECK(tolerance(i, "p") >= tolerance(i + 1, "p"));

        // Less error for more work
        const dictionary a(levelFile(levels[i], "clumpProperties"));
        const dictionary b(levelFile(levels[i + 1], "clumpProperties"));
        const dictionary& all = a.subDict("accuracyLevel").subDict("measured");
        const dictionary& coarse = all.subDict(levels[i]);
        const dictionary& fine = all.subDict(levels[i + 1]);
        for (const char* key : {"dragError", "rotationError"})
        {
            CHECK(coarse.get<scalar>(key) > fine.get<scalar>(key));
        }
        CHECK(coarse.get<scalar>("dragCost") < fine.get<scalar>("dragCost"));
        CHECK
        (
            a.subDict("accuracyLevel").get<scalar>("cellsPerDiameter")
          < b.subDict("accuracyLevel").get<scalar>("cellsPerDiameter")
        );
    }
}

TEST_CASE("accuracyLevel: prints what the case has", "[accuracy][serial]")
{
    for (const word level : {"draft", "standard", "fine"})
    {
        const accuracyLevel chosen
        (
            levelFile(level, "clumpProperties"),
            levelFile(level, "fvSolution"),
            levelFile(level, "controlDict")
        );
        CHECK(chosen.name() == level);

        OStringStream said;
        chosen.print(said, 10, 7);
        CHECK_THAT(said.str(), Catch::Contains("Accuracy level " + level));
        CHECK_THAT(said.str(), Catch::Contains("s per simulated second"));
        CHECK_THAT
        (
            said.str(), Catch::Contains("7 mesh cells per sphere diameter")
        );
    }
    const accuracyLevel none(dictionary::null, dictionary::null, dictionary::null);
    CHECK(!none.chosen());
    OStringStream said;
    none.print(said, 10, 7);
    CHECK(said.str().empty());
}

TEST_CASE("accuracyLevel: the entry of earlier versions", "[accuracy][serial]")
{
    for (const word old : {"draft", "fine", "precise"})
    {
        CHECK_THROWS
        (
            accuracyLevel::refuseOldEntry(dictOf("accuracy " + old + ";"))
        );
    }
    CHECK_NOTHROW
    (
        accuracyLevel::refuseOldEntry(levelFile("fine", "clumpProperties"))
    );
}
