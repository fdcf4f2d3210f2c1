/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "neoHookean.H"

namespace Foam
{
namespace membraneModels
{
    defineTypeNameAndDebug(neoHookean, 0);
    addToRunTimeSelectionTable(membraneModel, neoHookean, dictionary);
}
}


Foam::membraneModels::neoHookean::neoHookean
(
    const dictionary& dict,
    const closedSurface& surface,
    const pointField& x0
)
:
    triangleElasticity(surface, x0),
    shearModulus_(getPositive(dict, "shearModulus"))
{
    checkEntries(dict, {"type", "shearModulus"});
}


Foam::triangleElasticity::response Foam::membraneModels::neoHookean::law
(
    const scalar I1,
    const scalar I2
) const
{
    // A triangle without an area has an infinite energy
    const scalar half = 0.5*shearModulus_;
    const scalar J2 = max(I2 + 1, ROOTVSMALL);
    return
    {
        half*(I1 - 1 + 1/J2), half, -half/sqr(J2), 0, 0, 2*half/pow3(J2)
    };
}
