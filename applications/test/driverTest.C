/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    Tests of the driver that must fail, and are seen to fail by Alltest. Hidden:
    they run only when named.
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"

using namespace Foam;

TEST_CASE("driver: the last rank alone fails", "[.mustFail]")
{
    CHECK(Pstream::myProcNo() != Pstream::nProcs() - 1);
}

TEST_CASE("driver: a fatal error is a failure", "[.mustFail]")
{
    FatalErrorInFunction << "on purpose" << exit(FatalError);
}
