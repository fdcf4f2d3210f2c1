/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "endSignal.H"
#include <csignal>

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

}


void Foam::endSignal::install()
{
    number = 0;
    std::signal(SIGTERM, remember);
    std::signal(SIGINT, remember);
}


int Foam::endSignal::received()
{
    return number;
}
