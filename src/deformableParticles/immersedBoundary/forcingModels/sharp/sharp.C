/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sharp.H"

namespace Foam
{
namespace forcingModels
{
    defineTypeNameAndDebug(sharp, 0);
    addToRunTimeSelectionTable(forcingModel, sharp, dictionary);
}
}


Foam::forcingModels::sharp::sharp(const dictionary& dict)
:
    curvature_(getNonNegativeOrDefault(dict, "curvature", 3.5)),
    full_(getPositiveOrDefault(dict, "fullCoefficient", 600))
{
    checkEntries(dict, {"type", "curvature", "fullCoefficient"});
}


Foam::scalar Foam::forcingModels::sharp::strength(const cell& c) const
{
    if (c.distance > 0)
    {
        return c.nu*c.wallConductance;
    }

    const scalar cells = c.radius/c.dx;
    const bool atSurface = c.distance > -c.dx/Foam::sqrt(3.0);

    return max
    (
        1/c.dt,
        full_*c.nu/sqr(c.dx)*(atSurface ? cells : 1/cells)
    );
}


Foam::scalar Foam::forcingModels::sharp::velocity
(
    const scalar distance,
    const scalar radius
) const
{
    const scalar kappa = curvature_/radius;

    return
        kappa*mag(distance) > VSMALL
      ? -std::expm1(-kappa*distance)/kappa
      : distance;
}
