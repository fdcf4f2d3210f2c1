/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "kelvinVoigt.H"

namespace Foam
{
namespace dampingModels
{
    defineTypeNameAndDebug(kelvinVoigt, 0);
    addToRunTimeSelectionTable(dampingModel, kelvinVoigt, dictionary);
}
}


Foam::dampingModels::kelvinVoigt::kelvinVoigt(const dictionary& dict)
:
    tau_(getPositive(dict, "timeConstant"))
{}


Foam::bondCoefficients Foam::dampingModels::kelvinVoigt::coefficients
(
    const bondCoefficients& k,
    const scalar,
    const scalar
) const
{
    return
    {
        tau_*k.normal, tau_*k.tangential, tau_*k.bending, tau_*k.torsional
    };
}
