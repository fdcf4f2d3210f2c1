/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fluidCoupling.H"
#include "bondFrame.H"
#include "IOdictionary.H"

namespace
{

using namespace Foam;

//- Coefficients of a scheme without the inertia of the fluid inside
scalarField viscous
(
    const couplingScheme& scheme,
    const clumpType& type,
    const scalar mu,
    const scalar rho,
    const scalar dt
)
{
    scalarField z, zR;
    scheme.coefficients(type, mu, rho, dt, z, zR);
    return z - rho*type.volumes()/dt;
}


//- Multiply coefficients z by a factor without their inertia
void raise(scalarField& z, const scalarField& inertia, const scalar factor)
{
    if (factor > 1)
    {
        z = inertia + factor*(z - inertia);
    }
}

}


Foam::fluidCoupling::fluidCoupling
(
    const fvMesh& mesh,
    const PtrList<clumpType>& types,
    const dictionary& clumpProperties,
    const bool feedback,
    const bool rotates,
    const bool frozen
)
:
    mesh_(mesh),
    types_(types),
    frozen_(frozen),
    rho_(0),
    mu_(0)
{
    readFluid(clumpProperties);

    if (!feedback)
    {
        drag_.reset(new oneWayDrag(types));
        return;
    }
    if (rotates)
    {
        rotation_ =
            selectModel<rotationModel>(getDict(clumpProperties, "rotation"));
    }
    scheme_ =
        selectModel<couplingScheme>(getDict(clumpProperties, "couplingScheme"));
    boundary_.reset
    (
        new immersedBoundary
        (
            mesh, types, getDict(clumpProperties, "immersedBoundary")
        )
    );
    if (!scheme_->damps())
    {
        boundary_->followInSeveralSteps();
    }
}


