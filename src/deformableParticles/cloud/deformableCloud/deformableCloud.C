/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "FlatOutput.H"

namespace Foam
{
    defineTypeNameAndDebug(deformableCloud, 0);
}


const Foam::deformableCloud& Foam::deformableCloud::find
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    const word name(dict.getOrDefault<word>("cloud", "clumps"));
    const auto* cloud = mesh.findObject<deformableCloud>(name);
    if (!cloud)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'cloud' is " << name << ", the clouds are "
            << flatOutput(mesh.sortedNames<deformableCloud>())
            << exit(FatalIOError);
    }
    return *cloud;
}


void Foam::deformableCloud::evolve
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu
)
{
    mu_ = rho_*gMax(nu.primitiveField());
    if (!coupled())
    {
        const effects::timer t(effects_, "ghosts");
        ghosts_.update(*this);
    }
    gatherForces(U, p, nu);
    decideEffects();
    advance(mesh_.time().deltaTValue());
}


void Foam::deformableCloud::evolve()
{
    {
        const effects::timer t(effects_, "ghosts");
        ghosts_.update(*this);
    }
    decideEffects();
    advance(mesh_.time().deltaTValue());
}


Foam::integrator::externals Foam::deformableCloud::steadyForces
(
    const clumpParcel& parcel,
    const clumpState& imposed,
    const scalar dt
) const
{
    const clumpType& ct = type(parcel);
    const clumpState& s = parcel.state();
    integrator::externals ext(ct.size());

    if (effects_.active("gravity"))
    {
        const effects::timer t(effects_, "gravity");
        ext.f +=
        (
            ct.masses() - rho_*ct.volumes()*ct.relativeVolume(s.x)
        )*g_;
    }

    if (drag_.valid())
    {
        ext.f += parcel.fluidForces();
        ext.zeta = oneWayDrag::resistance(ct, mu_);
        ext.u0 = imposed.u;
    }

    if (coupled())
    {
        ext.f += parcel.fluidForces();
        ext.t += parcel.fluidTorques();
        couplingScheme_->coefficients
        (
            ct, s.exchange*mu_, rho_, dt, ext.zeta, ext.zetaR
        );
        ext.u0 = imposed.u;
        ext.w0 = imposed.w;

        if (immersedBoundary_->addsInteriorInertia())
        {
            ext.f += interiorForces(parcel, imposed, dt);
            ext.t +=
                0.4*rho_/dt*ct.volumes()*sqr(ct.radii())
               *(imposed.w - s.w + mesh_.time().deltaT0Value()*s.b);
        }
    }

    return ext;
}


Foam::vectorField Foam::deformableCloud::interiorForces
(
    const clumpParcel& parcel,
    const clumpState& imposed,
    const scalar dt
) const
{
    // From the velocity the fluid inside had to the one it has
    const clumpState& s = parcel.state();
    return
        rho_*type(parcel).volumes()/dt
       *(imposed.u - s.u + mesh_.time().deltaT0Value()*s.a);
}


void Foam::deformableCloud::advance(const scalar dt)
{
    const label n = size();
    momentum_ = clumpMomentum();
    List<integrator::externals> steady(n);

    if (!coupled())
    {
        imposed_.setSize(n);
    }

    label index = 0;
    for (const clumpParcel& parcel : *this)
    {
        if (!coupled())
        {
            imposed_[index] = parcel.state();
        }
        steady[index] = steadyForces(parcel, imposed_[index], dt);
        addMomentum(parcel, imposed_[index], dt);
        ++index;
    }

    const bool touching = effects_.active("contact");
    const label nSub = touching ? contactSubSteps(steady, dt) : 1;
    const scalar h = dt/nSub;
    List<Pair<vectorField>> before(n);
    if (nSub > 1 && coupled())
    {
        index = 0;
        for (const clumpParcel& parcel : *this)
        {
            before[index++] =
                Pair<vectorField>(parcel.state().u, parcel.state().w);
        }
    }

    for (label sub = 0; sub < nSub; ++sub)
    {
        List<integrator::externals> ext(steady);

        if (loads_.size())
        {
            addLoads(mesh_.time().value() - dt + (sub + 1)*h, ext);
        }
        if (touching)
        {
            const effects::timer t(effects_, "contact");
            contactGhosts_.update(*this);
            addContacts(ext);
        }
        if (effects_.active("walls"))
        {
            addWalls(ext);
        }

        const effects::timer t(effects_, "clumps");
        index = 0;
        for (clumpParcel& parcel : *this)
        {
            if (!type(parcel).fixed())
            {
                const pointField x0(parcel.state().x);
                const vectorField u0(parcel.state().u);
                if (before[index].first().size())
                {
                    moveInterior(parcel, before[index], h, dt, ext[index]);
                }
                integrator_->advance
                (
                    bonds(parcel), ext[index], h, parcel.state()
                );
                addMomentum
                (
                    type(parcel), ext[index], x0, u0, parcel.state(), h/dt
                );
            }
            ++index;
        }
    }

    momentum_.rate /= dt;
    momentum_.applied -= momentum_.fluid + momentum_.interior;
    overshoots_ = false;
    index = 0;
    for (clumpParcel& parcel : *this)
    {
        clumpState& s = parcel.state();
        const vectorField change(s.u - imposed_[index].u);
        s.a = change/dt;
        s.b = (s.w - imposed_[index].w)/dt;
        if (coupled())
        {
            adaptExchange(parcel, index, change);
        }
        ++index;
    }
}


