/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpSolute.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntries.H"
#include "coupledFluxes.H"
#include "FlatOutput.H"
#include "foamCompat.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"
#include "fvOptions.H"
#include "linear.H"
#include "placedConditions.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpSolute, 0);
    addToRunTimeSelectionTable(functionObject, clumpSolute, dictionary);
}
}


Foam::functionObjects::clumpSolute::clumpSolute
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, typeName),
    clumpTable_(mesh_, name + "Clumps", "clumpContent"),
    through_(mesh_.boundaryMesh().nNonProcessor(), Zero)
{
    read(dict);
    if (!functionObject::postProcess)
    {
        refusePlaces(dict);
        start();
    }
}


bool Foam::functionObjects::clumpSolute::read(const dictionary& dict)
{
    checkEntries
    (
        dict,
        {"cloud", "field", "diffusivity", "tolerance", "types", "perClump"},
        functionObjectEntries()
    );
    cloudName_ = deformableCloud::findName(mesh_, dict);
    diffusivity_ = getPositive(dict, "diffusivity");
    tolerance_ = getPositiveOrDefault(dict, "tolerance", 1e-8);
    perClump_ = dict.getOrDefault("perClump", false);
    if (!functionObject::postProcess)
    {
        const dictionary types(dict.subOrEmptyDict("types"));
        types_ = List<soluteType>(cloud().nTypes(), soluteType(diffusivity_));
        released_ = scalarList(types_.size(), Zero);
        for (const entry& e : types)
        {
            if (!cloud().typeIds().found(e.keyword()))
            {
                FatalIOErrorInFunction(e.isDict() ? e.dict() : dict)
                    << "Entry '" << e.keyword() << "' is no type of clumps. Valid: "
                    << flatOutput(cloud().typeIds().sortedToc()) << exit(FatalIOError);
            }
            types_[cloud().typeIds()[e.keyword()]] =
                soluteType(Foam::getDict(types, e.keyword()), diffusivity_);
        }
        const word name(dict.getOrDefault<word>("field", "c"));
        if (!outer_.valid())
        {
            IOobject file
            (
                name, mesh_.time().timeName(), mesh_,
                IOobject::MUST_READ, IOobject::NO_WRITE
            );
            if (!file.typeHeaderOk<volScalarField>(true))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry 'field' is " << name << ", but the start time "
                    << mesh_.time().timeName() << " has no volScalarField of this name:"
                    << " the concentration outside, with its conditions at the patches."
                    << exit(FatalIOError);
            }
            outer_.reset(new volScalarField(file, mesh_));
        }
    }
    return
        fvMeshFunctionObject::read(dict) && table_.read(dict)
     && clumpTable_.read(dict);
}


Foam::autoPtr<Foam::volScalarField> Foam::functionObjects::clumpSolute::field
(
    const word& name
) const
{
    return autoPtr<volScalarField>::New
    (
        IOobject
        (
            name, mesh_.time().timeName(), mesh_,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
        ),
        mesh_,
        dimensionedScalar("none", outer_->dimensions(), -GREAT),
        zeroGradientFvPatchScalarField::typeName
    );
}


const Foam::soluteType& Foam::functionObjects::clumpSolute::type
(
    const label celli
) const
{
    static const soluteType none(1);
    const label typei = surfaces_->type()[celli];
    return typei < 0 ? none : types_[typei];
}


void Foam::functionObjects::clumpSolute::start()
{
    const word& name = outer_->name();
    inner_ = field(name + "Inside");
    outerContent_ = field(name + "Content");
    innerContent_ = field(name + "InsideContent");
    bound_ = field(name + "Bound");
    outside_.reset(new phaseVolume(mesh_, name + "Volume"));
    inside_.reset(new phaseVolume(mesh_, name + "InsideVolume"));

    surfaces_.reset(new bodySurfaces(mesh_));
    surfaces_->update(cloud());
    const scalarField& alpha = surfaces_->fraction();
    outside_->start(1 - alpha);
    inside_->start(alpha);
    const auto begin = [](volScalarField& field, const scalarField& values)
    {
        if (gMin(field.primitiveField()) <= -GREAT)
        {
            field.primitiveFieldRef() = values;
            field.correctBoundaryConditions();
        }
    };
    scalarField initial(outer_->primitiveField());
    forAll(initial, celli)
    {
        initial[celli] = type(celli).initial(initial[celli]);
    }
    begin(*inner_, initial);
    setBound();
    begin(*outerContent_, outside_->volume()*(*outer_));
    begin(*innerContent_, inside_->volume()*(*inner_ + *bound_));
}


