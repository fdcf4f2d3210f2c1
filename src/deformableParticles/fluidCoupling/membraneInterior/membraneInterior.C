/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneInterior.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "linear.H"
#include "surfaceDistance.H"

Foam::membraneInterior::membraneInterior
(
    const fvMesh& mesh,
    const PtrList<clumpType>& types
)
:
    mesh_(mesh),
    types_(types),
    factor_
    (
        IOobject("viscosityFactor", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("factor", dimless, 1)
    ),
    normal_
    (
        IOobject("interiorNormal", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimless, Zero)
    ),
    slipLengths_(mesh.nCells(), Zero),
    slip_
    (
        IOobject("interiorSlip", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimPressure, Zero)
    )
{}


void Foam::membraneInterior::reset()
{
    factor_ = dimensionedScalar("factor", dimless, 1);
    normal_ = dimensionedVector(dimless, Zero);
    slipLengths_ = scalarField(mesh_.nCells(), Zero);
    slip_ = dimensionedVector(dimPressure, Zero);
}


void Foam::membraneInterior::addSlip(volVectorField& force)
{
    const vectorField& n = normal_;
    const vectorField& f = force;
    slip_.primitiveFieldRef() = slipLengths_*(f - n*(n & f));
    slip_.correctBoundaryConditions();
    const surfaceVectorField flux
    (
        (mesh_.Sf() & linearInterpolate(twoSymm(normal_*slip_)))
       /linearInterpolate(1/factor_)
    );
    force.primitiveFieldRef() += fvc::div(flux)().primitiveField();
}


void Foam::membraneInterior::addFace
(
    const label celli,
    const vector& Sf,
    const scalar fluidity,
    const vector& slip,
    List<across>& sums
) const
{
    const scalar weight = sqr(normal_[celli] & Sf)/mag(Sf);
    sums[celli].weight += weight;
    sums[celli].fluidity += weight*fluidity;
    sums[celli].slip += weight*slip;
}


Foam::List<Foam::membraneInterior::across> Foam::membraneInterior::meansAcross() const
{
    const surfaceScalarField fluidity(linearInterpolate(1/factor_));
    const surfaceVectorField slip(linearInterpolate(slip_));
    const surfaceVectorField& Sf = mesh_.Sf();
    List<across> result(mesh_.nCells(), across{0, 0, Zero});
    forAll(mesh_.neighbour(), facei)
    {
        for (const label celli : {mesh_.owner()[facei], mesh_.neighbour()[facei]})
        {
            addFace(celli, Sf[facei], fluidity[facei], slip[facei], result);
        }
    }
    forAll(mesh_.boundary(), patchi)
    {
        const labelUList& cells = mesh_.boundary()[patchi].faceCells();
        forAll(Sf.boundaryField()[patchi], i)
        {
            addFace
            (
                cells[i],
                Sf.boundaryField()[patchi][i],
                fluidity.boundaryField()[patchi][i],
                slip.boundaryField()[patchi][i],
                result
            );
        }
    }
    return result;
}


Foam::tmp<Foam::volVectorField> Foam::membraneInterior::shear
(
    const volVectorField& U,
    const scalar mu0
) const
{
    const volVectorField En("En", symm(fvc::grad(U)) & normal_);
    tmp<volVectorField> tresult(2*(En - normal_*(normal_ & En)));
    vectorField& result = tresult.ref().primitiveFieldRef();
    const List<across> means(meansAcross());
    forAll(result, celli)
    {
        const across& m = means[celli];
        if (m.weight > 0)
        {
            result[celli] = (m.weight*result[celli] + m.slip/mu0)/m.fluidity;
        }
    }
    return tresult;
}


bool Foam::membraneInterior::wanted(const PtrList<clumpType>& types)
{
    for (const clumpType& type : types)
    {
        if (type.viscosityRatio() != 1)
        {
            return true;
        }
    }
    return false;
}


void Foam::membraneInterior::add
(
    const clumpImage& image,
    const surfaceKernel& kernel,
    const cellGeometry& geometry,
    const vectorField& widths
)
{
    const clumpType& type = types_[image.typeId];
    const scalar slow = 1/type.viscosityRatio() - 1;
    const boundBox nodes(image.x, false);
    DynamicList<label> cells;
    DynamicList<point> centres;

    // A mesh cell reaches at least half its width from its centre
    for (const label celli : geometry.find(nodes, 2*kernel.support()))
    {
        const point& x = geometry[celli].x;
        const vector reach(kernel.support()*widths[celli]);
        if (boundBox(x - reach, x + reach).overlaps(nodes))
        {
            cells.append(celli);
            centres.append(x);
        }
    }
    if (cells.empty())
    {
        return;
    }
    const pointField x(centres);
    const auto places = surfaceDistance(type.surface(), image.x).nearest
    (
        x, nodes.mag() + boundBox(x, false).mag()
    );
    forAll(cells, k)
    {
        const auto& p = places[k];
        const label celli = cells[k];
        const scalar width = mag(cmptMultiply(widths[celli], p.outwards));
        const scalar inside = kernel.beyond(p.distance/width);
        covered_[celli] += inside;
        factor_[celli] += slow*inside;
        if (inside > 0 && inside < 1)
        {
            // The same one in any order of the images, also where two are as near
            const scalar distance = mag(p.distance)/width;
            const label number = image.id.second();
            const scalar nearer = distances_[celli] - distance;
            if (nearer > 1e-9 || (nearer > -1e-9 && number < numbers_[celli]))
            {
                normal_[celli] = p.outwards;
                slipLengths_[celli] = -kernel.overlap()*width*slow;
                distances_[celli] = distance;
                numbers_[celli] = number;
            }
        }
    }
}


void Foam::membraneInterior::set
(
    const UList<clumpImage>& images,
    const UPtrList<surfaceKernel>& kernels,
    const cellGeometry& geometry,
    const vectorField& widths
)
{
    scalarField& factor = factor_.primitiveFieldRef();
    factor = Zero;
    normal_.primitiveFieldRef() = Zero;
    covered_ = scalarField(mesh_.nCells(), Zero);
    slipLengths_ = scalarField(mesh_.nCells(), Zero);
    distances_ = scalarField(mesh_.nCells(), GREAT);
    numbers_ = labelList(mesh_.nCells(), labelMax);
    for (const clumpImage& image : images)
    {
        if (types_[image.typeId].viscosityRatio() != 1)
        {
            add(image, kernels[image.typeId], geometry, widths);
        }
    }
    factor = 1/(1 + factor/max(covered_, scalar(1)));
    factor_.correctBoundaryConditions();
    normal_.correctBoundaryConditions();
}
