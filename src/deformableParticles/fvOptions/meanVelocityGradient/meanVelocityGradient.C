/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "meanVelocityGradient.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"
#include "fvMatrices.H"
#include "basicSymmetryFvPatchFields.H"
#include "FlatOutput.H"
#include "foamCompat.H"
#include "checkedEntries.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(meanVelocityGradient, 0);
    addToRunTimeSelectionTable(option, meanVelocityGradient, dictionary);
}
}


namespace
{

using namespace Foam;

//- With the whole mesh where no cells are selected
dictionary everywhere(const dictionary& dict, const word& type)
{
    dictionary result(dict);
    if (!result.found(type + "Coeffs") && !result.found("selectionMode"))
    {
        result.add("selectionMode", word("all"));
    }
    return result;
}

}


Foam::fv::meanVelocityGradient::meanVelocityGradient
(
    const word& sourceName,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    cellSetOption(sourceName, modelType, everywhere(dict, modelType), mesh),
    Ubar_(Zero),
    others_(false),
    gradient_(Zero),
    index_(-1),
    start_(Zero),
    held_(-1),
    state_
    (
        IOobject
        (
            name_ + "Properties",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    )
{
    fieldNames_ = coeffs_.getOrDefault<wordList>("fields", wordList({"U"}));
    applied_.setSize(fieldNames_.size(), false);

    if
    (
        fieldNames_.size() != 1
     || !mesh.foundObject<volVectorField>(fieldNames_[0])
    )
    {
        FatalIOErrorInFunction(coeffs_)
            << "Entry 'fields' is " << flatOutput(fieldNames_)
            << "; it must be the name of one field of "
            << flatOutput(mesh.sortedNames<volVectorField>())
            << exit(FatalIOError);
    }
    checkEntries(dict, {"Ubar", "free", typeName + "Coeffs"}, fvOptionEntries());
    readMeanVelocity(dict);

    if (state_.found("gradient"))
    {
        // Former versions wrote the component along Ubar
        gradient_ =
            state_.lookup("gradient")[0].isNumber()
          ? vector(state_.get<scalar>("gradient")*normalised(Ubar_))
          : state_.get<vector>("gradient");
    }
    for (const word key : {"response", "responseStep"})
    {
        state_.remove(key);
    }
}


void Foam::fv::meanVelocityGradient::readMeanVelocity(const dictionary& dict)
{
    Ubar_ = getFinite<vector>(coeffs_, "Ubar");
    others_ = findOthers(dict);
    heldDirections();
}


Foam::List<Foam::vector> Foam::fv::meanVelocityGradient::heldDirections() const
{
    DynamicList<vector> periods;
    bool alongOnly = freeDirections(periods);
    reduce(alongOnly, orOp<bool>());
    alongOnly = alongOnly || others_;

    // Orthogonal directions: first the free ones, then those that are held
    DynamicList<vector> axes;
    const auto add = [&](vector d)
    {
        const scalar length = mag(d);
        for (const vector& axis : axes)
        {
            d -= (axis & d)*axis;
        }
        if (mag(d) > 1e-6*length)
        {
            axes.append(d/mag(d));
        }
    };
    for (const word& name : coeffs_.getOrDefault<wordList>("free", wordList()))
    {
        const label d = wordList({"x", "y", "z"}).find(name);
        if (d < 0)
        {
            FatalIOErrorInFunction(coeffs_)
                << "Entry 'free' contains " << name << "; valid are x, y and z."
                << exit(FatalIOError);
        }
        vector axis(Zero);
        axis[d] = 1;
        if (mag(Ubar_ & axis) > 0)
        {
            FatalIOErrorInFunction(coeffs_)
                << "Entry 'free' contains " << name << ", but Ubar is " << Ubar_
                << ": the component must be zero." << exit(FatalIOError);
        }
        add(axis);
    }
    const label nFree = axes.size();
    if (alongOnly)
    {
        add(Ubar_);
    }
    else
    {
        List<List<vector>> all(Pstream::nProcs());
        all[Pstream::myProcNo()] = periods;
        gatherToAll(all);
        for (const List<vector>& some : all)
        {
            for (const vector& period : some)
            {
                add(period);
            }
        }
    }
    const List<vector> held(SubList<vector>(axes, axes.size() - nFree, nFree));
    refuseFixed(held);
    return held;
}


void Foam::fv::meanVelocityGradient::refuseFixed(const UList<vector>& held) const
{
    vector rest(Ubar_);
    for (const vector& d : held)
    {
        rest -= (Ubar_ & d)*d;
    }
    if (mag(rest) > 1e-6*mag(Ubar_))
    {
        FatalIOErrorInFunction(coeffs_)
            << "Entry 'Ubar' is " << Ubar_ << ", but the boundary conditions fix"
            << " the mean velocity in this direction: no cyclic patches repeat"
            << " along it, and " << fieldNames_[0] << " is fixed on all other"
            << " patches. The gradient would grow without limit."
            << exit(FatalIOError);
    }
    if (held.empty())
    {
        FatalIOErrorInFunction(coeffs_)
            << "Entry 'Ubar' is " << Ubar_ << ", but no component of the mean"
            << " velocity can be held: there are no cyclic patches, or their"
            << " directions are among the entry 'free'." << exit(FatalIOError);
    }
}


bool Foam::fv::meanVelocityGradient::freeDirections
(
    DynamicList<vector>& periods
) const
{
    const auto& U = mesh_.lookupObject<volVectorField>(fieldNames_[0]);
    bool others = false;
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        const polyPatch& patch = pf.patch().patch();
        if (isA<coupledPolyPatch>(patch))
        {
            const auto& pair = refCast<const coupledPolyPatch>(patch);
            if (pair.separated())
            {
                periods.append(pair.separation()[0]);
            }
            others = others || !pair.parallel();
        }
        else if
        (
            !polyPatch::constraintType(patch.type())
         && !isA<basicSymmetryFvPatchVectorField>(pf)
         && pf.assignable()
        )
        {
            others = true;
        }
    }
    return others;
}


bool Foam::fv::meanVelocityGradient::findOthers(const dictionary& dict) const
{
    bool found = false;
    for (const entry& e : dict.parent())
    {
        if (!e.isDict() || e.keyword() == name_)
        {
            continue;
        }
        const dictionary& other = e.dict();
        if
        (
            other.getOrDefault<word>("type", "none") != typeName
         || !other.getOrDefault("active", true)
        )
        {
            continue;
        }
        found = true;
        const vector Ubar
        (
            other.optionalSubDict(typeName + "Coeffs").get<vector>("Ubar")
        );
        if (mag(Ubar & Ubar_) >= 1e-6*mag(Ubar)*mag(Ubar_))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'Ubar' is " << Ubar_ << " in " << name_ << " and "
                << Ubar << " in " << e.keyword() << ". Both hold the mean"
                << " velocity in the same direction, and their gradients would"
                << " grow without limit. Remove one of them."
                << exit(FatalIOError);
        }
    }
    return found;
}


