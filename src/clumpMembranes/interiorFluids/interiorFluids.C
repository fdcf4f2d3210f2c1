/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "interiorFluids.H"
#include "surfaceDistance.H"

Foam::interiorFluids::interiorFluids
(
    const fvMesh& mesh,
    const PtrList<clumpType>& types,
    const UPtrList<surfaceKernel>& kernels,
    const cellGeometry& geometry,
    const vectorField& widths,
    const scalar rho
)
:
    mesh_(mesh),
    types_(types),
    kernels_(kernels),
    geometry_(geometry),
    widths_(widths),
    densities_(types.size(), scalar(1))
{
    bool viscosity = false;
    bool density = false;
    forAll(types, i)
    {
        if (!types[i].hasTriangles())
        {
            continue;
        }
        const scalar ratio = types[i].mass()/types[i].volume()/rho;
        if (mag(ratio - 1) > 1e-6)
        {
            densities_[i] = ratio;
            density = true;
        }
        viscosity = viscosity || types[i].viscosityRatio() != 1;
    }
    if (viscosity)
    {
        viscosity_ = one("viscosityFactor");
    }
    if (density)
    {
        density_ = one("densityFactor");
    }
}


Foam::autoPtr<Foam::volScalarField> Foam::interiorFluids::one(const word& name) const
{
    return autoPtr<volScalarField>::New
    (
        IOobject(name, mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("factor", dimless, 1)
    );
}


void Foam::interiorFluids::reset()
{
    for (volScalarField* factor : {viscosity_.get(), density_.get()})
    {
        if (factor)
        {
            *factor = dimensionedScalar("factor", dimless, 1);
        }
    }
}


Foam::DynamicList<Foam::interiorFluids::part> Foam::interiorFluids::partsOf
(
    const clumpImage& image
) const
{
    DynamicList<part> parts;
    const clumpType& type = types_[image.typeId];
    if
    (
        !type.hasTriangles()
     || (type.viscosityRatio() == 1 && densities_[image.typeId] == 1)
    )
    {
        return parts;
    }
    const surfaceKernel& kernel = kernels_[image.typeId];
    const boundBox nodes(image.x, false);
    DynamicList<point> centres;
    scalar farthest = 0;

    // A mesh cell reaches at least half its width from its centre
    for (const label celli : geometry_.find(nodes, 2*kernel.support()))
    {
        const point& x = geometry_[celli].x;
        const vector reach(kernel.support()*widths_[celli]);
        if (boundBox(x - reach, x + reach).overlaps(nodes))
        {
            parts.append(part{celli, 0, 0});
            centres.append(x);
            farthest = max(farthest, cmptMax(reach));
        }
    }
    if (parts.empty())
    {
        return parts;
    }
    const pointField x(centres);
    const surfaceDistance surface
    (
        type.surface(), image.x, image.transform.invertsHands()
    );
    const auto places = surface.nearest(x, farthest);
    const boolList within(surface.inside(x, places));
    forAll(parts, k)
    {
        const auto& p = places[k];
        const vector& width = widths_[parts[k].celli];
        parts[k].distance = p.found ? p.distance : within[k] ? -GREAT : GREAT;
        parts[k].width = p.found ? mag(cmptMultiply(width, p.outwards)) : 1;
    }
    return parts;
}


void Foam::interiorFluids::set(ghostExchange& ghosts)
{
    if (!viscosity_.valid() && !density_.valid())
    {
        return;
    }
    UList<clumpImage>& images = ghosts.images();
    scalarField covered(mesh_.nCells(), Zero);
    scalarField slower(mesh_.nCells(), Zero);
    List<DynamicList<part>> parts(images.size());
    forAll(images, a)
    {
        parts[a] = partsOf(images[a]);
        images[a].inside = 0;
        const scalar slow = 1/types_[images[a].typeId].viscosityRatio() - 1;
        for (const part& p : parts[a])
        {
            const scalar I = inside(images[a], p);
            covered[p.celli] += I;
            slower[p.celli] += slow*I;
            images[a].inside += I*mesh_.V()[p.celli];
        }
    }
    covered = max(covered, scalar(1));
    if (viscosity_.valid())
    {
        viscosity_->primitiveFieldRef() = 1/(1 + slower/covered);
        viscosity_->correctBoundaryConditions();
    }
    if (density_.valid())
    {
        ghosts.sumInside();
        scalarField denser(mesh_.nCells(), Zero);
        forAll(images, a)
        {
            if (parts[a].empty())
            {
                continue;
            }
            const clumpImage& image = images[a];
            const clumpType& type = types_[image.typeId];
            const scalar more = max(image.inside - type.volume(), scalar(0));
            const scalar displaced = more/type.surface().area(image.x);
            for (const part& p : parts[a])
            {
                denser[p.celli] +=
                    (densities_[image.typeId] - 1)*inside(image, p, displaced);
            }
        }
        density_->primitiveFieldRef() = 1 + denser/covered;
        density_->correctBoundaryConditions();
    }
}


Foam::scalar Foam::interiorFluids::excessMass() const
{
    return
        density_.valid()
      ? sum(mesh_.V()*(density_->primitiveField() - 1)) : 0;
}


Foam::vector Foam::interiorFluids::excessMomentum(const volVectorField& U) const
{
    return
        density_.valid()
      ? sum(mesh_.V()*(density_->primitiveField() - 1)*U.primitiveField()) : Zero;
}
