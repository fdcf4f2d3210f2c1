/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "incompressibleFlow.H"
#include "coupledPatches.H"
#include "fluidsInside.H"
#include "ignoreOverflow.H"
#include "checkedEntries.H"
#include "findRefCell.H"
#include "fvcDdt.H"
#include "fvcDiv.H"
#include "fvcFlux.H"
#include "fvcGrad.H"
#include "fvcMeshPhi.H"
#include "fvmDdt.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"
#include "initialPressure.H"
#include "linear.H"
#include "meshMotion.H"
#include "mirroredValues.H"
#include "solverSettings.H"
#include "turnedMomentum.H"
#include "unsolvedPhysics.H"

void Foam::incompressibleFlow::check(const dictionary& dict)
{
    checkEntries
    (
        withoutRemoved(dict, {"scaleCorrection"}),
        {
            "consistent", "momentumPredictor", "nOuterCorrectors",
            "carryPressure", "wallMobility", "couplingTolerance", "andersonDepth",
            "nCorrectors", "nNonOrthogonalCorrectors", "pRefCell",
            "pRefPoint", "pRefValue", "solveFlow", "SIMPLErho", "transonic",
            "frozenFlow", "ddtCorr", "turbOnFinalIterOnly",
            "finalOnLastPimpleIterOnly", "residualControl",
            "outerCorrectorResidualControl", "correctPhi",
            "checkMeshCourantNo", "moveMeshOuterCorrectors"
        }
    );
    unsolvedPhysics::refuseSwitches(dict);
    for (const word key : {"nOuterCorrectors", "nCorrectors"})
    {
        if (dict.found(key))
        {
            getNumber(dict, key, 1, 1000);
        }
    }
    for (const word key : {"nNonOrthogonalCorrectors", "andersonDepth"})
    {
        if (dict.found(key))
        {
            getNumber(dict, key, 0, 1000);
        }
    }
    if (dict.found("couplingTolerance"))
    {
        getNonNegative(dict, "couplingTolerance");
    }
}


namespace
{

using namespace Foam;

//- Beyond this no flow is physical, in any unit of U, p and phi, and products
//  with it stay finite
constexpr scalar largestInFlow = 1e15;

template<class Type>
bool reasonable(const UList<Type>& values, label& at)
{
    forAll(values, i)
    {
        for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
        {
            const scalar x = component(values[i], d);
            if (!std::isfinite(x) || mag(x) > largestInFlow)
            {
                at = i;
                return false;
            }
        }
    }
    return true;
}


//- Fatal where a value that was read is infinite, not a number or far too large
template<class FieldType>
void refuseUnphysical(const FieldType& field)
{
    label at = -1;
    string where;
    if (!reasonable(field.primitiveField(), at))
    {
        where = "the internal field, entry " + name(at);
    }
    forAll(field.boundaryField(), patchi)
    {
        if (where.empty() && !reasonable(field.boundaryField()[patchi], at))
        {
            where =
                "patch " + field.boundaryField()[patchi].patch().name()
              + ", face " + name(at);
        }
    }
    if (!where.empty())
    {
        FatalErrorInFunction
            << "file " << field.objectPath() << ": " << where.c_str()
            << " is outside the physical range, " << -largestInFlow << " to "
            << largestInFlow << exit(FatalError);
    }
}

}


void Foam::incompressibleFlow::readFields(const fvMesh& mesh)
{
    // What is too large for the machine becomes infinite, and is refused here
    const ignoreOverflow overflow;
    const auto file = [&](const char* name)
    {
        Info<< "Reading field " << name << endl;
        return IOobject
        (
            name, mesh.time().timeName(), mesh,
            IOobject::MUST_READ, IOobject::AUTO_WRITE
        );
    };
    p_.reset(new volScalarField(file("p"), mesh));
    U_.reset(new volVectorField(file("U"), mesh));

    if
    (
        U_->dimensions() != dimVelocity || p_->dimensions() != sqr(dimVelocity)
    )
    {
        FatalErrorInFunction
            << "The dimensions of " << U_->objectPath() << ' ' << U_->dimensions()
            << " and " << p_->objectPath() << ' ' << p_->dimensions()
            << "; they must be " << dimVelocity << " and " << sqr(dimVelocity)
            << exit(FatalError);
    }
    refuseUnphysical(*U_);
    refuseUnphysical(*p_);
    unsolvedPhysics::refuseSplitJumps(*p_);
}


