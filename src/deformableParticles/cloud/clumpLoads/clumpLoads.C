/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpLoads.H"
#include "checkedEntries.H"
#include "modelSelection.H"

Foam::clumpLoads::clumpLoads
(
    const fvMesh& mesh,
    const PtrList<clumpType>& types
)
:
    mesh_(mesh),
    types_(types)
{}


void Foam::clumpLoads::read
(
    const dictionary* dict,
    const HashTable<label>& typeIds
)
{
    held_.setSize(types_.size(), symmTensor(Zero));
    if (!dict)
    {
        return;
    }
    for (const word& name : dict->toc())
    {
        const dictionary& d = getDict(*dict, name);
        loads_.append(selectModel<load>(d));

        const load& added = loads_.last();
        bool some = false;
        forAll(types_, i)
        {
            if (added.actsOn(types_[i]))
            {
                added.check(d, types_[i].size());
                hold(d, i);
                some = true;
            }
        }
        if (!some)
        {
            FatalIOErrorInLookup(d, "clumpType", added.loadedType(), typeIds)
                << exit(FatalIOError);
        }
        added.field(mesh_);
    }
}


void Foam::clumpLoads::hold(const dictionary& dict, const label typei)
{
    const symmTensor& along = loads_.last().constraint();
    if (tr(along) > 0 && !types_[typei].ofSpheres())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'clumpType': " << types_[typei].name() << " is no clump of spheres;"
            << " the load hold cannot hold it: its force would depend on the time step."
            << exit(FatalIOError);
    }
    if (tr(held_[typei]) > 0 && tr(along) > 0)
    {
        FatalIOErrorInFunction(dict)
            << "Clump type " << types_[typei].name() << " has two loads of the type"
            << " hold: give all directions to one of them." << exit(FatalIOError);
    }
    if (!types_[typei].fixed())
    {
        held_[typei] += along;
    }
}


void Foam::clumpLoads::sample(ghostExchange& ghosts)
{
    for (load& l : loads_)
    {
        l.sample(mesh_, ghosts);
    }
}


void Foam::clumpLoads::add
(
    const load& l,
    const clumpParcel& p,
    const label index,
    externalForces& ext
) const
{
    const clumpType& type = types_[p.typeId()];
    if (l.actsOn(type))
    {
        l.add
        (
            load::site
            {
                mesh_, type, p.state(), p.unwrappedCentres(), l.values(index)
            },
            ext
        );
    }
}


void Foam::clumpLoads::add
(
    const clumpParcel& p,
    const label index,
    externalForces& ext
) const
{
    for (const load& l : loads_)
    {
        add(l, p, index, ext);
    }
}


Foam::vector Foam::clumpLoads::steadyForce
(
    const clumpParcel& p,
    const label index
) const
{
    vector result(Zero);
    for (const load& l : loads_)
    {
        externalForces ext(types_[p.typeId()].size());
        add(l, p, index, ext);
        if (max(mag(ext.k)) == 0)
        {
            result += sum(ext.f);
        }
    }
    return result;
}


Foam::symmTensor Foam::clumpLoads::held() const
{
    symmTensor result(Zero);
    for (const load& l : loads_)
    {
        result += l.holds() ? symmTensor(I) : l.constraint();
    }
    return result;
}


void Foam::clumpLoads::addHold(clumpParcel& p, const scalar dt) const
{
    const symmTensor& along = held(p.typeId());
    if (tr(along) <= 0)
    {
        return;
    }
    const clumpType& ct = types_[p.typeId()];
    const clumpState& start = p.state();
    clumpState& end = p.step().end;
    externalForces& ext = p.step().forces;

    const vectorField dx(end.x - start.x);
    const vector H
    (
        along
      & sum
        (
            ct.masses()/dt*(end.u - start.u) + (ext.k & dx)
          + ext.zeta*(end.u - ext.imposedU) - ext.f
        )
    );
    ext.f += ct.masses()/ct.mass()*H;

    // What the balance of angular momentum and rounding leave of the motion
    const vector du(along & end.velocity(ct));
    ext.f -= (ct.masses()/dt + ext.zeta)*du;
    end.u -= du;
    end.x -= along & (end.centre(ct) - start.centre(ct));
}
