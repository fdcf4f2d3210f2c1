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
    displacement_(getNonNegativeOrDefault(dict, "displacement", 1.0/6)),
    full_(getPositiveOrDefault(dict, "fullCoefficient", 600))
{
    checkEntries(dict, {"type", "displacement", "fullCoefficient"});
}


Foam::scalar Foam::forcingModels::sharp::strength(const cell& c) const
{
    return
        c.distance < 0
      ? max(1/c.dt, full_*c.nu/(c.dx*c.radius))
      : c.nu*c.wallConductance;
}
