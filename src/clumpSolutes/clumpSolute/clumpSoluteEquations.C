/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpSolute.H"
#include "coupledFluxes.H"
#include "foamCompat.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"
#include "fvOptions.H"
#include "linear.H"
#include "zeroGradientFvPatchFields.H"

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

    // Mesh cells may have been filled, and a restart reads no values of processorCyclic
    c.correctBoundaryConditions();
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

                // a is zero where all that is inside has come through an open patch
                const scalar whole = a + k[celli];
                const scalar part = t.fixed() ? 1 : a/whole;
                const scalar given =
                    t.fixed() ? ci[celli]/K : (H[celli] + supply[celli])/whole;
                outerEqn.diag()[celli] += V[celli]*k[celli]*part;
                outerEqn.source()[celli] += V[celli]*k[celli]*given;
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
