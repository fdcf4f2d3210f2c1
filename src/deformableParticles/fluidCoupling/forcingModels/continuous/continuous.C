/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "continuous.H"

namespace Foam
{
namespace forcingModels
{
    defineTypeNameAndDebug(continuous, 0);
    addToRunTimeSelectionTable(forcingModel, continuous, dictionary);
}
}


Foam::forcingModels::continuous::continuous(const dictionary& dict)
:
    maxDiffusion_(getPositiveOrDefault(dict, "maxDiffusion", GREAT))
{
    checkEntries(dict, {"type", "maxDiffusion"});
}


Foam::scalar Foam::forcingModels::continuous::strength
(
    const cell& c
) const
{
    return c.lambda/min(c.dt, maxDiffusion_*sqr(c.dx)/c.nu);
}
