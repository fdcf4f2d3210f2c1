/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    testDeformableParticles

Description
    Unit tests, serial and parallel:

        testDeformableParticles <catch arguments> --- <OpenFOAM arguments>
        mpirun -np 2 testDeformableParticles "~[serial]" --- -case box -parallel

    Tests tagged [serial] make no sense on several ranks. A fatal error is an
    exception, the result is the worst of all ranks, a rank that fails prints
    its report, and the status is non-zero when any failed.
\*---------------------------------------------------------------------------*/

#define CATCH_CONFIG_RUNNER
#include "testCatch.H"

#include "testCase.H"
#include "OSspecific.H"
#include <fstream>
#include <memory>
#include <iostream>

using namespace Foam;

namespace
{
    Time* timePtr = nullptr;
    fvMesh* meshPtr = nullptr;
}

CATCH_TRANSLATE_EXCEPTION(const Foam::error& e)
{
    return e.message();
}

Time& Foam::testTime() { return *timePtr; }
fvMesh& Foam::testMesh() { return *meshPtr; }


int main(int argc, char* argv[])
{
    // Catch's arguments end at ---. Alltest reads what is printed
    std::vector<const char*> catchArgs
    {
        argv[0], "--order", "decl", CATCH_WITHOUT_COLOUR
    };
    std::vector<char*> foamArgs{argv[0]};
    bool foams = false;
    for (int i = 1; i < argc; ++i)
    {
        if (std::string(argv[i]) == "---")
        {
            foams = true;
        }
        else if (foams)
        {
            foamArgs.push_back(argv[i]);
        }
        else
        {
            catchArgs.push_back(argv[i]);
        }
    }

    int foamArgc = int(foamArgs.size());
    char** foamArgv = foamArgs.data();

    argList::noBanner();
    argList args(foamArgc, foamArgv);

    // Every rank reports into a file of its own
    const std::string report
    (
        cwd()/("log.rank" + Foam::name(Pstream::myProcNo()))
    );
    if (Pstream::parRun())
    {
        catchArgs.insert(catchArgs.end(), {"--out", report.c_str()});
    }

    std::unique_ptr<Catch::Session> session(new Catch::Session);
    int status =
        session->applyCommandLine(int(catchArgs.size()), catchArgs.data());

    if (status == 0)
    {
        Time runTime(Time::controlDictName, args);
        fvMesh mesh
        (
            IOobject
            (
                fvMesh::defaultRegion, runTime.timeName(), runTime,
                IOobject::MUST_READ
            )
        );
        timePtr = &runTime;
        meshPtr = &mesh;

        FatalError.throwExceptions();
        FatalIOError.throwExceptions();

        status = session->run() ? 1 : 0;

        // Closes the report
        session.reset();

        if (Pstream::parRun())
        {
            if (status || Pstream::master())
            {
                std::cout
                    << "rank " << Pstream::myProcNo() << ":\n"
                    << std::ifstream(report).rdbuf() << std::flush;
            }
            rm(report);
            reduce(status, maxOp<int>());
        }
    }

    // v1912's MPI finalisation would turn any status into 0
    UPstream::exit(status);
    return status;
}
