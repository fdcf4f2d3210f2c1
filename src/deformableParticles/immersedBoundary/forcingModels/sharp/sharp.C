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
    displacement_
    (
        dict.getCheckOrDefault<scalar>
        (
            "displacement", 1.0/6, [](scalar x){ return x >= 0; }
        )
    ),
    full_(getPositiveOrDefault(dict, "fullCoefficient", 600))
{}


Foam::scalar Foam::forcingModels::sharp::strength(const cell& c) const
{
    return
        c.distance < 0
      ? max(1/c.dt, full_*c.nu/(c.dx*c.radius))
      : c.nu*c.wallConductance;
}
