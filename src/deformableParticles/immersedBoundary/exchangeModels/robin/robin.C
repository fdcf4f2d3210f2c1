/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "robin.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace exchangeModels
{
    defineTypeNameAndDebug(robin, 0);
    addToRunTimeSelectionTable(exchangeModel, robin, dictionary);
}
}


Foam::exchangeModels::robin::robin(const dictionary& dict)
:
    margin_(getNonNegative(dict, "margin"))
{}


Foam::scalarField Foam::exchangeModels::robin::coefficients
(
    const clumpType& type,
    const scalar mu,
    const scalar rho,
    const scalar dt
) const
{
    using constant::mathematical::pi;
    return margin_*6*pi*mu*type.radii() + rho*type.volumes()/dt;
}
