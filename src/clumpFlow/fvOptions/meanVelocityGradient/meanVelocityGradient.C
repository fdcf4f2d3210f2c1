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
#include "Constant.H"
#include "StringStream.H"

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


//- Times of the run at which a mean velocity is looked at [s]. The golden section has no
//  period, so that an oscillation is not met in its zeros alone
scalarList timesOfRun(const Function1<vector>& Ubar, const Time& time)
{
    const scalar start = time.value();
    if (isA<Function1Types::Constant<vector>>(Ubar))
    {
        return scalarList(1, start);
    }
    const scalar length = max(time.endTime().value() - start, scalar(0));
    scalarList result(1000);
    forAll(result, i)
    {
        const scalar turns = 0.5*(Foam::sqrt(scalar(5)) - 1)*(i + 1);
        result[i] = start + length*(turns - std::floor(turns));
    }
    return result;
}


//- The largest value of a mean velocity in the run [m/s]
vector largest(const Function1<vector>& Ubar, const Time& time)
{
    vector result(Zero);
    for (const scalar t : timesOfRun(Ubar, time))
    {
        const vector u(Ubar.value(t));
        if (!(mag(u) <= mag(result)))
        {
            result = u;
        }
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
    largest_(Zero),
    along_(Zero),
    alongOnly_(false),
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
    checkEntries
    (
        dict, {"Ubar", "UbarCoeffs", "free", typeName + "Coeffs"}, fvOptionEntries()
    );
    readMeanVelocity(dict);

    if (state_.found("gradient"))
    {
        // Former versions wrote the component along Ubar
        gradient_ =
            state_.lookup("gradient")[0].isNumber()
          ? vector(state_.get<scalar>("gradient")*along_)
          : state_.get<vector>("gradient");
    }
    for (const word key : {"response", "responseStep"})
    {
        state_.remove(key);
    }
}


void Foam::fv::meanVelocityGradient::readMeanVelocity(const dictionary& dict)
{
    refuseMissing(coeffs_, "Ubar");
    Ubar_ = Function1<vector>::New("Ubar", coeffs_);
    largest_ = largest(*Ubar_, mesh_.time());
    along_ = normalised(largest_);

    // That of the run before was found at other times
    vector line(Zero);
    if
    (
        state_.readIfPresent("line", line)
     && mag(line - (line & along_)*along_) < 1e-9*mag(line)
    )
    {
        along_ = line;
    }

    DynamicList<vector> periods;
    alongOnly_ = returnReduce(freeDirections(periods), orOp<bool>());
    alongOnly_ = findOthers(dict) || alongOnly_;

    const List<vector> held(heldDirections());
    for (const scalar t : timesOfRun(*Ubar_, mesh_.time()))
    {
        refuseOthers(held, t);
    }
}


bool Foam::fv::meanVelocityGradient::constant() const
{
    return isA<Function1Types::Constant<vector>>(*Ubar_);
}


Foam::string Foam::fv::meanVelocityGradient::said(const scalar t) const
{
    OStringStream os;
    os  << Ubar_->value(t);
    if (!constant())
    {
        os  << " at time " << t;
    }
    return os.str();
}


Foam::List<Foam::vector> Foam::fv::meanVelocityGradient::freeComponents() const
{
    const wordList names(coeffs_.getOrDefault<wordList>("free", wordList()));
    List<vector> result(names.size(), vector::zero);
    forAll(names, i)
    {
        const label d = wordList({"x", "y", "z"}).find(names[i]);
        if (d < 0)
        {
            FatalIOErrorInFunction(coeffs_)
                << "Entry 'free' contains " << names[i] << "; valid are x, y and z."
                << exit(FatalIOError);
        }
        result[i][d] = 1;
    }
    return result;
}


Foam::List<Foam::vector> Foam::fv::meanVelocityGradient::heldDirections() const
{
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
    for (const vector& axis : freeComponents())
    {
        add(axis);
    }
    const label nFree = axes.size();
    if (alongOnly_)
    {
        add(along_);
    }
    else
    {
        DynamicList<vector> periods;
        freeDirections(periods);
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
    const scalar now = mesh_.time().value();
    refuseOthers(held, now);
    if (held.empty())
    {
        FatalIOErrorInFunction(coeffs_)
            << "Entry 'Ubar' is " << said(now).c_str() << ", but no component of the"
            << " mean velocity can be held: there are no cyclic patches, or their"
            << " directions are among the entry 'free'." << exit(FatalIOError);
    }
    return held;
}


void Foam::fv::meanVelocityGradient::refuseOthers
(
    const UList<vector>& held,
    const scalar t
) const
{
    const vector Ubar(checkSize(coeffs_, "Ubar", Ubar_->value(t)));
    const scalar size = max(mag(largest_), mag(Ubar));
    for (const vector& axis : freeComponents())
    {
        if (mag(Ubar & axis) > 1e-12*size)
        {
            FatalIOErrorInFunction(coeffs_)
                << "Entry 'free' contains "
                << (axis.x() > 0 ? "x" : axis.y() > 0 ? "y" : "z") << ", but Ubar is "
                << said(t).c_str() << ": the component must be zero."
                << exit(FatalIOError);
        }
    }
    vector rest(Ubar);
    for (const vector& d : held)
    {
        rest -= (Ubar & d)*d;
    }
    if (mag(rest) <= 1e-6*size)
    {
        return;
    }
    if (alongOnly_)
    {
        FatalIOErrorInFunction(coeffs_)
            << "Entry 'Ubar' is " << said(t).c_str() << ", which is not along its largest"
            << " value, " << largest_ << ". Where the fluid may flow through a patch on"
            << " which " << fieldNames_[0] << " is not fixed, and beside other sources of"
            << " this type, one direction is held, which must not change in time. Give"
            << " each component a source of its own." << exit(FatalIOError);
    }
    FatalIOErrorInFunction(coeffs_)
        << "Entry 'Ubar' is " << said(t).c_str() << ", but the boundary conditions fix"
        << " the mean velocity in this direction: no cyclic patches repeat"
        << " along it, and " << fieldNames_[0] << " is fixed on all other"
        << " patches. The gradient would grow without limit."
        << exit(FatalIOError);
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
        const vector theirs
        (
            largest
            (
                *Function1<vector>::New
                (
                    "Ubar", other.optionalSubDict(typeName + "Coeffs")
                ),
                mesh_.time()
            )
        );
        if (mag(theirs & largest_) >= 1e-6*mag(theirs)*mag(largest_))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'Ubar' is " << largest_ << " in " << name_ << " and "
                << theirs << " in " << e.keyword() << ". Both hold the mean"
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
            << " m/s per m/s2: it cannot hold Ubar " << Ubar() << ". The source acts on "
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
    if (!constant())
    {
        setExact(state_, "line", along_);
    }
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
