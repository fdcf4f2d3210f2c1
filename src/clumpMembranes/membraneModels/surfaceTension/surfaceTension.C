/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceArea.H"
#include "surfaceTension.H"

namespace Foam
{
namespace membraneModels
{
    defineTypeNameAndDebug(surfaceTension, 0);
    addToRunTimeSelectionTable(membraneModel, surfaceTension, dictionary);
}
}


Foam::membraneModels::surfaceTension::surfaceTension
(
    const dictionary& dict,
    const closedSurface& surface,
    const pointField&
)
:
    surface_(surface),
    tension_(getPositive(dict, "tension"))
{
    checkEntries(dict, {"type", "tension"});
}


Foam::scalar Foam::membraneModels::surfaceTension::add
(
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    gradient += tension_*surface_.areaGradient(x);
    if (tangent)
    {
        surfaceArea::addStretch(surface_, x, tension_, *tangent);
    }
    return tension_*surface_.area(x);
}


void Foam::membraneModels::surfaceTension::addTensions
(
    const pointField& x,
    symmTensorField& tensions
) const
{
    surfaceArea::addIsotropic(surface_, x, tension_, tensions);
}
