/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bondModel.H"
#include "mathematicalConstants.H"

namespace Foam
{
    defineTypeNameAndDebug(bondModel, 0);
    defineRunTimeSelectionTable(bondModel, dictionary);
}


Foam::bondModel::bondModel(const dictionary& dict)
:
    given_(dict.found("rigidities")),
    youngModulus_(given_ ? 1 : getPositive(dict, "youngModulus")),
    shearModulus_(given_ ? 1 : getPositive(dict, "shearModulus"))
{
    if (given_ && (dict.found("youngModulus") || dict.found("multipliers")))
    {
        FatalIOErrorInFunction(dict)
            << "Give either rigidities or youngModulus, shearModulus and "
            << "multipliers" << exit(FatalIOError);
    }

    const dictionary& f = dict.subDict(given_ ? "rigidities" : "multipliers");
    factors_.normal = getPositive(f, "normal");
    factors_.tangential = getNonNegative(f, "tangential");
    factors_.bending = getNonNegative(f, "bending");
    factors_.torsional = getNonNegative(f, "torsional");
}


Foam::bondCoefficients Foam::bondModel::stiffness
(
    const scalar length,
    const scalar radius
) const
{
    const scalar A = given_ ? 1 : constant::mathematical::pi*sqr(radius);
    const scalar I = given_ ? 1 : A*sqr(radius)/4;
    const scalar J = given_ ? 1 : 2*I;

    return
    {
        factors_.normal*youngModulus_*A/length,
        factors_.tangential*shearModulus_*A/length,
        factors_.bending*youngModulus_*I/length,
        factors_.torsional*shearModulus_*J/length
    };
}


Foam::bondModel::axialResponse Foam::bondModel::axial
(
    const scalar elongation,
    const scalar,
    const scalar Kn
) const
{
    return {Kn*elongation, Kn, 0.5*Kn*sqr(elongation)};
}
