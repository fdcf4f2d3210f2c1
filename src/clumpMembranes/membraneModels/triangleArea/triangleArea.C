/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "triangleArea.H"

namespace Foam
{
namespace membraneModels
{
    defineTypeNameAndDebug(triangleArea, 0);
    addToRunTimeSelectionTable(membraneModel, triangleArea, dictionary);
}
}


Foam::membraneModels::triangleArea::triangleArea
(
    const dictionary& dict,
    const closedSurface& surface,
    const pointField& x0
)
:
    triangleElasticity(surface, x0),
    modulus_(getPositive(dict, "areaModulus"))
{
    checkEntries(dict, {"type", "areaModulus"});
}


Foam::triangleElasticity::response Foam::membraneModels::triangleArea::law
(
    const scalar I1,
    const scalar I2
) const
{
    const scalar J = Foam::sqrt(max(I2 + 1, ROOTVSMALL));
    return
    {
        0.5*modulus_*sqr(J - 1),
        0, 0.5*modulus_*(J - 1)/J, 0, 0, 0.25*modulus_/pow3(J)
    };
}
