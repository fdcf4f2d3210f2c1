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
{}


Foam::scalar Foam::forcingModels::continuousForcing::strength
(
    const scalar lambda,
    const scalar dt,
    const scalar nu,
    const scalar dx,
    const scalar
) const
{
    return lambda/min(dt, maxDiffusion_*sqr(dx)/nu);
}
