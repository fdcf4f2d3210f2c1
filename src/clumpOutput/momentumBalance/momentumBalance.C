/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "momentumBalance.H"
#include "clumpMotion.H"
#include "clumpTotals.H"
#include "deformableCloud.H"
#include "fluidCoupling.H"
#include "meanVelocityGradient.H"
#include "fvOptions.H"
#include "patchStress.H"
#include "sourcesInBodies.H"
#include "symmetryPlanes.H"
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

functionObjects::tableHeader balanceColumns()
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
    result.addVector("momentum", "N.s");
    result.addVector("impulse", "N.s");
    result.add("integralError");

    const auto of = [](const string& name)
    {
        return name + "x " + name + "y " + name + "z";
    };
    result
       .explain("time " + of("clumpsRate"), "change of momentum of the clumps per time:"
            " the sum of the next four")
       .explain(of("fluid") + ' ' + of("interior"), "force of the fluid on the spheres,"
            " and inertia of the fluid inside them")
       .explain(of("coupling") + ' ' + of("applied"), "force of the coupling scheme, and"
            " contacts, loads and gravity")
       .explain(of("fluidRate"), "change of momentum of the fluid per time: the sum of the"
            " next three")
       .explain(of("forcing") + ' ' + of("patches") + ' ' + of("sources"), "force of the"
            " clumps, pressure and stress on the patches, fvOptions")
       .explain("thirdLawError", "|fluid + forcing|, along the planes of symmetry where"
            " there are any; as all errors over the sum of the magnitudes of all forces")
       .explain("clumpsError fluidError couplingError totalError", "of the two balances,"
            " |coupling|, and of the sum of both balances")
       .explain(of("momentum") + ' ' + of("impulse"), "of fluid and clumps, and of applied,"
            " patches and sources since the start of the run")
       .explain("integralError", "difference of this impulse and the change of the"
            " momentum");
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
    table_(mesh_, name, typeName),
    fluidRate_(Zero),
    forcing_(Zero),
    patches_(Zero),
    sources_(Zero),
    size_(0),
    along_(symmetryPlanes(mesh_.boundaryMesh()).along()),
    start_(Zero),
    momentum_(Zero),
    impulse_(Zero),
    impulseSize_(0)
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
    const auto& stress = mesh_.lookupObject<patchStress>(patchStress::typeName);

    // What a force is compared with depends neither on the level of the pressure nor on
    // the frame of reference
    scalar level = 0;
    scalar area = 0;
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!patch.coupled())
        {
            level += sum(p.boundaryField()[patch.index()]*patch.magSf());
            area += sum(patch.magSf());
        }
    }
    reduce(level, sumOp<scalar>());
    reduce(area, sumOp<scalar>());
    level /= max(area, VSMALL);
    const vector mean(U().weightedAverage(mesh_.V()).value());

    vector result(Zero);
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.coupled())
        {
            continue;
        }
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const vector S(gSum(patch.Sf()));
        const vector pressure
        (
            -gSum(p.boundaryField()[patchi]*patch.Sf())
        );
        const vector viscous(gSum(stress.implicitPart(Up)));
        result += pressure + viscous;
        size += mag(pressure + level*S) + mag(viscous);
        if (convection)
        {
            const vector carried(-gSum(phi.boundaryField()[patchi]*Up));
            result += carried;
            size += mag(carried + gSum(phi.boundaryField()[patchi])*mean);
        }
    }
    const vector rest(stress.explicitPart());
    size += mag(rest);
    return result + rest;
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
        const scalarField gain(V*fvc::div(phi)().primitiveField());
        const vector mean(U().weightedAverage(mesh_.V()).value());
        result = gSum(gain*U.primitiveField());
        size += mag(result - gSum(gain)*mean);
    }

    const volScalarField& lambda =
        mesh_.lookupObject<deformableCloud>(cloudName_).boundary().solidFraction();
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
                force += V[celli]*drive.gradient();
            }
            reduce(force, sumOp<vector>());
        }
        else
        {
            const vectorField source
            (
                sourcesInBodies::force(option, fieldi, U, lambda)
            );
            force = gSum(source);
        }
        result += force;
        size += mag(force);
    }
    return result;
}


