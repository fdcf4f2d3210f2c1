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
    stressFree_(stressFreeState(type, getDict(dict, "membrane")).positions()),
    rings_(1)
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
        rings_ = max(rings_, models_.last().rings());
    }
    if (models_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'membrane' has no model of what holds the nodes together, for"
            << " example  strain { type neoHookean; shearModulus 5e-6; }"
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::membraneMechanics::add
(
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent,
    const membraneModel::motion* start
) const
{
    scalar energy = 0;
    for (const membraneModel& model : models_)
    {
        energy += model.add(x, gradient, tangent);
        if (start)
        {
            energy += model.addRate(x, *start, gradient, tangent);
        }
    }
    return energy;
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
