/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "poreFormation.H"

namespace Foam
{
namespace damageModels
{
    defineTypeNameAndDebug(poreFormation, 0);
    addToRunTimeSelectionTable(damageModel, poreFormation, dictionary);
}
}

namespace
{
    const Foam::scalar f1 = 5;
    const Foam::scalar f2 = 4.2298e-4;
    const Foam::scalar G1 = 3750;
    const Foam::scalar G2 = 42000;
    const Foam::scalar h = 2.187e-6;
    const Foam::scalar k = 0.927;
}


Foam::damageModels::poreFormation::poreFormation(const dictionary& dict)
{
    checkEntries(dict, {"type", "limit"});
}


Foam::scalar Foam::damageModels::poreFormation::shearRate
(
    const scalar deformation
)
{
    return 2*f1*deformation/(f2*max(1 - sqr(deformation), SMALL));
}


Foam::scalar Foam::damageModels::poreFormation::poreArea(const scalar shearRate)
{
    if (shearRate < G1)
    {
        return 0;
    }
    const scalar x = min(shearRate/G2, scalar(1));
    return
        ((((-13.41*x + 37.31)*x - 48.91)*x + 32.39)*x + 0.63)*x - 0.16;
}


Foam::scalar Foam::damageModels::poreFormation::advance
(
    const scalar before,
    const load& l,
    const scalar dt
) const
{
    return before + dt*h*std::pow(l.stress, k)*poreArea(shearRate(l.deformation));
}