void Foam::functionObjects::clumpSolute::refusePlaces(const dictionary& dict) const
{
    if (!cloud().effects().active("sliding"))
    {
        return;
    }
    const word patch(placedCondition(*outer_));
    const word source
    (
        placedSource(fv::options::New(mesh_), outer_->name())
    );
    if (!patch.empty() || !source.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The mesh slides along with the clumps, and "
            << (patch.empty() ? "source " : "the condition of patch ")
            << (patch.empty() ? source : patch) << " of " << outer_->name()
            << " may depend on the place. Set effects { sliding off; } in clumpProperties."
            << exit(FatalIOError);
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::functionObjects::clumpSolute::flux() const
{
    const auto* phi = mesh_.findObject<surfaceScalarField>("phi");
    if (!phi)
    {
        FatalErrorInFunction
            << name() << ": there is no flow (phi) that a solute could go with"
            << exit(FatalError);
    }
    if (mesh_.moving())
    {
        FatalErrorInFunction
            << name() << ": the points of the mesh move (constant/dynamicMeshDict). A"
            << " solute is transported on meshes that stand, slide or are refined."
            << exit(FatalError);
    }
    tmp<surfaceScalarField> result(new surfaceScalarField("soluteFlux", *phi));
    const vector& V = cloud().meshVelocity();
    if (V != vector::zero)
    {
        surfaceScalarField& f = result.ref();
        f.primitiveFieldRef() -= V & mesh_.Sf().primitiveField();
        forAll(mesh_.boundary(), patchi)
        {
            if (mesh_.boundary()[patchi].coupled())
            {
                f.boundaryFieldRef()[patchi] -= V & mesh_.boundary()[patchi].Sf();
            }
        }
    }
    return result;
}


void Foam::functionObjects::clumpSolute::moveClumps()
{
    if (mesh_.topoChanging() || surfaces_->type().size() != mesh_.nCells())
    {
        surfaces_.reset(new bodySurfaces(mesh_));
    }
    surfaces_->update(cloud());
    const scalarField& alpha = surfaces_->fraction();
    const surfaceScalarField& theta = surfaces_->faceFraction();
    const surfaceScalarField phi(flux());

    // Clumps that have come bring their content and take the place of fluid
    const scalarField change(inside_->update(alpha, theta*phi));
    scalarField& inner = innerContent_->primitiveFieldRef();
    scalarField& outer = outerContent_->primitiveFieldRef();
    scalar entered = 0;
    forAll(change, celli)
    {
        const scalar c = (*outer_)[celli];
        const scalar initial = type(celli).initial(c);
        const scalar in = change[celli]
           *(
                change[celli] > 0
              ? initial + type(celli).bound(initial)
              : (*inner_)[celli] + (*bound_)[celli]
            );
        const scalar out = -change[celli]*c;
        inner[celli] += in;
        outer[celli] += out;
        entered += (in + out)*mesh_.V()[celli];
    }
    entered_ += returnReduce(entered, sumOp<scalar>());
    outside_->add(-change);

    // A pocket of fluid that opens or closes between the spheres of a clump
    const scalarField opened(outside_->update(1 - alpha, (1 - theta)*phi));
    inside_->add(-opened);
    forAll(opened, celli)
    {
        const scalar moved =
            opened[celli]
           *(
                opened[celli] > 0
              ? (*inner_)[celli] + (*bound_)[celli] : (*outer_)[celli]
            );
        inner[celli] -= moved;
        outer[celli] += moved;
    }
}


void Foam::functionObjects::clumpSolute::fillEmpty()
{
    scalarField& out = outer_->primitiveFieldRef();
    scalarField& in = inner_->primitiveFieldRef();
    scalarField& outerContent = outerContent_->primitiveFieldRef();
    scalarField& innerContent = innerContent_->primitiveFieldRef();
    forAll(out, celli)
    {
        const scalar K = type(celli).partition();
        if (!inside_->active(celli))
        {
            inside_->give(celli, *outside_);
            outerContent[celli] += innerContent[celli];
            innerContent[celli] = 0;
            in[celli] = K*out[celli];
        }
        else if (!outside_->active(celli))
        {
            outside_->give(celli, *inside_);
            innerContent[celli] += outerContent[celli];
            outerContent[celli] = 0;
            out[celli] = in[celli]/K;
        }
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::functionObjects::clumpSolute::nearness
(
    const scalar side
) const
{
    volVectorField shift("shift", surfaces_->outwards()*surfaces_->distance());
    const scalarField& alpha = surfaces_->fraction();
    forAll(shift, celli)
    {
        const bool other =
            side*surfaces_->distance()[celli] < 0
         && !type(celli).impermeable() && alpha[celli] > 0 && alpha[celli] < 1;
        shift[celli] = other ? -shift[celli] : vector::zero;
    }
    shift.correctBoundaryConditions();

    tmp<surfaceScalarField> result
    (
        new surfaceScalarField
        (
            IOobject("nearness", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar("one", dimless, 1)
        )
    );
    surfaceScalarField& factor = result.ref();
    const auto over = [](const vector& way, const vector& change, const vector& S)
    {
        // Closer than this part of the way is as good as there
        constexpr scalar closest = 0.05;
        const scalar whole = way & S;
        return whole/max(whole + (change & S), closest*whole);
    };
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    const vectorField& C = mesh_.cellCentres();
    forAll(nei, facei)
    {
        factor[facei] = over
        (
            C[nei[facei]] - C[own[facei]],
            shift[nei[facei]] - shift[own[facei]],
            mesh_.Sf()[facei]
        );
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!patch.coupled())
        {
            continue;
        }
        const vectorField way(patch.delta());
        const vectorField change
        (
            shift.boundaryField()[patchi].patchNeighbourField()
          - shift.boundaryField()[patchi].patchInternalField()
        );
        fvsPatchScalarField& values = factor.boundaryFieldRef()[patchi];
        forAll(values, i)
        {
            values[i] = over(way[i], change[i], patch.Sf()[i]);
        }
    }
    return result;
}


Foam::tmp<Foam::surfaceScalarField>
Foam::functionObjects::clumpSolute::sameClump() const
{
    const volScalarField& clump = surfaces_->clump();
    tmp<surfaceScalarField> result
    (
        new surfaceScalarField
        (
            IOobject("sameClump", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar("one", dimless, 1)
        )
    );
    surfaceScalarField& same = result.ref();
    forAll(mesh_.neighbour(), facei)
    {
        same[facei] =
            clump[mesh_.neighbour()[facei]] == clump[mesh_.owner()[facei]];
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchScalarField& p = clump.boundaryField()[patchi];
        if (p.coupled())
        {
            const scalarField own(p.patchInternalField());
            const scalarField nei(p.patchNeighbourField());
            fvsPatchScalarField& values = same.boundaryFieldRef()[patchi];
            forAll(values, i)
            {
                values[i] = own[i] == nei[i];
            }
        }
    }
    return result;
}


Foam::tmp<Foam::fvScalarMatrix>
Foam::functionObjects::clumpSolute::outsideEquation()
{
    volScalarField& c = *outer_;
    const word& name = c.name();
    const dimensionedScalar dt("dt", dimTime, mesh_.time().deltaTValue());
    const dimensionedScalar D("D", dimArea/dimTime, diffusivity_);

    volScalarField volume("volume", outside_->volume());
    volScalarField before("before", (*outerContent_));
    forAll(c, celli)
    {
        if (!outside_->active(celli))
        {
            volume[celli] = 1;
            before[celli] = c[celli];
        }
    }
    const surfaceScalarField gamma
    (
        D*outside_->between()*(1 - surfaces_->faceFraction())*nearness(1)
    );
    tmp<fvScalarMatrix> result
    (
        new fvScalarMatrix
        (
            fvm::Sp(volume/dt, c)
          + fvm::div(outside_->flux(), c, "div(phi," + name + ")")
          - fvm::laplacian(gamma, c, "laplacian(D," + name + ")")
         == before/dt
        )
    );

    fv::options& options = fv::options::New(mesh_);
    if (options.appliesToField(name))
    {
        fvScalarMatrix sources(options(c));
        scalarField part(outside_->volume());
        forAll(part, celli)
        {
            part[celli] *= outside_->active(celli);
        }
        sources.source() *= part;
        if (sources.hasDiag())
        {
            sources.diag() *= part;
        }
        result.ref() -= sources;
    }
    equateCoupledFluxes(result.ref());
    return result;
}


Foam::tmp<Foam::surfaceScalarField>
Foam::functionObjects::clumpSolute::insideFaces() const
{
    volScalarField loose("loose", inside_->volume());
    forAll(loose, celli)
    {
        loose[celli] = !(fixed(celli) && inside_->active(celli));
    }
    loose.correctBoundaryConditions();
    return inside_->between()*neg(1 - 1e-9 - linearInterpolate(loose));
}


bool Foam::functionObjects::clumpSolute::binds() const
{
    for (const soluteType& t : types_)
    {
        if (t.binding())
        {
            return true;
        }
    }
    return false;
}


void Foam::functionObjects::clumpSolute::setBound()
{
    volScalarField& b = *bound_;
    forAll(b, celli)
    {
        b[celli] = type(celli).bound((*inner_)[celli]);
    }
    b.correctBoundaryConditions();
}


Foam::tmp<Foam::surfaceScalarField>
Foam::functionObjects::clumpSolute::insideDiffusivity
(
    const surfaceScalarField& both,
    const bool ofBound
) const
{
    volScalarField D
    (
        IOobject("D", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimArea/dimTime, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(D, celli)
    {
        const soluteType& t = type(celli);
        D[celli] = ofBound ? t.boundDiffusivity() : t.diffusivity();
    }
    D.correctBoundaryConditions();
    return
        both*sameClump()*surfaces_->faceFraction()*nearness(-1)*linearInterpolate(D);
}


Foam::tmp<Foam::fvScalarMatrix>
Foam::functionObjects::clumpSolute::insideEquation()
{
    volScalarField& c = *inner_;
    const word& name = outer_->name();
    const dimensionedScalar dt("dt", dimTime, mesh_.time().deltaTValue());

    volScalarField volume("volume", inside_->volume());
    volScalarField before("before", (*innerContent_));
    forAll(c, celli)
    {
        const bool keeps = fixed(celli) && inside_->active(celli);
        if (keeps)
        {
            c[celli] = type(celli).concentration();
        }
        if (keeps || !inside_->active(celli))
        {
            volume[celli] = 1;
            before[celli] = c[celli];
        }
    }
    c.correctBoundaryConditions();
    const surfaceScalarField both(insideFaces());
    const surfaceScalarField gamma(insideDiffusivity(both, false));
    tmp<fvScalarMatrix> result
    (
        new fvScalarMatrix
        (
            fvm::Sp(volume/dt, c)
          + fvm::div(both*inside_->flux(), c, "div(phi," + name + ")")
          - fvm::laplacian(gamma, c, "laplacian(D," + name + ")")
         == before/dt
        )
    );
    equateCoupledFluxes(result.ref());
    return result;
}


Foam::tmp<Foam::fvScalarMatrix>
Foam::functionObjects::clumpSolute::boundEquation()
{
    const dimensionedScalar dt("dt", dimTime, mesh_.time().deltaTValue());
    volScalarField volume("volume", inside_->volume());
    forAll(volume, celli)
    {
        if (!inside_->active(celli) || !type(celli).binding())
        {
            volume[celli] = 0;
        }
    }
    const word& name = outer_->name();
    const surfaceScalarField both(insideFaces());
    tmp<fvScalarMatrix> result
    (
        fvm::Sp(volume/dt, *bound_)
      + fvm::div(both*inside_->flux(), *bound_, "div(phi," + name + ")")
    );
    for (const soluteType& t : types_)
    {
        if (t.boundDiffusivity() > 0)
        {
            result.ref() -= fvm::laplacian
            (
                insideDiffusivity(both, true), *bound_, "laplacian(D," + name + ")"
            );
            break;
        }
    }
    equateCoupledFluxes(result.ref());
    return result;
}


void Foam::functionObjects::clumpSolute::addBound
(
    fvScalarMatrix& inner,
    const fvScalarMatrix& bound,
    const scalarField& taken,
    const scalarField& given
)
{
    const volScalarField& c = *inner_;
    volScalarField& b = *bound_;
    const scalarField A(inner.A()().primitiveField() + taken);
    const scalarField H(inner.H()().primitiveField() + given);
    const scalarField boundA(bound.A()().primitiveField());
    const scalarField boundH(bound.H()().primitiveField());
    volScalarField slope("slope", 0*b/dimensionedScalar("one", b.dimensions(), 1));
    forAll(c, celli)
    {
        const boundModel* model = type(celli).binding();
        if (model && inside_->active(celli) && boundA[celli] > 0)
        {
            // Towards the solution with the neighbours as they are
            slope[celli] = model->chord
            (
                c[celli],
                model->free
                (
                    A[celli]/boundA[celli], (H[celli] + boundH[celli])/boundA[celli]
                )
            );
            b[celli] -= slope[celli]*c[celli];
        }
    }
    slope.correctBoundaryConditions();
    b.correctBoundaryConditions();

    // b = slope c + rest: each column of the matrix times the slope of its mesh cell
    inner.source() += rest(bound);
    fvScalarMatrix linear(bound);
    linear.diag() *= slope.primitiveField();
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    scalarField& lower = linear.lower();
    scalarField& upper = linear.upper();
    forAll(nei, facei)
    {
        lower[facei] *= slope[own[facei]];
        upper[facei] *= slope[nei[facei]];
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchScalarField& s = slope.boundaryField()[patchi];
        linear.internalCoeffs()[patchi] *= s.patchInternalField();
        if (s.coupled())
        {
            linear.boundaryCoeffs()[patchi] *= s.patchNeighbourField();
        }
    }
    inner.lduMatrix::operator+=(linear);
    inner.internalCoeffs() += linear.internalCoeffs();
    inner.boundaryCoeffs() += linear.boundaryCoeffs();
}


Foam::scalarField Foam::functionObjects::clumpSolute::exchange() const
{
    scalarField result(surfaces_->area());
    forAll(result, celli)
    {
        if (result[celli] > 0)
        {
            const bool both = outside_->active(celli) && inside_->active(celli);
            result[celli] *=
                both
              ? type(celli).conductance
                (
                    surfaces_->distance()[celli],
                    diffusivity_,
                    1e-3*Foam::cbrt(mesh_.V()[celli]),
                    (*inner_)[celli]
                )
              : 0;
        }
    }
    return result;
}


Foam::scalar Foam::functionObjects::clumpSolute::outflow
(
    const fvScalarMatrix& equation,
    const label patchi
)
{
    const fvPatchScalarField& c = equation.psi().boundaryField()[patchi];
    return
        c.coupled() ? 0
      : sum
        (
            equation.internalCoeffs()[patchi]*c.patchInternalField()
          - equation.boundaryCoeffs()[patchi]
        );
}


Foam::tmp<Foam::scalarField> Foam::functionObjects::clumpSolute::rest
(
    const fvScalarMatrix& equation
)
{
    // fvMatrix::residual() counts coupled patches twice
    return
        equation.psi().mesh().V()
       *(
            equation.H()().primitiveField()
          - equation.A()().primitiveField()*equation.psi().primitiveField()
        );
}


void Foam::functionObjects::clumpSolute::solve()
{
    volScalarField& c = *outer_;
    volScalarField& ci = *inner_;
    const fvScalarMatrix outer(outsideEquation());
    const fvScalarMatrix inner(insideEquation());
    const scalarField k(exchange());
    const scalarField& V = mesh_.V();
    const scalar dt = mesh_.time().deltaTValue();
    const scalar content = gSum
    (
        V*(mag(outerContent_->primitiveField()) + mag(innerContent_->primitiveField()))
    );
    const bool reaches = gMax(k) > 0;

    // OpenFOAM's residuals are wrong for numbers as small as the volume of a mesh cell
    const dimensionedScalar scale("scale", dimless, dt/gAverage(V));

    const bool binding = binds();
    autoPtr<fvScalarMatrix> bound;
    if (binding)
    {
        setBound();
        bound.reset(new fvScalarMatrix(boundEquation()));
    }

    scalarField A(inner.A()().primitiveField());
    scalarField outerRest(c.size());
    scalarField innerRest(c.size());
    scalarList released(types_.size());
    constexpr label mostIterations = 100;
    for (label n = 0; n < mostIterations; ++n)
    {
        scalarField reaction(c.size(), Zero);
        scalarField supply(c.size(), Zero);
        scalarField crossing(c.size(), Zero);
        forAll(k, celli)
        {
            const soluteType& t = type(celli);
            if (!t.fixed())
            {
                crossing[celli] = k[celli]/t.partition();
            }
            if (inside_->active(celli) && !t.fixed())
            {
                const scalar e = inside_->volume()[celli];
                reaction[celli] = e*t.coefficient(ci[celli]);
                supply[celli] = e*t.source();
            }
        }
        fvScalarMatrix innerEqn(inner);
        if (binding)
        {
            addBound(innerEqn, *bound, reaction + crossing, supply + k*c.primitiveField());
            A = innerEqn.A()().primitiveField();
        }

        // What is inside follows what is outside, as far as its own mesh cell goes
        const scalarField H(innerEqn.H()().primitiveField());
        fvScalarMatrix outerEqn(outer);
        forAll(k, celli)
        {
            if (k[celli] > 0)
            {
                const soluteType& t = type(celli);
                const scalar K = t.partition();
                const scalar a = K*(A[celli] + reaction[celli]);
                const scalar part = t.fixed() ? 1 : a/(a + k[celli]);
                const scalar free =
                    t.fixed() ? ci[celli]/K : (H[celli] + supply[celli])/a;
                outerEqn.diag()[celli] += V[celli]*k[celli]*part;
                outerEqn.source()[celli] += V[celli]*k[celli]*part*free;
            }
        }
        outerEqn *= scale;
        outerEqn.solve(mesh_.solverDict(c.name()));

        forAll(k, celli)
        {
            const scalar from = fixed(celli) ? 0 : k[celli];
            innerEqn.diag()[celli] += V[celli]*(crossing[celli] + reaction[celli]);
            innerEqn.source()[celli] += V[celli]*(from*c[celli] + supply[celli]);
        }
        innerEqn *= scale;
        innerEqn.solve(mesh_.solverDict(ci.name()));

        outerRest = rest(outer);
        innerRest = rest(inner);
        if (binding)
        {
            setBound();
            innerRest += rest(*bound);
        }
        released = Zero;
        forAll(k, celli)
        {
            const soluteType& t = type(celli);
            const scalar through = V[celli]*k[celli]*(c[celli] - ci[celli]/t.partition());
            outerRest[celli] -= through;
            if (!t.fixed())
            {
                innerRest[celli] += through;
                if (inside_->active(celli))
                {
                    innerRest[celli] +=
                        V[celli]*inside_->volume()[celli]
                       *(t.source() - t.coefficient(ci[celli])*ci[celli]);
                }
            }
            if (k[celli] > 0)
            {
                released[surfaces_->type()[celli]] -= through;
            }
        }
        const scalar left = gSumMag(outerRest) + gSumMag(innerRest);
        if (left*dt <= tolerance_*content || (!reaches && !binding && n > 0))
        {
            break;
        }
    }
    released_ = released;
    for (label patchi = 0; patchi < through_.size(); ++patchi)
    {
        through_[patchi] =
            outflow(outer, patchi) + outflow(inner, patchi)
          + (binding ? outflow(*bound, patchi) : 0);
    }

    forAll(c, celli)
    {
        (*outerContent_)[celli] =
            outside_->active(celli)
          ? outside_->volume()[celli]*c[celli] + dt*outerRest[celli]/V[celli] : 0;
        (*innerContent_)[celli] =
            !inside_->active(celli) ? 0
          : inside_->volume()[celli]*(ci[celli] + (*bound_)[celli])
          + (fixed(celli) ? 0 : dt*innerRest[celli]/V[celli]);
    }
}


bool Foam::functionObjects::clumpSolute::execute()
{
    if (functionObject::postProcess)
    {
        return true;
    }
    moveClumps();
    fillEmpty();
    solve();
    return true;
}


void Foam::functionObjects::clumpSolute::writeClumps()
{
    // Content and volume
    HashTable<vector, labelPair, labelPair::Hash<>> sums;
    forAll(mesh_.V(), celli)
    {
        if (inside_->active(celli) && surfaces_->type()[celli] >= 0)
        {
            sums(surfaces_->idOf(celli), Zero) += mesh_.V()[celli]*vector
            (
                (*innerContent_)[celli],
                inside_->volume()[celli],
                inside_->volume()[celli]*(*bound_)[celli]
            );
        }
    }
    reduceMap(sums, plusEqOp<vector>());
    if (!Pstream::master())
    {
        return;
    }
    tableHeader header("Content of each clump");
    header
       .add("time", "s").add("clump").add("origProc").add("content", "C.m3")
       .add("volume", "m3").add("bound", "C.m3")
       .explain("clump origProc", "number of the clump, and of the processor that it is of")
       .explain("content volume", "in the mesh cells that it is the nearest of all clumps to")
       .explain("bound", "part of the content that is bound");
    Ostream& os = clumpTable_.open(header);
    for (const labelPair& id : sums.sortedToc())
    {
        os  << mesh_.time().timeOutputValue() << '\t' << id.second() << '\t' << id.first()
            << '\t' << sums[id].x() << '\t' << sums[id].y() << '\t' << sums[id].z() << nl;
    }
    clumpTable_.flush();
}


bool Foam::functionObjects::clumpSolute::write()
{
    if (functionObject::postProcess)
    {
        return true;
    }
    const scalarField& V = mesh_.V();
    const scalar outer = gSum(V*outerContent_->primitiveField());
    const scalar inner = gSum(V*innerContent_->primitiveField());
    scalar lowest = GREAT;
    scalar highest = -GREAT;
    const auto add = [&](const phaseVolume& phase, const volScalarField& c, const label i)
    {
        if (phase.active(i))
        {
            lowest = min(lowest, c[i]);
            highest = max(highest, c[i]);
        }
    };
    forAll(V, celli)
    {
        add(*outside_, *outer_, celli);
        if (!fixed(celli))
        {
            add(*inside_, *inner_, celli);
        }
    }
    reduce(lowest, minOp<scalar>());
    reduce(highest, maxOp<scalar>());
    scalarList released(released_);
    Pstream::listCombineGather(released, plusEqOp<scalar>());
    scalarList through(through_);
    Pstream::listCombineGather(through, plusEqOp<scalar>());
    if (Pstream::master())
    {
        tableHeader header("Content of the mesh");
        header
           .add("time", "s").add("outside", "C.m3").add("inside", "C.m3")
           .add("entered", "C.m3").add("lowest", "C").add("highest", "C")
           .explain("outside inside", "clumps; C is the unit of the concentration")
           .explain("entered", "amount that clumps have brought along less what they have"
                " taken away, and less that of the fluid in their place, in this run")
           .explain("lowest highest", "concentrations outside and inside");
        for (label i = 0; i < types_.size(); ++i)
        {
            const word name("released_" + cloud().types()[i].name());
            header.add(name, "C.m3/s").explain
            (
                name, "amount that clumps of this type release through their surface"
            );
        }
        forAll(through, patchi)
        {
            const word name("out_" + mesh_.boundary()[patchi].name());
            header.add(name, "C.m3/s").explain(name, "amount that leaves through the patch");
        }
        Ostream& os = table_.open(header);
        os  << mesh_.time().timeOutputValue() << '\t' << outer << '\t' << inner << '\t'
            << entered_ << '\t' << lowest << '\t' << highest;
        for (const scalar r : released)
        {
            os  << '\t' << r;
        }
        for (const scalar t : through)
        {
            os  << '\t' << t;
        }
        os  << nl;
        table_.flush();
    }
    if (perClump_)
    {
        writeClumps();
    }
    if (mesh_.time().writeTime())
    {
        outer_->write();
        inner_->write();
        outerContent_->write();
        innerContent_->write();
        if (binds())
        {
            bound_->write();
        }
        outside_->write();
        inside_->write();
    }
    return true;
}
