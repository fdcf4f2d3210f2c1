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


Foam::exchangeModels::explicitExchange::explicitExchange(const dictionary&)
{}


Foam::scalarField Foam::exchangeModels::explicitExchange::coefficients
(
    const clumpType& type,
    const scalar,
    const scalar,
    const scalar
) const
{
    return scalarField(type.size(), Zero);
}
