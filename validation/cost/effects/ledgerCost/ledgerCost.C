/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    ledgerCost

Description
    Seconds per call that the ledger of effects takes, on standard output.
\*---------------------------------------------------------------------------*/

#include "effects.H"
#include <iostream>

int main()
{
    using namespace Foam;

    effects e{dictionary()};
    const label n = 1000000;
    const auto start = std::chrono::steady_clock::now();
    for (label i = 0; i < n; ++i)
    {
        const effects::timer t(e, "write");     // the last of the list
    }
    const std::chrono::duration<double> passed
    (
        std::chrono::steady_clock::now() - start
    );
    std::cout << passed.count()/n << std::endl;
    return 0;
}
