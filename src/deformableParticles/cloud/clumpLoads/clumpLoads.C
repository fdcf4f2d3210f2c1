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


bool Foam::clumpLoads::changeHolds
(
    Cloud<clumpParcel>& clumps,
    const scalar dt,
    const label n
) const
{
    if (tr(sum(held_)) <= 0)
    {
        return false;
    }

    constexpr label most = 20;
    scalar farthest = 0;
    for (clumpParcel& p : clumps)
    {
        const clumpType& ct = types_[p.typeId()];
        const symmTensor& along = held(p.typeId());
        clumpStep& step = p.step();
        const vector deviation
        (
            along & (step.end.centre(ct) - p.state().centre(ct))
        );
        farthest = max(farthest, mag(deviation)/min(ct.radii()));

        // The secant through the last two solutions; before, mass and coupling alone
        const scalar inertia = ct.mass()/dt + sum(step.forces.zeta);
        const vector change(deviation - step.holdDeviation);
        if (n == 0)
        {
            step.holdStiffness = inertia/dt;
        }
        else if
        (
            mag(change) > 0.1*mag(step.holdDeviation)
         && (step.holdDeviation & change) < 0
        )
        {
            step.holdStiffness *= -(step.holdDeviation & change)/magSqr(change);
        }
        step.holdDeviation = deviation;
    }
    reduce(farthest, maxOp<scalar>());

    const bool again = farthest > 1e-9 && n + 1 < most;
    if (farthest > 1e-6 && !again)
    {
        WarningInFunction
            << "A clump that is held has moved by " << farthest
            << " sphere radii in the step; it is put back." << endl;
    }
    for (clumpParcel& p : clumps)
    {
        const clumpType& ct = types_[p.typeId()];
        clumpStep& step = p.step();
        if (again)
        {
            step.holdForce -= step.holdStiffness*step.holdDeviation;
        }
        else
        {
            // What is left is below the tolerance of the solution
            const vector du(held(p.typeId()) & step.end.velocity(ct));
            step.forces.f -=
                (ct.masses()/dt + step.forces.zeta)*du;
            step.end.x -= step.holdDeviation;
            step.end.u -= du;
        }
    }
    return again;
}
