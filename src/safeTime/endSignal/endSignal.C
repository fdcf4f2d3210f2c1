/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "endSignal.H"
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace
{

volatile std::sig_atomic_t number = 0;

extern "C" void remember(int signal)
{
    if (number)
    {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    number = signal;
}

//- OpenFOAM aborts after some of its errors, with the message and the stack
extern "C" void endWithError(int)
{
    std::fflush(nullptr);
    std::_Exit(EXIT_FAILURE);
}

//- Of OpenFOAM, which prints the stack
struct sigaction handlerBefore;

extern "C" void sayTrap(int signal)
{
    // Nothing but write is safe here
    static const char text[] =
        "\n--> A floating point exception in the time step: a number became"
        " infinite or undefined.\n    The run is unstable, or an entry is many"
        " orders of magnitude from a usual one.\n    Reduce deltaT and check the"
        " entries; the run continues from the last time directory.\n\n";
    const auto written = ::write(STDERR_FILENO, text, sizeof(text) - 1);
    static_cast<void>(written);
    sigaction(SIGFPE, &handlerBefore, nullptr);
    raise(signal);
}

}


void Foam::endSignal::install()
{
    number = 0;
    std::signal(SIGTERM, remember);
    std::signal(SIGINT, remember);
    if (!std::getenv("FOAM_ABORT"))
    {
        std::signal(SIGABRT, endWithError);
    }
}


void Foam::endSignal::explainTraps()
{
    struct sigaction mine = {};
    mine.sa_handler = sayTrap;
    sigemptyset(&mine.sa_mask);
    sigaction(SIGFPE, &mine, &handlerBefore);
}


int Foam::endSignal::received()
{
    return number;
}
