/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "robin.H"
#include "clumpState.H"
#include "mathematicalConstants.H"
#include <Eigen/Eigenvalues>

namespace Foam
{
namespace couplingSchemes
{
    defineTypeNameAndDebug(robin, 0);
    addToRunTimeSelectionTable(couplingScheme, robin, dictionary);
}
}


Foam::couplingSchemes::robin::robin(const dictionary& dict)
:
    coefficient_(0),
    turns_(dict.getOrDefault("turnVelocities", true))
{
    const dictionary entries
    (
        withoutRemoved
        (
            withPresentNames(dict, {{"margin", "coefficient"}}),
            {"deflateRigidMotion"}
        )
    );
    checkEntries(entries, {"type", "coefficient", "turnVelocities"});
    coefficient_ = getNonNegativeOrDefault(entries, "coefficient", 1);
}


void Foam::couplingSchemes::robin::coefficients
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

    // r over the depth to which viscosity acts in a step
    const scalarField x(r*Foam::sqrt(rho/(mu*dt)));

    zeta = coefficient_*6*pi*mu*r*(1 + x) + inertia;

    const tensor I(clumpState(type).inertia(type));
    Eigen::Matrix3d moments;
    moments <<
        I.xx(), I.xy(), I.xz(),
        I.yx(), I.yy(), I.yz(),
        I.zx(), I.zy(), I.zz();
    const scalar least =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>
        (
            moments, Eigen::EigenvaluesOnly
        ).eigenvalues()[0];
    const scalar ofSpheres = sum(type.inertias());
    const scalar resistance =
        8*pi*mu*sum(pow3(r)*(1 + sqr(x)/(3*(1 + x))))
      + 6*pi*mu*max(r*(1 + x))*r.size()*(least - ofSpheres)/type.mass();

    zetaR =
        coefficient_*resistance*sqr(ofSpheres/least)/r.size()
      + rho/dt*type.volumeInertias();
}
