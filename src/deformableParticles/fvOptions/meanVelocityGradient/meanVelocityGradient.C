/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "meanVelocityGradient.H"
#include "addToRunTimeSelectionTable.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"
#include "volFields.H"
#include "fvMatrices.H"
#include "zeroGradientFvPatchFields.H"
#include "basicSymmetryFvPatchFields.H"
#include "fixedValueFvPatchFields.H"
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
    used_(Zero),
    mean_(Zero),
    response_(0),
    responseStep_(0),
    fresh_(true),
    index_(-1),
    corrected_(-GREAT),
    start_({Zero, Zero, true}),
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

    if (state_.headerOk())
    {
        // Former versions wrote the components along Ubar
        const vector along(Ubar_/max(mag(Ubar_), VSMALL));
        const auto read = [&](const word& key, const vector& otherwise)
        {
            return
                !state_.found(key) ? otherwise
              : state_.lookup(key)[0].isNumber()
              ? vector(state_.get<scalar>(key)*along)
              : state_.get<vector>(key);
        };
        gradient_ = read("gradient", Zero);
        mean_ = read("mean", Ubar_);
        state_.readIfPresent("response", response_);
        state_.readIfPresent("responseStep", responseStep_);
        fresh_ = false;
    }
}


void Foam::fv::meanVelocityGradient::readMeanVelocity(const dictionary& dict)
{
    Ubar_ = getFinite<vector>(coeffs_, "Ubar");
    others_ = findOthers(dict);
    heldDirections();
}


Foam::tensor Foam::fv::meanVelocityGradient::heldDirections() const
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
    tensor held(Zero);
    for (label k = nFree; k < axes.size(); ++k)
    {
        held += axes[k]*axes[k];
    }

    refuseFixed(held);
    return held;
}


void Foam::fv::meanVelocityGradient::refuseFixed(const tensor& held) const
{
    if (mag(Ubar_ - (held & Ubar_)) > 1e-6*mag(Ubar_))
    {
        FatalIOErrorInFunction(coeffs_)
            << "Entry 'Ubar' is " << Ubar_ << ", but the boundary conditions fix"
            << " the mean velocity in this direction: no cyclic patches repeat"
            << " along it, and " << fieldNames_[0] << " is fixed on all other"
            << " patches. The gradient would grow without limit."
            << exit(FatalIOError);
    }
    if (tr(held) == 0)
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
         && !pf.fixesValue()
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


Foam::scalar Foam::fv::meanVelocityGradient::findResponse
(
    const volVectorField& U
) const
{
    wordList patchTypes
    (
        U.boundaryField().size(), zeroGradientFvPatchScalarField::typeName
    );
    forAll(patchTypes, patchi)
    {
        const fvPatchVectorField& pf = U.boundaryField()[patchi];
        if (pf.coupled() || polyPatch::constraintType(pf.patch().type()))
        {
            patchTypes[patchi] = pf.patch().type();
        }
        else if (pf.fixesValue())
        {
            patchTypes[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }

    volScalarField w
    (
        IOobject(name_ + "_response", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimTime, Zero),
        patchTypes
    );
    const auto& nu = mesh_.lookupObject<volScalarField>("nu");

    const dimensionedScalar rate(1/mesh_.time().deltaT());
    fvScalarMatrix equation
    (
        (density() ? fvm::Sp(rate*(*density()), w) : fvm::Sp(rate, w))
      - fvm::laplacian(nu, w)
     == dimensionedScalar("one", dimless, 1)
    );

    dictionary solver;
    solver.add("solver", word("PCG"));
    solver.add("preconditioner", word("DIC"));
    solver.add("tolerance", 1e-14);
    solver.add("relTol", 1e-12);
    equation.solve(solver);

    return gSum(w.primitiveField()*mesh_.V())/gSum(mesh_.V());
}


const Foam::volScalarField* Foam::fv::meanVelocityGradient::density() const
{
    return mesh_.cfindObject<volScalarField>("densityFactor");
}


Foam::vector Foam::fv::meanVelocityGradient::meanOf
(
    const volVectorField& U
) const
{
    return gSum(U.primitiveField()*mesh_.V())/gSum(mesh_.V());
}


void Foam::fv::meanVelocityGradient::correct(volVectorField& U)
{
    adjust(U);
    corrected_ = mesh_.time().value();
}


void Foam::fv::meanVelocityGradient::beginStep()
{
    const label index = mesh_.time().timeIndex();
    if (index != index_)
    {
        start_ = {gradient_, mean_, fresh_};
        index_ = index;
    }
    else if (mesh_.time().value() < corrected_)
    {
        // The step is repeated and ends earlier (see repeatedStep)
        gradient_ = start_.gradient;
        mean_ = start_.mean;
        fresh_ = start_.fresh;
        corrected_ = -GREAT;
    }
}


void Foam::fv::meanVelocityGradient::adjust(const volVectorField& U)
{
    const scalar dt = mesh_.time().deltaTValue();
    if (mag(dt - responseStep_) > 0.1*responseStep_)
    {
        response_ = findResponse(U);
        responseStep_ = dt;
    }

    const vector mean(meanOf(U));
    const scalar dense =
        density()
      ? gSum(density()->primitiveField()*mesh_.V())/gSum(mesh_.V()) : 1;
    const vector kept
    (
        fresh_ ? vector::zero : dense*response_/dt*(mean - mean_)
    );
    gradient_ += heldDirections() & (Ubar_ - mean - kept)/response_;
    mean_ = mean;
    fresh_ = false;

    Info<< "Mean velocity = " << mean << ", pressure gradient = "
        << gradient_ << endl;

    setExact(state_, "gradient", gradient_);
    setExact(state_, "mean", mean_);
    setExact(state_, "response", response_);
    setExact(state_, "responseStep", responseStep_);
}


void Foam::fv::meanVelocityGradient::addSup
(
    fvMatrix<vector>& eqn,
    const label
)
{
    beginStep();
    if (fresh_)
    {
        adjust(mesh_.lookupObject<volVectorField>(fieldNames_[0]));
    }
    used_ = gradient_;
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
