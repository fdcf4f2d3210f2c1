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
    youngModulus_(getPositive(dict, "youngModulus")),
    shearModulus_(getPositive(dict, "shearModulus"))
{
    const dictionary& f = dict.subDict("multipliers");
    multipliers_.normal = getPositive(f, "normal");
    multipliers_.tangential = getNonNegative(f, "tangential");
    multipliers_.bending = getNonNegative(f, "bending");
    multipliers_.torsional = getNonNegative(f, "torsional");
}


Foam::bondCoefficients Foam::bondModel::stiffness
(
    const scalar length,
    const scalar radius
) const
{
    const scalar A = constant::mathematical::pi*sqr(radius);
    const scalar I = A*sqr(radius)/4;

    return
    {
        multipliers_.normal*youngModulus_*A/length,
        multipliers_.tangential*shearModulus_*A/length,
        multipliers_.bending*youngModulus_*I/length,
        multipliers_.torsional*shearModulus_*2*I/length
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