void Foam::deformableCloud::moveInterior
(
    const clumpParcel& parcel,
    const Pair<vectorField>& before,
    const scalar h,
    const scalar dt,
    integrator::externals& ext
) const
{
    const clumpState& s = parcel.state();
    scalarField zeta(ext.zeta), zetaR(ext.zetaR);
    couplingScheme_->coefficients
    (
        type(parcel), s.exchange*mu_, rho_, h, zeta, zetaR
    );

    const auto move = [&]
    (
        const scalarField& z,       // of the sub-step
        const vectorField& u,
        const vectorField& u0,      // at the start of the step
        scalarField& zeta,
        vectorField& imposed,
        vectorField& f
    )
    {
        forAll(z, i)
        {
            if (z[i] <= 0)
            {
                continue;
            }
            const scalar m = (z[i] - zeta[i])/(1/h - 1/dt);
            f[i] += m/dt*(imposed[i] - u0[i]);
            imposed[i] = ((zeta[i] - m/dt)*imposed[i] + m/h*u[i])/z[i];
            zeta[i] = z[i];
        }
    };
    move(zeta, s.u, before.first(), ext.zeta, ext.u0, ext.f);
    move(zetaR, s.w, before.second(), ext.zetaR, ext.w0, ext.t);
}


void Foam::deformableCloud::addMomentum
(
    const clumpParcel& parcel,
    const clumpState& imposed,
    const scalar dt
)
{
    if (!coupled())
    {
        return;
    }
    vector interior(Zero);
    if (immersedBoundary_->addsInteriorInertia())
    {
        interior = sum(interiorForces(parcel, imposed, dt));
    }
    momentum_.fluid += sum(parcel.fluidForces());
    momentum_.interior += interior;
}


void Foam::deformableCloud::addMomentum
(
    const clumpType& type,
    const integrator::externals& ext,
    const pointField& x0,
    const vectorField& u0,
    const clumpState& end,
    const scalar part
)
{
    momentum_.rate += sum(type.masses()*(end.u - u0));
    momentum_.exchange -= part*sum(ext.zeta*(end.u - ext.u0));
    momentum_.applied += part*sum(ext.f - (ext.k & (end.x - x0)));
}


void Foam::deformableCloud::addLoads
(
    const scalar t,
    List<integrator::externals>& ext
) const
{
    const effects::timer clock(effects_, "loads");

    label index = 0;
    for (const clumpParcel& parcel : *this)
    {
        for (const load& l : loads_)
        {
            if (l.clumpType() == type(parcel).name())
            {
                l.add(t, parcel.centres(), ext[index]);
            }
        }
        ++index;
    }
}


void Foam::deformableCloud::moveParcels()
{
    const effects::timer t(effects_, "clumps");

    if (coupled())
    {
        label nRaised = 0;
        for (const bool raised : raised_)
        {
            nRaised += raised ? 1 : 0;
        }
        reportExchange(returnReduce(nRaised, sumOp<label>()));
    }

    for (clumpParcel& parcel : *this)
    {
        parcel.recentre(type(parcel));
    }

    clumpParcel::trackingData td(*this);
    Cloud<clumpParcel>::move(*this, td, mesh_.time().deltaTValue());

    nClumps_ = returnReduce(size(), sumOp<label>());
    effects_.endStep();
}


Foam::scalar Foam::deformableCloud::maxSpeed() const
{
    scalar result = 0;
    for (const clumpParcel& p : *this)
    {
        result = max(result, max(mag(p.state().u)));
    }
    return returnReduce(result, maxOp<scalar>());
}


Foam::label Foam::deformableCloud::mostSpheres() const
{
    label result = 0;
    for (const clumpType& type : types_)
    {
        result = max(result, type.size());
    }
    return result;
}


Foam::scalar Foam::deformableCloud::cellsPerDiameter() const
{
    scalar result = GREAT;
    for (const clumpParcel& p : *this)
    {
        result = min
        (
            result, 2*min(type(p).radii())/cbrt(mesh_.V()[p.cell()])
        );
    }
    return returnReduce(result, minOp<scalar>());
}


Foam::scalar Foam::deformableCloud::maxStrokeRate() const
{
    scalar result = 0;
    for (const clumpParcel& p : *this)
    {
        result = max(result, max(mag(p.state().u)/type(p).radii()));
    }
    return returnReduce(result, maxOp<scalar>());
}


void Foam::deformableCloud::writeFields() const
{
    clumpParcel::writeFields(*this);
}


void Foam::deformableCloud::writeObjects(objectRegistry& obr) const
{
    IOField<label>& typeIds(cloud::createIOField<label>("typeId", size(), obr));
    IOField<vector>& U(cloud::createIOField<vector>("U", size(), obr));
    IOField<point>& position
    (
        cloud::createIOField<point>("position", size(), obr)
    );

    label i = 0;
    for (const clumpParcel& p : *this)
    {
        typeIds[i] = p.typeId();
        U[i] = p.state().velocity(type(p));
        position[i] = p.centre(type(p));
        ++i;
    }
}
