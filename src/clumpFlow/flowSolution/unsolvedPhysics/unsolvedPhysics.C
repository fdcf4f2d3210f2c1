/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "unsolvedPhysics.H"
#include "foamCompat.H"
#include "fvOptionList.H"
#include "IOdictionary.H"
#include "jumpCyclicFvPatchFields.H"
#include "processorCyclicPolyPatch.H"
#include "Switch.H"
#include "volFields.H"

namespace
{

using namespace Foam;

//- A dictionary of the folder constant; empty where the file is absent
IOdictionary constantFile(const fvMesh& mesh, const word& name)
{
    return IOdictionary
    (
        IOobject
        (
            name, mesh.time().constant(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
}


//- fvMesh inherits several functions type()
const word& polyMeshType(const polyMesh& mesh)
{
    return mesh.type();
}


//- A switch, what the solver does, and why
struct fixedSwitch
{
    const char* name;
    const bool value;
    const char* reason;
};

const fixedSwitch fixedSwitches[] =
{
    {"solveFlow", true, "'effects { fluid frozen; }' in clumpProperties keeps U of"
        " the start time"},
    {"frozenFlow", false, "'effects { fluid frozen; }' in clumpProperties keeps U of"
        " the start time"},
    {"SIMPLErho", false, "the fluid is incompressible"},
    {"transonic", false, "the fluid is incompressible"},
    {"turbOnFinalIterOnly", false, "there is no turbulence model, and the viscosity"
        " is updated in every outer corrector"},
    {"ddtCorr", true, "the fluxes always have the correction for the time derivative"},
    {"correctPhi", false, "after a change of the mesh the fluxes are those of U, and the"
        " momentum equation subtracts their divergence"},
    {"checkMeshCourantNo", false, "the Courant number is that of the flow over the mesh"},
    {"moveMeshOuterCorrectors", false, "the points of the mesh move once in a step"}
};

}


void Foam::unsolvedPhysics::refuse(const fvMesh& mesh)
{
    const IOdictionary transport(constantFile(mesh, "transportProperties"));
    if (!transport.found("transportModel"))
    {
        FatalIOErrorInFunction(transport)
            << "Entry 'transportModel' is missing (cases of icoFoam have none). Add"
            << " the line" << nl << "    transportModel Newtonian;"
            << exit(FatalIOError);
    }
    const IOdictionary turbulence(constantFile(mesh, "turbulenceProperties"));
    if (turbulence.empty())
    {
        FatalErrorInFunction
            << "There is no " << turbulence.objectPath() << " (cases of icoFoam have"
            << " none). Write it with the header of another dictionary and the line"
            << nl << "    simulationType laminar;" << exit(FatalError);
    }
    const word simulation
    (
        turbulence.getOrDefault<word>("simulationType", "laminar")
    );
    if (simulation == "RAS" || simulation == "LES")
    {
        FatalIOErrorInFunction(turbulence)
            << "Entry 'simulationType' is " << simulation << ", but clumps are coupled"
            << " to the resolved flow with the viscosity of the fluid; a turbulent"
            << " viscosity would act on the flow and not on them." << nl
            << "    Set simulationType laminar and resolve the flow."
            << exit(FatalIOError);
    }

    const dictionary laminar(turbulence.subOrEmptyDict("laminar"));
    const word model
    (
        laminar.getOrDefault<word>
        (
            "model", laminar.getOrDefault<word>("laminarModel", "Stokes")
        )
    );
    if (model != "Stokes")
    {
        FatalIOErrorInFunction(laminar)
            << "The laminar model is " << model << ", whose stress does not act on"
            << " clumps. Valid: Stokes (the default). A viscosity that depends on the"
            << " shear rate is a transportModel in constant/transportProperties."
            << exit(FatalIOError);
    }

    const IOdictionary mrf(constantFile(mesh, "MRFProperties"));
    for (const entry& e : mrf)
    {
        if (e.isDict() && e.dict().getOrDefault<bool>("active", true))
        {
            FatalIOErrorInFunction(mrf)
                << "The zone " << e.keyword() << " rotates (MRF), but the solver"
                << " computes neither the forces of a rotating frame on the flow nor"
                << " those on clumps." << nl << "    Remove the file, or set active no."
                << exit(FatalIOError);
        }
    }
}


void Foam::unsolvedPhysics::refuseMotion(const fvMesh& mesh)
{
    FatalErrorInFunction
        << "The points of the mesh move while it is refined: " << polyMeshType(mesh)
        << " in " << mesh.time().constant()/"dynamicMeshDict" << '.' << nl
        << "    Use a mesh that is refined (clumpRefineFvMesh) or one whose points move"
        << " (dynamicMotionSolverFvMesh)." << exit(FatalError);
}


void Foam::unsolvedPhysics::refuseSwitches(const dictionary& control)
{
    for (const fixedSwitch& s : fixedSwitches)
    {
        if (control.getOrDefault<bool>(s.name, s.value) != s.value)
        {
            FatalIOErrorInFunction(control)
                << "Entry '" << s.name << "' is " << Switch(!s.value)
                << "; valid: " << Switch(s.value) << ", because " << s.reason
                << ". Remove the entry." << exit(FatalIOError);
        }
    }
}


void Foam::unsolvedPhysics::refuseSplitJumps(const volScalarField& p)
{
    label split = -1;
    for (const polyPatch& pp : p.mesh().boundaryMesh())
    {
        if (isA<processorCyclicPolyPatch>(pp))
        {
            const label half = refCast<const processorCyclicPolyPatch>(pp).referPatchID();
            if (isA<jumpCyclicFvPatchScalarField>(p.boundaryField()[half]))
            {
                split = half;
            }
        }
    }
    reduce(split, maxOp<label>());
    if (split >= 0)
    {
        const polyPatch& half = p.mesh().boundaryMesh()[split];
        FatalErrorInFunction
            << "Field p has a jump (" << p.boundaryField()[split].type() << ") at patch "
            << half.name() << ", but its faces and their counterparts are on different"
            << " processors, where OpenFOAM forgets the jump." << nl
            << "    Decompose the case with this entry in system/decomposeParDict:" << nl
            << "    constraints { pairs { type preservePatches; patches (" << half.name()
            << ' ' << refCast<const cyclicPolyPatch>(half).neighbPatchName() << "); } }"
            << exit(FatalError);
    }
}


void Foam::unsolvedPhysics::refuseSplitPairs(const fvMesh& mesh, const char* what)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    labelList split(patches.nNonProcessor(), 0);
    for (const polyPatch& pp : patches)
    {
        if (isA<processorCyclicPolyPatch>(pp))
        {
            const cyclicPolyPatch& half = refCast<const cyclicPolyPatch>
            (
                refCast<const processorCyclicPolyPatch>(pp).referPatch()
            );
            split[half.index()] = 1;
            split[half.neighbPatchID()] = 1;
        }
    }
    reduceList(split, maxEqOp<label>());

    string names;
    forAll(split, patchi)
    {
        if (split[patchi])
        {
            names += (names.empty() ? "" : " ") + patches[patchi].name();
        }
    }
    if (!names.empty())
    {
        FatalErrorInFunction
            << "The mesh cannot " << what << ", since faces of the cyclic patches "
            << names.c_str() << " and their counterparts are on different"
            << " processors." << nl
            << "    Decompose the case with this entry in system/decomposeParDict:"
            << nl
            << "    constraints { pairs { type preservePatches; patches ("
            << names.c_str() << "); } }" << exit(FatalError);
    }
}


void Foam::unsolvedPhysics::refuseDriving(const PtrList<fv::option>& options)
{
    for (const fv::option& option : options)
    {
        const word& type = option.type();
        const bool holds =
            type == "meanVelocityForce" || type == "patchMeanVelocityForce";
        if (option.active() && holds)
        {
            FatalErrorInFunction
                << "The fvOption " << option.name() << " is a " << type << ", which does"
                << " not know how the viscosity and the clumps hold the flow back: the mean"
                << " velocity oscillates, and grows where nu dt/dx^2 is above 1/6." << nl
                << "    Set type meanVelocityGradient, with the same Ubar and fields, and"
                << " remove relaxation and patch." << exit(FatalError);
        }
    }
}
