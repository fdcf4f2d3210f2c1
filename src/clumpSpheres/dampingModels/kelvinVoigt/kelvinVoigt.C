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
{
    checkEntries(dict, {"type", "timeConstant", "timeConstants"});

    if (dict.found("timeConstants"))
    {
        if (dict.found("timeConstant"))
        {
            FatalIOErrorInFunction(dict)
                << "Give exactly one of 'timeConstant' and 'timeConstants'."
                << exit(FatalIOError);
        }
        const dictionary& d = getDict(dict, "timeConstants");
        checkEntries(d, {"normal", "tangential", "bending", "torsional"});
        tau_.normal = getPositive(d, "normal");
        tau_.tangential = getPositive(d, "tangential");
        tau_.bending = getPositive(d, "bending");
        tau_.torsional = getPositive(d, "torsional");
    }
    else
    {
        const scalar tau = getPositive(dict, "timeConstant");
        tau_ = {tau, tau, tau, tau};
    }
}


Foam::bondCoefficients Foam::dampingModels::kelvinVoigt::coefficients
(
    const bondCoefficients& k,
    const scalar,
    const scalar
) const
{
    return
    {
        tau_.normal*k.normal,
        tau_.tangential*k.tangential,
        tau_.bending*k.bending,
        tau_.torsional*k.torsional
    };
}
