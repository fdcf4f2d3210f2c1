/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "timoshenko.H"

namespace Foam
{
namespace bondModels
{
    defineTypeNameAndDebug(timoshenko, 0);
    addToRunTimeSelectionTable(bondModel, timoshenko, dictionary);
}
}


Foam::bondCoefficients Foam::bondModels::timoshenko::stiffness
(
    const scalar length,
    const scalar radius
) const
{
    return inSeries(bondModel::stiffness(length, radius), length);
}


Foam::bondCoefficients Foam::bondModels::timoshenko::inSeries
(
    bondCoefficients k,
    const scalar length
)
{
    const scalar bending = 12*k.bending/sqr(length);
    k.tangential *= bending/max(k.tangential + bending, VSMALL);
    return k;
}
