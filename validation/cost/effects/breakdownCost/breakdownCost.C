/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    breakdownCost

Description
    Prints the seconds per call that the time breakdown itself takes.
\*---------------------------------------------------------------------------*/

#include "timeBreakdown.H"
#include <iostream>

int main()
{
    using namespace Foam;

    timeBreakdown breakdown;
    const label n = 1000000;
    const auto start = std::chrono::steady_clock::now();
    for (label i = 0; i < n; ++i)
    {
        // The last part of the list takes longest to find
        const timeBreakdown::timer t(breakdown, "write");
    }
    const std::chrono::duration<double> passed
    (
        std::chrono::steady_clock::now() - start
    );
    std::cout << passed.count()/n << std::endl;
    return 0;
}
