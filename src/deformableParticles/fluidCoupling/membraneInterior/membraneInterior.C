/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneInterior.H"
#include "fvcGrad.H"
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
    shearFactor_("viscosityShearFactor", factor_),
    normal_
    (
        IOobject("interiorNormal", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimless, Zero)
    )
{}


void Foam::membraneInterior::reset()
{
    factor_ = dimensionedScalar("factor", dimless, 1);
    shearFactor_ = dimensionedScalar("factor", dimless, 1);
    normal_ = dimensionedVector(dimless, Zero);
}


Foam::tmp<Foam::volVectorField> Foam::membraneInterior::shear
(
    const volVectorField& U
) const
{
    const volVectorField En("En", symm(fvc::grad(U)) & normal_);
    return 2*shearFactor_*(En - normal_*(normal_ & En));
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
        factor_[celli] += (type.viscosityRatio() - 1)*inside;
        shearFactor_[celli] += (1/type.viscosityRatio() - 1)*inside;
        if (inside > 0 && inside < 1)
        {
            // The same one in any order of the images, also where two are as near
            const scalar distance = mag(p.distance)/width;
            const label number = image.id.second();
            const scalar nearer = distances_[celli] - distance;
            if (nearer > 1e-9 || (nearer > -1e-9 && number < numbers_[celli]))
            {
                normal_[celli] = p.outwards;
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
    scalarField& shearFactor = shearFactor_.primitiveFieldRef();
    factor = Zero;
    shearFactor = Zero;
    normal_.primitiveFieldRef() = Zero;
    covered_ = scalarField(mesh_.nCells(), Zero);
    distances_ = scalarField(mesh_.nCells(), GREAT);
    numbers_ = labelList(mesh_.nCells(), labelMax);
    for (const clumpImage& image : images)
    {
        if (types_[image.typeId].viscosityRatio() != 1)
        {
            add(image, kernels[image.typeId], geometry, widths);
        }
    }
    factor = 1 + factor/max(covered_, scalar(1));
    shearFactor = 1/(1 + shearFactor/max(covered_, scalar(1)));
    factor_.correctBoundaryConditions();
    shearFactor_.correctBoundaryConditions();
    normal_.correctBoundaryConditions();
}
