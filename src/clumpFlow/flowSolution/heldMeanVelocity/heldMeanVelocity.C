/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heldMeanVelocity.H"
#include "incompressibleFlow.H"
#include "meanVelocityGradient.H"
#include "scalarMatrices.H"

Foam::heldMeanVelocity::heldMeanVelocity
(
    incompressibleFlow& flow
)
:
    flow_(flow),
    stepBegins_(true),
    before_(Zero),
    after_(Zero)
{}


bool Foam::heldMeanVelocity::findComponents()
{
    DynamicList<component> found;
    PtrList<fv::option>& options = flow_.options();
    for (fv::option& option : options)
    {
        if (!isA<fv::meanVelocityGradient>(option) || !option.isActive())
        {
            continue;
        }
        auto& source = refCast<fv::meanVelocityGradient>(option);
        for (const vector& d : source.heldDirections())
        {
            found.append({&source, d, source.Ubar() & d});
        }
    }

    bool same = found.size() == components_.size();
    forAll(found, i)
    {
        same =
            same && found[i].source == components_[i].source
         && found[i].d == components_[i].d;
    }
    components_ = found;
    return returnReduce(same, andOp<bool>());
}


void Foam::heldMeanVelocity::beginStep()
{
    if (!findComponents() || flow_.p().mesh().dynamic())
    {
        responses_.clear();
    }
    responses_.setSize(components_.size());
    for (const component& c : components_)
    {
        c.source->beginStep();
    }
    stepBegins_ = true;
}


bool Foam::heldMeanVelocity::sameMatrix
(
    const fvVectorMatrix& matrix,
    const scalarField& D,
    const scalarField& rAtU,
    const scalar part
) const
{
    // All coefficients of a row are compared with its diagonal, in which the faces
    // between processors count as all others
    bool same = D.size() == D_.size();
    const auto compare = [&](const scalar now, const scalar then, const label celli)
    {
        same = same && mag(now - then) <= part*mag(D_[celli]);
    };
    for (label i = 0; same && i < D.size(); ++i)
    {
        compare(D[i], D_[i], i);
        same = same && mag(rAtU[i] - rAtU_[i]) <= part*mag(rAtU_[i]);
    }
    const labelUList& owner = matrix.lduAddr().lowerAddr();
    const labelUList& neighbour = matrix.lduAddr().upperAddr();
    const scalarField& L = matrix.lower();
    const scalarField& U = matrix.upper();
    same = same && U.size() == matrix_->upper().size();
    for (label i = 0; same && i < U.size(); ++i)
    {
        compare(U[i], matrix_->upper()[i], owner[i]);
        compare(L[i], matrix_->lower()[i], neighbour[i]);
    }
    forAll(matrix.psi().boundaryField(), patchi)
    {
        const fvPatchVectorField& pf = matrix.psi().boundaryField()[patchi];
        const labelUList& cells = pf.patch().faceCells();
        const vectorField& now = matrix.boundaryCoeffs()[patchi];
        const vectorField& then = boundaryCoeffs_[patchi];
        same = same && now.size() == then.size();
        for (label i = 0; pf.coupled() && same && i < cells.size(); ++i)
        {
            compare(cmptAv(now[i]), cmptAv(then[i]), cells[i]);
        }
    }
    return returnReduce(same, andOp<bool>());
}


void Foam::heldMeanVelocity::forgetOld
(
    const fvVectorMatrix& matrix,
    const scalarField& rAtU
)
{
    const scalar part = stepBegins_ ? 0 : 0.1;
    const scalarField D(matrix.D());
    if (!matrix_.valid() || !sameMatrix(matrix, D, rAtU, part))
    {
        const label n = responses_.size();
        responses_.clear();
        responses_.setSize(n);
        matrix_.reset(new lduMatrix(matrix));
        boundaryCoeffs_ = FieldField<Field, vector>(matrix.boundaryCoeffs());
        D_ = D;
        rAtU_ = rAtU;
    }
    stepBegins_ = false;
}


