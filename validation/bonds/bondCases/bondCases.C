/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    bondCases

Description
    Prints the cases of validation/bonds: bondCases <explicit steps>
\*---------------------------------------------------------------------------*/

#include "bondCases.H"
#include "argList.H"
#include <cstdio>

using namespace Foam;

namespace
{

dictionary make(const string& shape, const lineProperties& l)
{
    OStringStream os;
    os.precision(17);
    os  << "shape { " << shape.c_str() << " sphereRadius " << l.radius << "; }"
        << "density " << l.density << "; massModel fullSpheres; motion free;"
        << "bondModel { type " << l.bond.c_str() << "; rigidities { normal "
        << l.EA << "; tangential " << l.GA << "; bending " << l.EI
        << "; torsional " << l.GJ << "; } }"
        << "dampingModel { " << l.damping.c_str() << " }";
    return dictionary(IStringStream(os.str())());
}

}


Foam::dictionary Foam::chainOf
(
    const label n,
    const scalar length,
    const lineProperties& l
)
{
    OStringStream os;
    os.precision(17);
    os  << "type chain; nSpheres " << n << "; spacing " << length/(n - 1) << ';';
    return make(os.str(), l);
}


Foam::dictionary Foam::ringOf
(
    const label n,
    const scalar radius,
    const lineProperties& l
)
{
    OStringStream os;
    os.precision(17);
    os << "type ring; nSpheres " << n << "; ringRadius " << radius << ';';
    return make(os.str(), l);
}


void Foam::print
(
    const string& name,
    const scalar parameter,
    const label n,
    const scalar value
)
{
    std::printf("%s,%.10g,%d,%.15g\n", name.c_str(), parameter, int(n), value);
}


int main(int argc, char* argv[])
{
    const label nSteps = argc > 1 ? label(std::atol(argv[1])) : 100000;

    std::printf("case,parameter,n,value\n");
    statics();
    frequencies();
    motion(nSteps);
    return 0;
}