void Foam::functionObjects::momentumBalance::findTerms
(
    const deformableCloud& cloud
)
{
    const scalar rho = cloud.fluidDensity();
    const scalar dt = time_.deltaTValue();
    const scalarField& V = mesh_.V();
    const auto& U = mesh_.lookupObject<volVectorField>("U");
    const bool convection = cloud.effects().active("convection");

    clumps_ = cloud.motion().momentum();
    for
    (
        vector* term :
        {
            &clumps_.rate, &clumps_.fluid, &clumps_.interior,
            &clumps_.coupling, &clumps_.applied, &clumps_.inside
        }
    )
    {
        reduce(*term, sumOp<vector>());
    }
    const vectorField change(U.primitiveField() - U.oldTime().primitiveField());
    fluidRate_ = rho*gSum(V*(change - clumps_.correction))/dt;
    forcing_ =
        cloud.forceOnFluid(U)
      + rho*gSum(V*cloud.boundary().strength().primitiveField())
       *clumps_.correction
      - clumps_.inside;

    scalar onFluid = 0;
    patches_ = rho*patchForces(convection, onFluid);
    sources_ = rho*sources(convection, onFluid);

    size_ = 0;
    for (const clumpParcel& p : cloud)
    {
        const vectorField& fluid = p.fluidForces();
        const vectorField& all = p.step().forces.f;
        size_ += sum(mag(fluid));

        // Clumps that have entered in this step have no forces yet
        if (all.size())
        {
            size_ += sum(mag(all - fluid));
        }
    }
    reduce(size_, sumOp<scalar>());
    size_ = max(size_ + rho*onFluid, VSMALL);

    // In a first step from rest the rates may be all there is
    for
    (
        const vector& F : {clumps_.rate, clumps_.applied, fluidRate_, forcing_}
    )
    {
        size_ = max(size_, mag(F));
    }

    const fluidsInside* fluids = cloud.fluids();
    momentum_ =
        gSum(rho*V*U.primitiveField())
      + returnReduce(excessMomentum(cloud), sumOp<vector>());
    if (fluids)
    {
        momentum_ += rho*returnReduce(fluids->excessMomentum(U), sumOp<vector>());
    }
    if (impulseSize_ == 0)
    {
        scalar mass =
            rho*gSum(V) + returnReduce(excessMass(cloud), sumOp<scalar>());
        if (fluids)
        {
            mass += rho*returnReduce(fluids->excessMass(), sumOp<scalar>());
        }
        start_ =
            momentum_ - mass*clumps_.correction
          - dt*(fluidRate_ + clumps_.rate - clumps_.displaced);
    }
    impulse_ += dt*(clumps_.applied + patches_ + sources_);
    impulseSize_ += dt*size_;
}


bool Foam::functionObjects::momentumBalance::execute()
{
    if (!functionObject::postProcess)
    {
        const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
        if (cloud.coupled())
        {
            findTerms(cloud);
        }
    }
    return true;
}


bool Foam::functionObjects::momentumBalance::write()
{
    if (functionObject::postProcess)
    {
        Info<< name() << ": the momentum over a step is known in the run only;"
            << " no table is written" << endl;
        return true;
    }
    if (impulseSize_ == 0 || !Pstream::master())
    {
        return true;
    }

    const vector ofClumps
    (
        clumps_.rate - clumps_.fluid - clumps_.interior - clumps_.coupling
      - clumps_.applied
    );
    const vector ofFluid(fluidRate_ - forcing_ - patches_ - sources_);
    const vector ofPair(along_ & (clumps_.fluid + forcing_));

    Ostream& os = table_.open(balanceColumns());
    const auto add = [&](const vector& v)
    {
        os  << '\t' << v.x() << '\t' << v.y() << '\t' << v.z();
    };
    os  << time_.timeOutputValue();
    for
    (
        const vector& F :
        {
            clumps_.rate, clumps_.fluid, clumps_.interior, clumps_.coupling,
            clumps_.applied, fluidRate_, forcing_, patches_, sources_
        }
    )
    {
        add(F);
    }
    for
    (
        const vector& F :
        {
            ofPair, ofClumps, ofFluid, clumps_.coupling,
            ofClumps + ofFluid + ofPair + clumps_.coupling
        }
    )
    {
        os  << '\t' << mag(F)/size_;
    }
    add(momentum_);
    add(impulse_);
    const vector missing(along_ & (momentum_ - start_ - impulse_));
    os  << '\t' << mag(missing)/impulseSize_ << nl;
    table_.flush();

    return true;
}
