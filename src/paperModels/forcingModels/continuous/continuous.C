/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "continuous.H"
#include "coveredCells.H"

namespace Foam
{
namespace forcingModels
{
    defineTypeNameAndDebug(continuous, 0);
    addToRunTimeSelectionTable(forcingModel, continuous, dictionary);
}
}


Foam::forcingModels::continuous::continuous(const dictionary& dict)
{
    checkEntries(dict, {"type"});
}


Foam::forcingModel::surfaceInCell Foam::forcingModels::continuous::surface
(
    const cellGeometry&,
    const label,
    const scalar,
    const sphereDistance&
) const
{
    // The solid fraction alone decides
    return {false, 0};
}


void Foam::forcingModels::continuous::setStrength
(
    const cellGeometry&,
    const scalarField&,
    const scalarField& solidFraction,
    const scalarField&,
    const scalar dt,
    const bool,
    coveredCells& covered,
    scalarField& strength
) const
{
    for (coveredCell& c : covered.cells())
    {
        c.forcingWeight = c.lambda;
        strength[c.celli] = solidFraction[c.celli]/dt;
    }
}
