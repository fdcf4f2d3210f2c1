/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fluidCoupling.H"
#include "bondFrame.H"
#include "fieldAtSpheres.H"
#include "fvcGrad.H"
#include "IOdictionary.H"

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
    boundary_.reset
    (
        new immersedBoundary
        (
            mesh, types, getDict(clumpProperties, "immersedBoundary")
        )
    );
    coefficient_.reset
    (
        new couplingCoefficient(types, *boundary_, rho_, clumpProperties)
    );
    if (!damps())
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
    ghostExchange& ghosts
) const
{
    if (twoWay())
    {
        boundary_->sampleVelocity(U, ghosts.images());
    }
    else
    {
        setFieldAtSpheres(U, fvc::grad(U)(), ghosts.images());
    }
    ghosts.returnForces();
}


void Foam::fluidCoupling::takeForces(clumpParcel& p, clumpImage& image) const
{
    image.fluid.constrain(image.constraint);
    image.fluid.f /= image.fadeFactor;
    image.fluid.t /= image.fadeFactor;
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
        p.step().fadeFactor*rho_*volumes/dt
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
        rotates() && boundary_->addsInteriorInertia()
     && types_[p.typeId()].ofSpheres()
    )
    {
        const vectorField alpha
        (
            step.imposedW - s.w + mesh_.time().deltaT0Value()*s.b
        );
        result += step.fadeFactor*rho_/dt*(alpha ^ step.solidMoments);
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
    coefficient_->set(p, viscosity(p), dt, ext);

    if (boundary_->addsInteriorInertia())
    {
        ext.f += interiorForces(p, dt);
    }
    if (rotates() && boundary_->addsInteriorInertia())
    {
        const scalar dt0 = mesh_.time().deltaT0Value();

        // By name, not as a temporary: see CONTRIBUTING.md
        const vectorField dU(step.imposedU - s.u + dt0*s.a);
        const vectorField dW(step.imposedW - s.w + dt0*s.b);
        vectorField torques(step.solidMoments ^ dU);
        torques += step.solidInertias & dW;
        rotation_->transpose
        (
            type,
            s,
            step.fadeFactor*rho_/dt*torques,
            ext.f,
            ext.t
        );
    }
}


void Foam::fluidCoupling::setSurfaceForce(clumpParcel& p, const scalar dt) const
{
    const clumpType& type = types_[p.typeId()];
    const clumpState& end = p.step().end;
    externalForces ext(end.x.size());
    if (type.ofSpheres())
    {
        addForces(p, dt, ext);
    }
    else
    {
        ext.f = p.fluidForces();
        ext.t = p.fluidTorques();
    }
    if (!twoWay())
    {
        // The drag follows the velocity within the step
        ext.f -= ext.zeta*(end.u - ext.imposedU);
    }
    const point centre(end.centre(type));
    p.surfaceForce() = sum(ext.f);
    p.surfaceTorque() = sum(ext.t);
    forAll(ext.f, i)
    {
        p.surfaceTorque() += (end.x[i] - centre) ^ ext.f[i];
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
    if (!coefficient_->scheme().turns())
    {
        return false;
    }
    const vector velocity(s.velocity(type));
    const vector next
    (
        extrapolate ? velocity + dt*p.expectedAcceleration() : velocity
    );
    const tensor R(rotation(dt*s.angularVelocity(type)).R());

    const vectorField relative(s.u - velocity);
    p.step().imposedU = next + (R & relative);
    p.step().imposedChange += p.step().imposedU - s.u;
    p.step().imposedW = R & s.w;
    return true;
}


void Foam::fluidCoupling::anticipate(clumpParcel& p, const scalar dt) const
{
    if (types_[p.typeId()].ofSpheres())
    {
        coefficient_->anticipate(p, viscosity(p), dt);
    }
}


bool Foam::fluidCoupling::adapt
(
    clumpParcel& p,
    const scalar dt,
    const bool repeated
) const
{
    return
        types_[p.typeId()].ofSpheres()
     && coefficient_->adapt(p, viscosity(p), dt, repeated);
}