void Foam::fv::meanVelocityGradient::refuseIdle(const scalar response) const
{
    if (!(response > 0))
    {
        FatalIOErrorInFunction(coeffs_)
            << "A gradient in this source changes the mean velocity by " << response
            << " m/s per m/s2: it cannot hold Ubar " << Ubar_ << ". The source acts on "
            << returnReduce(cells_.size(), sumOp<label>()) << " mesh cells."
            << exit(FatalIOError);
    }
}


void Foam::fv::meanVelocityGradient::beginStep()
{
    const label index = mesh_.time().timeIndex();
    if (index == index_)
    {
        gradient_ = start_;
    }
    start_ = gradient_;
    index_ = index;
}


void Foam::fv::meanVelocityGradient::correct(volVectorField& U)
{
    if (held_ != mesh_.time().timeIndex())
    {
        FatalIOErrorInFunction(coeffs_)
            << "The source " << name_ << " of type " << typeName << " needs the solver"
            << " rbcIbFoam, which finds its gradient together with the flow. Use the"
            << " type meanVelocityForce with other solvers." << exit(FatalIOError);
    }
    const scalarField& V = mesh_.V();
    const vector mean(gSum(V*U.primitiveField())/gSum(V));
    Info<< "Mean velocity = " << mean << ", pressure gradient = " << gradient_ << endl;

    setExact(state_, "gradient", gradient_);
    setExact(state_, "mean", mean);
}


void Foam::fv::meanVelocityGradient::addSup
(
    fvMatrix<vector>& eqn,
    const label
)
{
    for (const label celli : cells_)
    {
        eqn.source()[celli] -= mesh_.V()[celli]*gradient_;
    }
}


bool Foam::fv::meanVelocityGradient::read(const dictionary& dict)
{
    if (cellSetOption::read(dict))
    {
        readMeanVelocity(dict);
        return true;
    }
    return false;
}
