/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "explicitCoupling.H"

namespace Foam
{
namespace couplingSchemes
{
    defineTypeNameAndDebug(explicitCoupling, 0);
    addToRunTimeSelectionTable(couplingScheme, explicitCoupling, dictionary);
}
}


Foam::couplingSchemes::explicitCoupling::explicitCoupling(const dictionary& dict)
{
    checkEntries(dict, {"type"});
}


void Foam::couplingSchemes::explicitCoupling::coefficients
(
    const clumpType&,
    const scalar,
    const scalar,
    const scalar,
    scalarField& zeta,
    scalarField& zetaR
) const
{
    zeta = 0;
    zetaR = 0;
}
