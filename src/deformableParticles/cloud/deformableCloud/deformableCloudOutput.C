/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "clumpFields.H"
#include "clumpInjector.H"
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


Foam::scalar Foam::deformableCloud::maxSpeedOverRadius() const
{
    scalar result = 0;
    for (const clumpParcel& p : *this)
    {
        result = max(result, max(mag(p.state().u)/type(p).radii()));
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
