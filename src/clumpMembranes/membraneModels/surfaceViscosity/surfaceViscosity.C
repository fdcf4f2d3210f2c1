/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceViscosity.H"

namespace Foam
{
namespace membraneModels
{
    defineTypeNameAndDebug(surfaceViscosity, 0);
    addToRunTimeSelectionTable(membraneModel, surfaceViscosity, dictionary);
}
}


Foam::membraneModels::surfaceViscosity::surfaceViscosity
(
    const dictionary& dict,
    const closedSurface& surface,
    const pointField& x0
)
:
    triangleElasticity(surface, x0),
    viscosity_(getPositive(dict, "viscosity"))
{
    checkEntries(dict, {"type", "viscosity"});
}


Foam::triangleElasticity::response Foam::membraneModels::surfaceViscosity::law
(
    const scalar I1,
    const scalar I2
) const
{
    return
    {
        viscosity_*(sqr(I1)/8 + 0.5*(I1 - I2)),
        viscosity_*(I1/4 + 0.5), -0.5*viscosity_, viscosity_/4, 0, 0
    };
}


Foam::scalar Foam::membraneModels::surfaceViscosity::addRate
(
    const pointField& x,
    const motion& start,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    const scalarField factors(surface().triangles().size(), 1/start.duration);
    return addRelative(start.from, factors, x, gradient, tangent);
}
