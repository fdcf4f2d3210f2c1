/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noDamping.H"

namespace Foam
{
namespace dampingModels
{
    defineTypeNameAndDebug(noDamping, 0);
    addToRunTimeSelectionTable(dampingModel, noDamping, dictionary);
}
}


Foam::dampingModels::noDamping::noDamping(const dictionary& dict)
{
    checkEntries(dict, {"type"});
}


Foam::bondCoefficients Foam::dampingModels::noDamping::coefficients
(
    const bondCoefficients&,
    const scalar,
    const scalar
) const
{
    return {0, 0, 0, 0};
}
