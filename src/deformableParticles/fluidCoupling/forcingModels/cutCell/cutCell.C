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
    curvature_(getNonNegativeOrDefault(dict, "curvatureCoefficient", 4.3)),
    full_(getPositiveOrDefault(dict, "fullCoefficient", 2400))
{
    checkEntries
    (
        dict,
        {"type", "cutCoefficient", "curvatureCoefficient", "fullCoefficient"}
    );
}


Foam::scalar Foam::forcingModels::cutCell::strength(const cell& c) const
{
    const scalar diffusion = c.nu/sqr(c.dx);
    const scalar full = max(1/c.dt, full_*diffusion*c.dx/c.radius);
    const scalar cut = cut_*(1 + curvature_*sqr(c.dx/c.radius))*diffusion;

    return c.lambda/(c.lambda/full + (1 - c.lambda)/cut);
}
