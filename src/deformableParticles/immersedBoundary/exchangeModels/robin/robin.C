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


void Foam::exchangeModels::robin::coefficients
(
    const clumpType& type,
    const scalar mu,
    const scalar rho,
    const scalar dt,
    scalarField& zeta,
    scalarField& zetaR
) const
{
    using constant::mathematical::pi;
    const scalarField& r = type.radii();
    const scalarField inertia(rho*type.volumes()/dt);

    zeta = margin_*6*pi*mu*r + inertia;
    zetaR = margin_*8*pi*mu*pow3(r) + 0.4*inertia*sqr(r);
}