void Foam::fluidCoupling::readFluid(const dictionary& clumpProperties)
{
    const IOdictionary fluid
    (
        IOobject
        (
            "transportProperties", mesh_.time().constant(), mesh_,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    if (!fluid.found("rho") && !clumpProperties.found("rho"))
    {
        FatalIOErrorInFunction(fluid)
            << "The density of the fluid is needed for the forces on the clumps: add"
            << " 'rho' [kg/m3] here or to constant/clumpProperties."
            << exit(FatalIOError);
    }
    rho_ = getPositive
    (
        fluid.found("rho") ? fluid : clumpProperties, "rho", dimDensity
    );
    if
    (
        clumpProperties.found("rho")
     && mag(getPositive(clumpProperties, "rho", dimDensity) - rho_) > 1e-6*rho_
    )
    {
        FatalIOErrorInFunction(clumpProperties)
            << "Entry 'rho' differs from that in " << fluid.objectPath() << ", which is "
            << rho_ << " kg/m3. Remove one of them." << exit(FatalIOError);
    }
    if (fluid.found("nu"))
    {
        // The viscosity models take any sign
        getPositive(fluid, "nu", dimViscosity);
    }
}


void Foam::fluidCoupling::setRotation
(
    clumpImage& image,
    const clumpState& s
) const
{
    if (rotation_.valid() && types_[image.typeId].ofSpheres())
    {
        image.omega = rotation_->angularVelocities(types_[image.typeId], s);
    }
}


void Foam::fluidCoupling::setViscosity(const volScalarField& nu)
{
    mu_ = rho_*gMax(nu.primitiveField());
}


Foam::scalar Foam::fluidCoupling::viscosity(const clumpParcel& p) const
{
    // The present forces are those of the last viscosity
    const scalar nu = max(p.step().nu, p.step().lastNu);
    return nu > 0 ? rho_*nu : mu_;
}


void Foam::fluidCoupling::integrate
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu,
    UList<clumpImage>& images
)
{
    setViscosity(nu);
    if (twoWay())
    {
        boundary_->integrate(U, p, nu, rho_, images);
    }
    else
    {
        drag_->integrate(U, mu_, frozen_, images);
    }
}


void Foam::fluidCoupling::sampleVelocity
(
    const volVectorField& U,
    const volScalarField& nu,
    UList<clumpImage>& images
)
{
    if (twoWay())
    {
        boundary_->update(images, nu);
        boundary_->sampleVelocity(U, images);
    }
    else
    {
        drag_->sampleVelocity(U, images);
    }
}


void Foam::fluidCoupling::takeForces(clumpParcel& p, clumpImage& image) const
{
    image.fluid.constrain(image.tension);
    image.fluid.f /= image.presence;
    image.fluid.t /= image.presence;
    p.fluidForces() = image.fluid.f;
    p.fluidTorques() = Zero;
}


void Foam::fluidCoupling::takeTorques
(
    clumpParcel& p,
    const clumpImage& image
) const
{
    rotation_->transpose
    (
        types_[p.typeId()], p.state(), image.fluid.t,
        p.fluidForces(), p.fluidTorques()
    );
}


void Foam::fluidCoupling::followFlow
(
    const clumpType& type,
    const clumpImage& image,
    clumpState& s
)
{
    forAll(s.u, i)
    {
        // sampleVelocity has stored the integrals of velocity and volume here
        s.u[i] = image.fluid.f[i]/max(image.fluid.t[i].x(), VSMALL);
    }
    s.w = vectorField(s.w.size(), Zero);
    s.w = s.angularVelocity(type);
}


Foam::vectorField Foam::fluidCoupling::inertia
(
    const clumpParcel& p,
    const scalarField& volumes,
    const scalar dt
) const
{
    const clumpState& s = p.state();
    if
    (
        !twoWay() || !boundary_->addsInteriorInertia()
     || !types_[p.typeId()].ofSpheres()
    )
    {
        return vectorField(s.u.size(), Zero);
    }
    return
        p.step().presence*rho_*volumes/dt
       *(p.step().imposedU - s.u + mesh_.time().deltaT0Value()*s.a);
}


Foam::vectorField Foam::fluidCoupling::interiorForces
(
    const clumpParcel& p,
    const scalar dt
) const
{
    const clumpStep& step = p.step();
    const clumpState& s = p.state();
    vectorField result(inertia(p, step.solidVolumes, dt));
    if
    (
        twoWay() && boundary_->addsInteriorInertia()
     && types_[p.typeId()].ofSpheres()
    )
    {
        result +=
            step.presence*rho_/dt
           *(
                (step.imposedW - s.w + mesh_.time().deltaT0Value()*s.b)
              ^ step.solidMoments
            );
    }
    return result;
}


Foam::vector Foam::fluidCoupling::displacedInertia
(
    const clumpParcel& p,
    const scalar dt
) const
{
    return sum(inertia(p, types_[p.typeId()].volumes(), dt));
}


void Foam::fluidCoupling::addForces
(
    const clumpParcel& p,
    const scalar dt,
    externalForces& ext
) const
{
    const clumpType& type = types_[p.typeId()];
    const clumpState& s = p.state();
    const clumpStep& step = p.step();

    ext.f += p.fluidForces();
    ext.imposedU = step.imposedU;
    if (!twoWay())
    {
        ext.zeta = oneWayDrag::resistance(type, mu_);
        return;
    }

    ext.t += p.fluidTorques();
    ext.imposedW = step.imposedW;
    scheme_->coefficients(type, viscosity(p), rho_, dt, ext.zeta, ext.zetaR);
    raise(ext.zeta, rho_/dt*type.volumes(), p.couplingFactor());
    raise(ext.zetaR, rho_/dt*type.volumeInertias(), p.couplingFactor());

    if (boundary_->addsInteriorInertia())
    {
        ext.f += interiorForces(p, dt);
        const scalar dt0 = mesh_.time().deltaT0Value();
        rotation_->transpose
        (
            type,
            s,
            step.presence*rho_/dt
           *(
                (step.solidMoments ^ (step.imposedU - s.u + dt0*s.a))
              + (step.solidInertias & (step.imposedW - s.w + dt0*s.b))
            ),
            ext.f,
            ext.t
        );
    }
}


bool Foam::fluidCoupling::turn
(
    clumpParcel& p,
    const scalar dt,
    const bool extrapolate
) const
{
    const clumpType& type = types_[p.typeId()];
    const clumpState& s = p.state();
    if (!type.ofSpheres())
    {
        if (extrapolate)
        {
            const scalar dt0 = mesh_.time().deltaT0Value();
            p.step().imposedU = s.u + 0.5*(dt + dt0)*s.a;
        }
        return extrapolate;
    }
    if (!scheme_->turns())
    {
        return false;
    }
    const vector velocity(s.velocity(type));
    const vector next
    (
        extrapolate ? velocity + dt*p.expectedAcceleration() : velocity
    );
    const tensor R(rotation(dt*s.angularVelocity(type)).R());

    p.step().imposedU = next + (R & (s.u - velocity));
    p.step().imposedChange += p.step().imposedU - s.u;
    p.step().imposedW = R & s.w;
    return true;
}


bool Foam::fluidCoupling::adapt
(
    clumpParcel& p,
    const scalar dt,
    const bool repeated
) const
{
    if (!types_[p.typeId()].ofSpheres())
    {
        return false;
    }
    clumpStep& step = p.step();
    const vectorField& u = step.end.u;
    const vectorField now(u - step.imposedU);
    const vectorField& last = step.change;
    const bool reverses = sum(now & last) < 0;
    const bool counts = sum(magSqr(now)) > 1e-6*sum(magSqr(u));

    const bool overshoots =
        reverses && counts && sum(magSqr(now)) > sum(magSqr(last));

    // A single one may be the change of an acceleration's sign, if small
    p.overshoots() = overshoots ? step.overshootsBefore + 1 : 0;
    const bool unstable =
        p.overshoots() > 1
     || (overshoots && sum(magSqr(now)) > 0.01*sum(magSqr(u)));

    scalar& factor = p.couplingFactor();
    step.needsShorterStep =
        unstable && !(scheme_->damps() && factor < maxFactor);
    if (!scheme_->damps() || (repeated && !unstable))
    {
        return false;
    }
    bool sure = p.overshoots() > 1;
    const scalar needed = neededRaise(p, dt, sure);
    if (!repeated)
    {
        // What other clumps did in one corrector they seldom do in two
        const scalar raise = counts ? min(needed, step.neededBefore) : 1;
        step.neededBefore = needed/raise;
        if (raise > 1)
        {
            return raiseFactor(p, raise);
        }
    }
    if (unstable)
    {
        const bool persists = p.overshoots() > 4;
        const scalar raise = max(needed, scalar(persists ? 2 : 1));
        if (raise > 1 && (sure || !repeated))
        {
            return raiseFactor(p, sure ? raise : min(raise, 2.0)) && sure;
        }
    }
    if (!reverses && !repeated)
    {
        factor = max(0.98*factor, 1.0);
    }
    return false;
}


bool Foam::fluidCoupling::raiseFactor(clumpParcel& p, const scalar raise)
{
    scalar& factor = p.couplingFactor();
    if (factor >= maxFactor)
    {
        return false;
    }
    factor = min(raise*factor, maxFactor);
    p.step().raised = true;
    return true;
}


Foam::scalar Foam::fluidCoupling::neededRaise
(
    const clumpParcel& p,
    const scalar dt,
    bool& sure
) const
{
    const clumpType& type = types_[p.typeId()];
    const clumpStep& step = p.step();
    const vectorField& d = step.imposedChange;
    const scalarField dd(magSqr(d));
    if (sum(dd) < 1e-6*sum(magSqr(step.end.u)))
    {
        return 1;
    }

    const scalarField z
    (
        p.couplingFactor()*viscous(*scheme_, type, viscosity(p), rho_, dt)
    );
    const scalar own = sum(type.masses()*dd)/dt;
    const scalar inside = rho_*sum(type.volumes()*dd)/dt;
    const scalar inertia = own + inside;
    const scalar ofViscosity = max(sum(z*dd), VSMALL);
    vectorField Gd(step.lastFluidForces - p.fluidForces());
    if (boundary_->addsInteriorInertia())
    {
        Gd -= step.presence*rho_/dt*step.solidVolumes*d;
    }
    const scalar fluid = sum(Gd & d);

    const scalar q = (own + fluid)/max(inertia + ofViscosity, VSMALL);

    // The motion that a locked interior resists most is seldom d itself
    const bool locked = !boundary_->dilates();
    const scalar stiffest =
        locked && fluid > 0
      ? sum(magSqr(Gd)/(z + rho_*type.volumes()/dt))/fluid
      : q;
    if (max(q, stiffest) <= 1.5)
    {
        return 1;
    }
    const vectorField now(step.end.u - step.imposedU);
    const scalar growth = -sum(now & d)/max(sum(dd), VSMALL);
    const bool explains = growth > 0.5*(q - 1) && growth < 2*(q - 1);
    const bool moved = sum(magSqr(p.state().a)) > 0;
    const bool asAWhole =
        now.size()*magSqr(average(now)) > 0.5*sum(magSqr(now));
    sure =
        sure
     || (
            explains && moved && (asAWhole || locked)
         && sum(dd) > 1e-4*sum(magSqr(step.end.u))
        );

    const scalar most = max(q, stiffest);

    return min(most + (most - 1)*inertia/ofViscosity, maxRaise);
}


void Foam::fluidCoupling::report
(
    const Cloud<clumpParcel>& clumps,
    const label nClumps
) const
{
    label nRaised = 0;
    scalar largest = 0;
    for (const clumpParcel& p : clumps)
    {
        if (p.step().raised)
        {
            ++nRaised;
            largest = max(largest, p.couplingFactor());
        }
    }
    reduce(nRaised, sumOp<label>());
    if (!nRaised)
    {
        return;
    }
    reduce(largest, maxOp<scalar>());

    Info<< "Coupling coefficient raised for " << nRaised << " of " << nClumps
        << " clumps, to at most " << largest << " times its value"
        << (largest < maxFactor ? "" : ", which is the limit") << endl;
}