void Foam::heldMeanVelocity::findResponse
(
    const label i,
    const fvVectorMatrix& UEqn,
    const volScalarField& rAU,
    const volScalarField& rAtU
)
{
    if (!responses_.set(i))
    {
        const component& c = components_[i];
        responses_.set
        (
            i, new flowResponse(UEqn, rAU, rAtU, flow_, c.d, c.source->cells())
        );
    }
}


Foam::scalarList Foam::heldMeanVelocity::missing() const
{
    const scalarField& V = flow_.p().mesh().V();
    const vector mean(gSum(V*flow_.U().primitiveField())/gSum(V));
    scalarList result(components_.size());
    forAll(result, i)
    {
        result[i] = components_[i].wanted - (components_[i].d & mean);
    }
    return result;
}


void Foam::heldMeanVelocity::add
(
    const labelList& active,
    const scalarList& missing
)
{
    const label n = active.size();
    scalarSquareMatrix R(n);
    scalarField g(n);
    for (label j = 0; j < n; ++j)
    {
        const vector mean(responses_[active[j]].mean());
        for (label i = 0; i < n; ++i)
        {
            R(i, j) = components_[active[i]].d & mean;
        }
        g[j] = missing[active[j]];
        components_[active[j]].source->refuseIdle(R(j, j));
    }
    LUsolve(R, g);
    for (label j = 0; j < n; ++j)
    {
        responses_[active[j]].addTo(flow_, g[j]);
        const component& c = components_[active[j]];
        c.source->change(g[j]*c.d);
    }
}


Foam::vector Foam::heldMeanVelocity::sumOfGradients() const
{
    vector result(Zero);
    const fv::meanVelocityGradient* last = nullptr;
    for (const component& c : components_)
    {
        if (c.source != last)
        {
            result += c.source->gradient();
            last = c.source;
        }
    }
    return result;
}


void Foam::heldMeanVelocity::hold(const fvVectorMatrix& UEqn)
{
    if (components_.empty())
    {
        return;
    }
    before_ = sumOfGradients();
    for (const component& c : components_)
    {
        c.source->change(Zero);
    }
    const volScalarField rAU(1.0/UEqn.A());
    tmp<volScalarField> rAtU(rAU);
    if (flow_.control().consistent())
    {
        rAtU = flow_.pressureMobility(1.0/rAU - UEqn.H1());
    }
    forgetOld(UEqn, rAtU().primitiveField());

    const scalarField& V = flow_.p().mesh().V();
    const scalar speed =
        Foam::sqrt(gSum(V*magSqr(flow_.U().primitiveField()))/gSum(V));
    labelHashSet active;

    // Those that were right may be disturbed by the responses of the others
    for (bool again = true; again; )
    {
        again = false;
        const scalarList missing(this->missing());
        forAll(components_, i)
        {
            const scalar wanted = mag(components_[i].source->Ubar());
            const scalar allowed = 1e-9*(wanted > 0 ? wanted : speed);
            if (mag(missing[i]) > allowed && active.insert(i))
            {
                findResponse(i, UEqn, rAU, rAtU());
                again = true;
            }
        }
        if (again)
        {
            add(active.sortedToc(), missing);
        }
    }
    after_ = sumOfGradients();
}


Foam::heldMeanVelocity::power Foam::heldMeanVelocity::gradientPower() const
{
    power result{0, 0};
    if (components_.empty())
    {
        return result;
    }
    const fvMesh& mesh = flow_.p().mesh();
    const scalarField& V = mesh.V();
    const vectorField& C = mesh.C().primitiveField();
    const vector centre(gSum(V*C)/gSum(V));
    const symmTensor moments
    (
        gSum((V/flow_.nu().primitiveField()*sqr(C - centre))())
    );
    const auto of = [&](const vector& G) { return G & moments & G; };
    result.change = of(after_ - before_);
    result.size = max(of(before_), of(after_));
    return result;
}
