/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "clumpFields.H"
#include "clumpInjector.H"
#include "mathematicalConstants.H"
#include "vector2D.H"

const Foam::clumpInjector& Foam::deformableCloud::injector() const
{
    return *injector_;
}


bool Foam::deformableCloud::needsShorterStep() const
{
    bool needs = false;
    for (const clumpParcel& p : *this)
    {
        needs = needs || p.step().needsShorterStep;
    }
    return coupled() && returnReduce(needs, orOp<bool>());
}


Foam::Pair<Foam::scalar> Foam::deformableCloud::overlaps() const
{
    const vector2D deepest
    (
        returnReduce
        (
            vector2D(contactSummary_.deepest, contactSummary_.deepestOfWall),
            maxOp<vector2D>()
        )
    );
    return Pair<scalar>(deepest.x(), deepest.y());
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


Foam::scalar Foam::deformableCloud::largestDiameter() const
{
    scalar result = 0;
    for (const clumpType& ct : types_)
    {
        result = max(result, 2*ct.reach());
    }
    return result;
}


Foam::scalar Foam::deformableCloud::maxSpeedOverRadius() const
{
    scalar result = 0;
    for (const clumpParcel& p : *this)
    {
        const vectorField u(p.state().u - meshVelocity_);
        result = max(result, max(mag(u)/type(p).bodyRadii()));
    }
    return returnReduce(result, maxOp<scalar>());
}


Foam::scalar Foam::deformableCloud::releaseStep(const scalar radii)
{
    const bool heavy = effects_.active("gravity");
    if (!heavy && loads_.empty())
    {
        return GREAT;
    }
    const scalar pi = constant::mathematical::pi;
    const scalar rho = hasFluid() ? fluidDensity() : 0;
    const scalar nu =
        hasFluid()
      ? gMin(mesh_.lookupObject<volScalarField>("nu").primitiveField()) : 0;

    if (!loads_.empty())
    {
        for (clumpParcel& p : *this)
        {
            p.step().ahead = Zero;
        }
        updateGhosts();
        loads_.sample(ghosts_);
    }

    scalar result = GREAT;
    label index = -1;
    for (const clumpParcel& p : *this)
    {
        const clumpType& ct = type(p);
        ++index;
        if (ct.fixed())
        {
            continue;
        }
        vector F(Zero);
        if (heavy)
        {
            F += (ct.mass() - rho*ct.volume())*g_;
        }
        F += loads_.steadyForce(p, index);

        const scalar size = max(mag(F), VSMALL);
        const scalar way = radii*ct.halfWidth();
        scalar step = Foam::sqrt(way*ct.mass()/size);
        if (hasFluid())
        {
            const scalar R = Foam::cbrt(0.75*ct.volume()/pi);
            const scalar slow = size/(6*pi*rho*nu*R);
            const scalar u =
                2*slow/(1 + Foam::sqrt(1 + 4*slow*R/(30*nu)));
            step = max(step, way/u);
        }
        result = min(result, step);
    }
    return returnReduce(result, minOp<scalar>());
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
            result, 2*type(p).halfWidth()/cbrt(mesh_.V()[p.cell()])
        );
    }
    return returnReduce(result, minOp<scalar>());
}


void Foam::deformableCloud::writeFields() const
{
    clumpFields::write(*this, types_);
    writtenTypes::write(name(), mesh_.time(), types_);
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
