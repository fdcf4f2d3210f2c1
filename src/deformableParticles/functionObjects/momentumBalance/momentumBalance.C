/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "momentumBalance.H"
#include "deformableCloud.H"
#include "meanVelocityGradient.H"
#include "fvOptions.H"
#include "fvcDiv.H"
#include "surfaceFields.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(momentumBalance, 0);
    addToRunTimeSelectionTable(functionObject, momentumBalance, dictionary);
}
}


namespace
{

using namespace Foam;

functionObjects::tableHeader header()
{
    functionObjects::tableHeader result
    (
        "Momentum of clumps and fluid over a step"
    );
    result.add("time", "s");
    for
    (
        const char* term :
        {
            "clumpsRate", "fluid", "interior", "coupling", "applied",
            "fluidRate", "forcing", "patches", "sources"
        }
    )
    {
        result.addVector(term, "N");
    }
    for
    (
        const char* error :
        {
            "thirdLawError", "clumpsError", "fluidError", "couplingError",
            "totalError"
        }
    )
    {
        result.add(error);
    }
    return result;
}

}


Foam::functionObjects::momentumBalance::momentumBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, typeName)
{
    read(dict);
}


bool Foam::functionObjects::momentumBalance::read(const dictionary& dict)
{
    checkEntries(dict, {"cloud"}, functionObjectEntries());
    cloudName_ = deformableCloud::findName(mesh_, dict);
    return fvMeshFunctionObject::read(dict) && table_.read(dict);
}


Foam::vector Foam::functionObjects::momentumBalance::patchForces
(
    const bool convection,
    scalar& size
) const
{
    const auto& U = mesh_.lookupObject<volVectorField>("U");
    const auto& p = mesh_.lookupObject<volScalarField>("p");
    const auto& phi = mesh_.lookupObject<surfaceScalarField>("phi");
    const auto& nu = mesh_.lookupObject<volScalarField>("nu");

    vector result(Zero);
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.coupled())
        {
            continue;
        }
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const vector pressure
        (
            -gSum(p.boundaryField()[patchi]*patch.Sf())
        );
        const vector viscous
        (
            gSum(nu.boundaryField()[patchi]*patch.magSf()*Up.snGrad())
        );
        vector carried(Zero);
        if (convection)
        {
            carried = -gSum(phi.boundaryField()[patchi]*Up);
        }
        result += pressure + viscous + carried;
        size += mag(pressure) + mag(viscous) + mag(carried);
    }
    return result;
}


Foam::vector Foam::functionObjects::momentumBalance::sources
(
    const bool convection,
    scalar& size
) const
{
    const auto& U = mesh_.lookupObject<volVectorField>("U");
    const scalarField& V = mesh_.V();
    vector result(Zero);

    if (convection)
    {
        const auto& phi = mesh_.lookupObject<surfaceScalarField>("phi");
        result = gSum(V*fvc::div(phi)().primitiveField()*U.primitiveField());
        size += mag(result);
    }

    PtrList<fv::option>& options = fv::options::New(mesh_);
    for (fv::option& option : options)
    {
        const label fieldi = option.applyToField(U.name());
        if (fieldi < 0 || !option.isActive())
        {
            continue;
        }

        vector force(Zero);
        if (isA<fv::meanVelocityGradient>(option))
        {
            const auto& drive = refCast<const fv::meanVelocityGradient>(option);
            for (const label celli : drive.cells())
            {
                force += V[celli]*drive.used();
            }
            reduce(force, sumOp<vector>());
        }
        else
        {
            fvVectorMatrix matrix(U, U.dimensions()*dimVolume/dimTime);
            option.addSup(matrix, fieldi);
            vectorField source(-matrix.source());
            if (matrix.hasDiag())
            {
                source += matrix.diag()*U.primitiveField();
            }
            force = gSum(source);
        }
        result += force;
        size += mag(force);
    }
    return result;
}


bool Foam::functionObjects::momentumBalance::write()
{
    if (functionObject::postProcess)
    {
        Info<< name() << ": the momentum over a step is known in the run only;"
            << " no table is written" << endl;
        return true;
    }
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    if (!cloud.coupled())
    {
        return true;
    }

    const scalar rho = cloud.fluidDensity();
    const auto& U = mesh_.lookupObject<volVectorField>("U");
    const bool convection = cloud.effects().active("convection");

    scalar onSpheres = 0;
    for (const clumpParcel& p : cloud)
    {
        onSpheres += sum(mag(p.fluidForces()));
    }
    reduce(onSpheres, sumOp<scalar>());

    clumpMomentum clumps(cloud.momentum());
    for
    (
        vector* term :
        {
            &clumps.rate, &clumps.fluid, &clumps.interior, &clumps.coupling,
            &clumps.applied
        }
    )
    {
        reduce(*term, sumOp<vector>());
    }

    const vector rate
    (
        rho*gSum
        (
            mesh_.V()*(U.primitiveField() - U.oldTime().primitiveField())
        )/time_.deltaTValue()
    );
    const vector forcing(cloud.boundary().forceOnFluid(U, rho));
    scalar onFluid = 0;
    const vector patches(rho*patchForces(convection, onFluid));
    const vector source(rho*sources(convection, onFluid));

    const vector ofClumps
    (
        clumps.rate - clumps.fluid - clumps.interior - clumps.coupling
      - clumps.applied
    );
    const vector ofFluid(rate - forcing - patches - source);

    // In a first step from rest the rates may be all there is
    scalar size = max(onSpheres + rho*onFluid, VSMALL);
    for (const vector& F : {clumps.rate, clumps.applied, rate, forcing})
    {
        size = max(size, mag(F));
    }

    if (Pstream::master())
    {
        Ostream& os = table_.open(header());
        os  << time_.timeOutputValue();
        for
        (
            const vector& F :
            {
                clumps.rate, clumps.fluid, clumps.interior, clumps.coupling,
                clumps.applied, rate, forcing, patches, source
            }
        )
        {
            os  << '\t' << F.x() << '\t' << F.y() << '\t' << F.z();
        }
        for
        (
            const vector& F :
            {
                clumps.fluid + forcing, ofClumps, ofFluid, clumps.coupling,
                ofClumps + ofFluid + clumps.fluid + forcing + clumps.coupling
            }
        )
        {
            os  << '\t' << mag(F)/size;
        }
        os  << nl;
        table_.flush();
    }

    return true;
}
