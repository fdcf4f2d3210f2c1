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
#include "checkedEntries.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(meanVelocityGradient, 0);
    addToRunTimeSelectionTable(option, meanVelocityGradient, dictionary);
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
    cellSetOption(sourceName, modelType, dict, mesh),
    Ubar_(Zero),
    direction_(Zero),
    gradient_(0),
    used_(0),
    mean_(0),
    response_(0),
    responseStep_(0),
    fresh_(true),
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
    coeffs_.readEntry("fields", fieldNames_);
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
    checkEntries(dict, {"Ubar", typeName + "Coeffs"}, fvOptionEntries());
    readMeanVelocity();
    refuseOthers(dict);

    if (state_.headerOk())
    {
        state_.readEntry("gradient", gradient_);
        mean_ = state_.getOrDefault("mean", mag(Ubar_));
        state_.readIfPresent("response", response_);
        state_.readIfPresent("responseStep", responseStep_);
        fresh_ = false;
    }
}


void Foam::fv::meanVelocityGradient::readMeanVelocity()
{
    Ubar_ = getFinite<vector>(coeffs_, "Ubar");
    if (mag(Ubar_) < VSMALL)
    {
        FatalIOErrorInFunction(coeffs_)
            << "Entry 'Ubar' must not be zero." << exit(FatalIOError);
    }
    direction_ = Ubar_/mag(Ubar_);

    if (!returnReduce(flowsFreely(), orOp<bool>()))
    {
        FatalIOErrorInFunction(coeffs_)
            << "Entry 'Ubar' is " << Ubar_ << ", but the boundary conditions fix"
            << " the mean velocity in this direction: no cyclic patches repeat"
            << " along it, and " << fieldNames_[0] << " is fixed on all other"
            << " patches. The gradient would grow without limit."
            << exit(FatalIOError);
    }
}


bool Foam::fv::meanVelocityGradient::flowsFreely() const
{
    const auto& U = mesh_.lookupObject<volVectorField>(fieldNames_[0]);
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        const polyPatch& patch = pf.patch().patch();
        if (isA<coupledPolyPatch>(patch))
        {
            const auto& pair = refCast<const coupledPolyPatch>(patch);
            for (const vector& s : pair.separation())
            {
                if (mag(s & direction_) > 1e-6*mag(s))
                {
                    return true;
                }
            }
            if (!pair.parallel())
            {
                return true;
            }
        }
        else if
        (
            !polyPatch::constraintType(patch.type())
         && !isA<basicSymmetryFvPatchVectorField>(pf)
         && !pf.fixesValue()
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::fv::meanVelocityGradient::refuseOthers(const dictionary& dict) const
{
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
        const vector Ubar
        (
            other.optionalSubDict(typeName + "Coeffs").get<vector>("Ubar")
        );
        if (mag(Ubar & direction_) > 1e-6*mag(Ubar))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'Ubar' is " << Ubar_ << " in " << name_ << " and "
                << Ubar << " in " << e.keyword() << ". Both hold the mean"
                << " velocity in the same direction, and their gradients would"
                << " grow without limit. Remove one of them."
                << exit(FatalIOError);
        }
    }
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

    fvScalarMatrix equation
    (
        fvm::Sp(1/mesh_.time().deltaT(), w) - fvm::laplacian(nu, w)
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


Foam::scalar Foam::fv::meanVelocityGradient::meanOf
(
    const volVectorField& U
) const
{
    return
        gSum((U.primitiveField() & direction_)*mesh_.V())/gSum(mesh_.V());
}


void Foam::fv::meanVelocityGradient::correct(volVectorField& U)
{
    const scalar dt = mesh_.time().deltaTValue();
    if (mag(dt - responseStep_) > 0.1*responseStep_)
    {
        response_ = findResponse(U);
        responseStep_ = dt;
    }

    const scalar mean = meanOf(U);
    const scalar kept = fresh_ ? 0 : response_/dt*(mean - mean_);
    gradient_ += (mag(Ubar_) - mean - kept)/response_;
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
    if (fresh_)
    {
        correct(mesh_.lookupObjectRef<volVectorField>(fieldNames_[0]));
    }
    used_ = gradient_;
    for (const label celli : cells_)
    {
        eqn.source()[celli] -= mesh_.V()[celli]*gradient_*direction_;
    }
}


bool Foam::fv::meanVelocityGradient::read(const dictionary& dict)
{
    if (cellSetOption::read(dict))
    {
        readMeanVelocity();
        return true;
    }
    return false;
}
