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


Foam::bondModel::bondModel
(
    const dictionary& dict,
    const wordList& derived
)
:
    given_(dict.found("rigidities")),
    youngModulus_(given_ ? 1 : getPositive(dict, "youngModulus")),
    shearModulus_(given_ ? 1 : getPositive(dict, "shearModulus")),
    normalStrength_(0),
    shearStrength_(0)
{
    checkEntries
    (
        dict,
        {
            "type", "rigidities", "youngModulus", "shearModulus",
            "multipliers", "breakage"
        },
        derived
    );

    if (given_ && (dict.found("youngModulus") || dict.found("multipliers")))
    {
        FatalIOErrorInFunction(dict)
            << "Give either 'rigidities', or 'youngModulus', 'shearModulus'"
            << " and 'multipliers', but not both." << exit(FatalIOError);
    }

    if (dict.found("breakage"))
    {
        const dictionary& strength = getDict(dict, "breakage");
        checkEntries(strength, {"normalStress", "shearStress"});
        normalStrength_ = getPositive(strength, "normalStress");
        shearStrength_ = getPositive(strength, "shearStress");
    }

    const dictionary& f = getDict(dict, given_ ? "rigidities" : "multipliers");
    checkEntries(f, {"normal", "tangential", "bending", "torsional"});
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


Foam::Pair<Foam::scalar> Foam::bondModel::stresses
(
    const vector& n,
    const vector& m,
    const vector& t,
    const vector& e,
    const scalar radius
)
{
    const scalar A = constant::mathematical::pi*sqr(radius);
    const scalar I = A*sqr(radius)/4;
    const scalar N = n & t;
    const scalar torsion = m & e;

    return Pair<scalar>
    (
        N/A + mag(m - torsion*e)*radius/I,
        mag(n - N*t)/A + mag(torsion)*radius/(2*I)
    );
}


bool Foam::bondModel::breaks
(
    const vector& n,
    const vector& m,
    const vector& t,
    const vector& e,
    const scalar radius
) const
{
    const Pair<scalar> s(stresses(n, m, t, e, radius));
    return s.first() > normalStrength_ || s.second() > shearStrength_;
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
