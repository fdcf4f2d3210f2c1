/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "skalak.H"

namespace Foam
{
namespace membraneModels
{
    defineTypeNameAndDebug(skalak, 0);
    addToRunTimeSelectionTable(membraneModel, skalak, dictionary);
}
}


Foam::membraneModels::skalak::skalak
(
    const dictionary& dict,
    const closedSurface& surface,
    const pointField& x0
)
:
    triangleElasticity(surface, x0),
    shearModulus_(getPositive(dict, "shearModulus")),
    areaRatio_(getNonNegative(dict, "areaRatio"))
{
    checkEntries(dict, {"type", "shearModulus", "areaRatio"});
}


Foam::triangleElasticity::response Foam::membraneModels::skalak::law
(
    const scalar I1,
    const scalar I2
) const
{
    const scalar half = 0.5*shearModulus_;
    const scalar C = areaRatio_;
    return
    {
        0.5*half*(sqr(I1) + 2*I1 - 2*I2 + C*sqr(I2)),
        half*(I1 + 1), half*(C*I2 - 1), half, 0, half*C
    };
}
