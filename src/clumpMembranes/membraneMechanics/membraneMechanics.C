/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneMechanics.H"
#include "stressFreeState.H"

Foam::membraneMechanics::membraneMechanics
(
    const clumpType& type,
    const dictionary& dict
)
:
    type_(type),
    stressFree_(stressFreeState(type, dict).positions()),
    neighbourOrder_(1)
{
    const dictionary& models = getDict(dict, "membrane");
    for (const word& name : models.toc())
    {
        if (name == "stressFree")
        {
            continue;
        }
        models_.append
        (
            selectModel<membraneModel>
            (
                getDict(models, name), type.surface(), stressFree_
            ).ptr()
        );
        neighbourOrder_ = max(neighbourOrder_, models_.last().neighbourOrder());
    }
    if (models_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'membrane' has no model of what holds the nodes together, for"
            << " example  strain { type neoHookean; shearModulus 5e-6; }"
            << exit(FatalIOError);
    }
    if (type.size() > surface().nNodes())
    {
        neighbours_.setSize(type.size());
        for (const membraneModel& model : models_)
        {
            model.addNeighbours(neighbours_);
        }
        if (neighbours_.last().empty())
        {
            FatalIOErrorInFunction(models)
                << "Entry 'membrane': the shape of the type " << type.name()
                << " has nodes inside that no model holds. Give it, for example,"
                << "  solid { type neoHookeanSolid; shearModulus 1000; }  or the shape"
                << " without 'filled'." << exit(FatalIOError);
        }
    }
    layer_.reset(new layerViscosity(type.surface(), type.centres()));
    folds_.reset
    (
        new foldLocking(type.surface(), type.centres(), shearStiffness())
    );
}


Foam::scalar Foam::membraneMechanics::shearStiffness() const
{
    const scalar stretch = 1.01;
    const auto energy = [&](const direction d, const scalar lambda)
    {
        pointField x(stressFree_);
        for (point& p : x)
        {
            p[d] *= lambda;
            p[(d + 1) % 3] /= lambda;
        }
        vectorField gradient(x.size(), Zero);
        scalar result = 0;
        for (const membraneModel& model : models_)
        {
            result += model.add(x, gradient, nullptr);
        }
        return result;
    };

    scalar sum = -6*energy(0, 1);
    for (direction d = 0; d < 3; ++d)
    {
        sum += energy(d, stretch) + energy(d, 1/stretch);
    }
    return sum/(3*sqr(Foam::log(stretch)));
}


bool Foam::membraneMechanics::bends() const
{
    for (const membraneModel& model : models_)
    {
        if (model.bends())
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::membraneMechanics::bendingEnergy(const pointField& x) const
{
    vectorField unused(x.size(), Zero);
    scalar energy = 0;
    for (const membraneModel& model : models_)
    {
        if (model.bends())
        {
            energy += model.add(x, unused, nullptr);
        }
    }
    return energy;
}


Foam::scalar Foam::membraneMechanics::add
(
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent,
    const membraneModel::motion* start
) const
{
    scalar energy = folds_->add(x, gradient, tangent);
    for (const membraneModel& model : models_)
    {
        energy += model.add(x, gradient, tangent);
        if (start)
        {
            energy += model.addRate(x, *start, gradient, tangent);
        }
    }
    if (start && start->layer.size())
    {
        energy += layer_->addRate(x, *start, gradient, tangent);
    }
    return energy;
}


void Foam::membraneMechanics::addTensions
(
    const pointField& x,
    symmTensorField& tensions
) const
{
    for (const membraneModel& model : models_)
    {
        model.addTensions(x, tensions);
    }
}


Foam::vectorField Foam::membraneMechanics::forces
(
    const pointField& x,
    const membraneModel::motion* start
) const
{
    vectorField f(x.size(), Zero);
    add(x, f, nullptr, start);
    f.negate();
    return f;
}