void Foam::incompressibleFlow::startFields(const fvMesh& mesh)
{
    Info<< "Reading/calculating face flux field phi" << nl << endl;
    const IOobject file
    (
        "phi", mesh.time().timeName(), mesh,
        IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
    );
    {
        const ignoreOverflow overflow;
        phi_.reset(new surfaceScalarField(file, fvc::flux(*U_)));
        refuseUnphysical(*phi_);
    }

    // Boundary conditions may look up phi
    const bool goesOn =
        IOobject(file).typeHeaderOk<surfaceScalarField>(true);
    if (goesOn && mesh.moving())
    {
        // A wall that moves has had its velocity in the step before
        evaluateCoupled(U_->boundaryFieldRef(false));
        p_->correctBoundaryConditions();
    }
    else if (Pstream::parRun() || !goesOn)
    {
        U_->correctBoundaryConditions();
        p_->correctBoundaryConditions();
    }
    if (!goesOn)
    {
        *phi_ = fvc::flux(*U_);
        setInitialPressure(*p_);
    }
    if (meshMotion::moves(mesh))
    {
        const IOobject faceFile
        (
            "Uf", mesh.time().timeName(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        );
        Uf_.reset(new surfaceVectorField(faceFile, fvc::interpolate(*U_)));
        if (!IOobject(faceFile).typeHeaderOk<surfaceVectorField>(true))
        {
            keepFaceVelocity();
        }
    }
}


void Foam::incompressibleFlow::readModels()
{
    transport_.reset(new singlePhaseTransportModel(*U_, *phi_));

    if (!Newtonian())
    {
        // A run goes on with the viscosity of its last momentum equation
        IOobject kept
        (
            "nu", U_->time().timeName(), U_->mesh(), IOobject::MUST_READ,
            IOobject::NO_WRITE, false
        );
        if (kept.typeHeaderOk<volScalarField>(true))
        {
            U_->mesh().lookupObjectRef<volScalarField>("nu") ==
                volScalarField(kept, U_->mesh());
        }
    }
    const scalar least = gMin(nu().primitiveField());
    if (!(least > 0))
    {
        FatalIOErrorInFunction(*transport_)
            << "The kinematic viscosity is " << least << " m2/s; it must be above"
            << " zero." << exit(FatalIOError);
    }
    turbulence_ =
        incompressible::turbulenceModel::New(*U_, *phi_, *transport_);

    options_ = &fv::options::New(U_->mesh());
    if (!options_->optionList::size())
    {
        Info<< "No finite volume options present" << endl;
    }
}


Foam::incompressibleFlow::incompressibleFlow
(
    fvMesh& mesh,
    const bool present,
    const bool solved,
    const bool iterates
)
:
    solved_(present && solved),
    fluids_(nullptr),
    options_(nullptr),
    pRefCell_(0),
    pRefValue_(0)
{
    if (!present)
    {
        return;
    }
    unsolvedPhysics::refuse(mesh);
    refuseMisspelt
    (
        mesh.solutionDict(),
        {"PISO", "PIMPLE", "SIMPLE", "solvers", "relaxationFactors", "accuracyLevel"}
    );
    check
    (
        mesh.solutionDict().subOrEmptyDict(outerCorrectors::dictionaryName(mesh))
    );
    control_.reset(new outerCorrectors(mesh, iterates));

    patchStress_.reset(new patchStress(mesh));
    readFields(mesh);
    startFields(mesh);
    setRefCell(*p_, control_->dict(), pRefCell_, pRefValue_);
    mesh.setFluxRequired(p_->name());
    readModels();

    if (solved_)
    {
        unsolvedPhysics::refuseDriving(*options_);
        solverSettings::check(*p_);
        solverSettings::check(*U_, iterates);
        if (control_->dict().getOrDefault<Switch>("carryPressure", true))
        {
            carried_.reset(new carriedPressure(*p_, pRefCell_));
        }
        carriedU_.reset(new carriedVelocity(*U_));
        if (control_->dict().getOrDefault<Switch>("wallMobility", true))
        {
            mobility_.reset(new wallMobility(*U_));
        }
    }
}


const Foam::volScalarField& Foam::incompressibleFlow::nu() const
{
    return
        U_.valid()
      ? U_->mesh().lookupObject<volScalarField>("nu")
      : volScalarField::null();
}


Foam::scalar Foam::incompressibleFlow::leastNu() const
{
    // Not that of the field rho: before the first step, and after a restart, there is none
    const scalar densest = fluids_ ? fluids_->densest() : 1;
    return gMin(nu().primitiveField())/densest;
}


void Foam::incompressibleFlow::setFluids(const fluidsInside* fluids)
{
    fluids_ = fluids;
    if (solved_ && fluids && fluids->viscosity())
    {
        variable_.reset(new variableViscosity(*U_, *fluids));
    }
}


Foam::tmp<Foam::volScalarField> Foam::incompressibleFlow::viscosity() const
{
    if (fluids_ && fluids_->viscosity())
    {
        return *fluids_->viscosity()*nu();
    }
    return nu();
}


const Foam::volScalarField* Foam::incompressibleFlow::densityRatio() const
{
    return fluids_ ? fluids_->density() : nullptr;
}


Foam::tmp<Foam::volScalarField> Foam::incompressibleFlow::dense
(
    const volScalarField& field
) const
{
    if (const volScalarField* density = densityRatio())
    {
        return *density*field;
    }
    return field;
}


Foam::vector Foam::incompressibleFlow::excessInertia() const
{
    const volScalarField* density = densityRatio();
    if (!density)
    {
        return Zero;
    }
    const volVectorField& U = *U_;
    vectorField rate
    (
        (U.primitiveField() - U.oldTime().primitiveField())/U.time().deltaTValue()
    );
    if (carriedU_->active())
    {
        rate += carriedU_->rate().primitiveField();
    }
    if (convecting_.valid())
    {
        rate +=
            fvc::div(*convecting_, U, "div(phi,U)")().primitiveField()
          - fvc::div(*convecting_)().primitiveField()*U.primitiveField();
    }
    return sum(U.mesh().V()*(density->primitiveField() - 1)*rate);
}


void Foam::incompressibleFlow::solveMomentum(fvVectorMatrix& UEqn)
{
    const volVectorField gradp(fvc::grad(*p_));
    if (variable_.valid())
    {
        variable_->solve(UEqn, gradp);
        variable_->setStress(*patchStress_);
    }
    else
    {
        turnedMomentum::solve(UEqn, gradp, UEqn.solverDict());
    }
}


Foam::tmp<Foam::fvVectorMatrix> Foam::incompressibleFlow::viscousStress()
{
    if (variable_.valid())
    {
        tmp<fvVectorMatrix> result(variable_->stress(viscosity()));
        variable_->setStress(*patchStress_);
        return result;
    }
    const volScalarField nuEff(turbulence_->nuEff());
    const surfaceScalarField onFaces(linearInterpolate(nuEff));
    if (Newtonian())
    {
        patchStress_->set(onFaces, vector::zero);
        return -fvm::laplacian(onFaces, *U_, "laplacian(nuEff,U)");
    }
    volTensorField gradU("gradU", fvc::grad(*U_));
    setMirroredValues(gradU, *U_);
    return viscousStress(onFaces, nuEff, gradU);
}


Foam::tmp<Foam::fvVectorMatrix> Foam::incompressibleFlow::viscousStress
(
    const surfaceScalarField& onFaces,
    const volScalarField& nu,
    const volTensorField& gradU
)
{
    const surfaceVectorField rest
    (
        nu.mesh().Sf() & linearInterpolate(nu*dev2(T(gradU)))
    );
    patchStress_->set(onFaces, rest);
    return -fvm::laplacian(onFaces, *U_, "laplacian(nuEff,U)") - fvc::div(rest);
}


void Foam::incompressibleFlow::carryPressure(const volVectorField& d)
{
    carried_->carry(d, p_->mesh().solverDict(p_->select(false)));
}


void Foam::incompressibleFlow::carryVelocity
(
    const volVectorField& d,
    const scalar diameter
)
{
    carriedU_->carry(d, diameter, leastNu());
}


Foam::tmp<Foam::fvVectorMatrix> Foam::incompressibleFlow::dense
(
    tmp<fvVectorMatrix> matrix
) const
{
    if (const volScalarField* density = densityRatio())
    {
        return *density*matrix;
    }
    return matrix;
}


Foam::tmp<Foam::fvVectorMatrix> Foam::incompressibleFlow::timeDerivative()
{
    convecting_.clear();
    return dense
    (
        carriedU_->active()
      ? fvm::ddt(*U_) + carriedU_->rate()
      : fvm::ddt(*U_)
    );
}


Foam::tmp<Foam::fvVectorMatrix> Foam::incompressibleFlow::convection
(
    tmp<surfaceScalarField> flux
)
{
    convecting_.reset
    (
        new surfaceScalarField
        (
            "over",
            carriedU_->active() ? flux - carriedU_->flux() : flux
        )
    );

    // Set anew in every outer corrector: a change of the mesh need not map it
    convecting_->checkOut();

    // Inside a dilating clump div(phi) is not zero
    tmp<volScalarField> divergence(fvc::div(*convecting_));
    if (Uf_.valid())
    {
        // The change of volumes, with the scheme of the time derivative
        divergence.ref() += fvc::ddt
        (
            dimensionedScalar(U_->name(), dimless, 1), U_->mesh()
        );
    }
    return dense
    (
        fvm::div(*convecting_, *U_, "div(phi,U)") - fvm::Sp(divergence, *U_)
    );
}


Foam::tmp<Foam::surfaceScalarField> Foam::incompressibleFlow::ddtCorr() const
{
    return Uf_.valid() ? fvc::ddtCorr(*U_, *Uf_) : fvc::ddtCorr(*U_, *phi_);
}


Foam::tmp<Foam::surfaceScalarField> Foam::incompressibleFlow::sweptFlux() const
{
    return -fvc::meshPhi(*U_);
}


void Foam::incompressibleFlow::makeRelative()
{
    if (Uf_.valid())
    {
        fvc::makeRelative(*phi_, *U_);
    }
}


void Foam::incompressibleFlow::pointsMoved()
{
    U_->correctBoundaryConditions();

    const fvMesh& mesh = U_->mesh();
    surfaceScalarField& phi = *phi_;
    phi = mesh.Sf() & Uf_->oldTime();
    forAll(phi.boundaryField(), patchi)
    {
        if (!mesh.boundary()[patchi].coupled())
        {
            phi.boundaryFieldRef()[patchi] =
                mesh.boundary()[patchi].Sf() & U_->boundaryField()[patchi];
        }
    }
    makeRelative();
    if (carried_.valid())
    {
        carried_->meshChanged();
    }
    if (mobility_.valid())
    {
        mobility_->meshChanged();
    }
}


void Foam::incompressibleFlow::keepFaceVelocity()
{
    const fvMesh& mesh = U_->mesh();
    surfaceVectorField& Uf = *Uf_;
    Uf = fvc::interpolate(*U_);
    const surfaceVectorField n(mesh.Sf()/mesh.magSf());
    Uf += n*(fvc::absolute(*phi_, *U_)/mesh.magSf() - (n & Uf));
}


void Foam::incompressibleFlow::meshChanged()
{
    *phi_ = fvc::flux(*U_);
    phi_->oldTime() = fvc::flux(U_->oldTime());
    if (Newtonian())
    {
        // The mean of eight equal values differs from them by round-off
        U_->mesh().lookupObjectRef<volScalarField>("nu") ==
            dimensionedScalar("nu", dimViscosity, *transport_);
    }
    if (carried_.valid())
    {
        carried_->meshChanged();
    }
    if (mobility_.valid())
    {
        mobility_->meshChanged();
    }
}


Foam::tmp<Foam::volScalarField> Foam::incompressibleFlow::pressureMobility
(
    tmp<volScalarField> tA
)
{
    if (mobility_.valid())
    {
        tA.ref() += mobility_->resistance(nu());
    }
    return 1/tA;
}


void Foam::incompressibleFlow::reset()
{
    U_->primitiveFieldRef() = Zero;
    U_->correctBoundaryConditions();
    U_->oldTime() == *U_;
    *p_ = dimensionedScalar(p_->dimensions(), Zero);
    *phi_ = fvc::flux(*U_);
    phi_->oldTime() == *phi_;
}
