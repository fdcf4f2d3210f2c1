/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "continuousForcing.H"

namespace Foam
{
namespace forcingModels
{
    defineTypeNameAndDebug(continuousForcing, 0);
    addToRunTimeSelectionTable(forcingModel, continuousForcing, dictionary);
}
}


Foam::forcingModels::continuousForcing::continuousForcing(const dictionary& dict)
:
    maxDiffusion_(getPositiveOrDefault(dict, "maxDiffusion", GREAT))
{
    checkEntries(dict, {"type", "maxDiffusion"});
}


Foam::scalar Foam::forcingModels::continuousForcing::strength
(
    const cell& c
) const
{
    return c.lambda/min(c.dt, maxDiffusion_*sqr(c.dx)/c.nu);
}
