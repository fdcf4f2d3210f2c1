/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cutCell.H"

namespace Foam
{
namespace forcingModels
{
    defineTypeNameAndDebug(cutCell, 0);
    addToRunTimeSelectionTable(forcingModel, cutCell, dictionary);
}
}


Foam::forcingModels::cutCell::cutCell(const dictionary& dict)
:
    cut_(getPositiveOrDefault(dict, "cutCoefficient", 23)),
    curvature_
    (
        dict.getCheckOrDefault<scalar>
        (
            "curvatureCoefficient", 4.3, [](scalar x){ return x >= 0; }
        )
    ),
    full_(getPositiveOrDefault(dict, "fullCoefficient", 2400))
{}


Foam::scalar Foam::forcingModels::cutCell::strength
(
    const scalar lambda,
    const scalar dt,
    const scalar nu,
    const scalar dx,
    const scalar radius
) const
{
    const scalar diffusion = nu/sqr(dx);
    const scalar full = max(1/dt, full_*diffusion*dx/radius);

    const scalar cut = cut_*(1 + curvature_*sqr(dx/radius))*diffusion;

    return lambda/(lambda/full + (1 - lambda)/cut);
}
