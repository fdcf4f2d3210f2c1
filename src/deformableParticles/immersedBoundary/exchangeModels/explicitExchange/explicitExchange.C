/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "explicitExchange.H"

namespace Foam
{
namespace exchangeModels
{
    defineTypeNameAndDebug(explicitExchange, 0);
    addToRunTimeSelectionTable(exchangeModel, explicitExchange, dictionary);
}
}


Foam::exchangeModels::explicitExchange::explicitExchange(const dictionary& dict)
{
    checkEntries(dict, {"type"});
}


void Foam::exchangeModels::explicitExchange::coefficients
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
