/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceImmersion.H"

Foam::surfaceImmersion::surfaceImmersion
(
    const fvMesh& mesh,
    const PtrList<clumpType>& types,
    const dictionary& dict,
    const scalar rho
)
:
    mesh_(mesh),
    types_(types),
    geometry_(mesh),
    force_
    (
        IOobject("membraneForce", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimForce/dimVolume, Zero)
    ),
    fluids_(mesh, types, kernels_, geometry_, widths_, rho)
{
    for (const clumpType& type : types)
    {
        kernels_.append
        (
            type.hasTriangles()
          ? new surfaceKernel(getDict(dict, type.name()))
          : new surfaceKernel(surfaceKernel::form::hat)
        );
    }
    setWidths();
    if (const volScalarField* factor = fluids_.viscosity())
    {
        interior_.reset
        (
            new membraneInterior(mesh, types, kernels_, geometry_, widths_, *factor)
        );
    }
}


void Foam::surfaceImmersion::setWidths()
{
    widths_.setSize(mesh_.nCells());
    forAll(widths_, celli)
    {
        const boundBox box(mesh_.points(), mesh_.cellPoints()[celli], false);

        // Of the volume of the mesh cell, whatever its form
        const vector span(box.span());
        widths_[celli] =
            span*Foam::cbrt(mesh_.V()[celli]/cmptProduct(span));
    }
}


void Foam::surfaceImmersion::meshChanged()
{
    geometry_.update();
    setWidths();
    stencils_.clear();
    fluids_.reset();
    if (interior_.valid())
    {
        interior_->reset();
    }
    force_ = dimensionedVector(dimForce/dimVolume, Zero);
}


void Foam::surfaceImmersion::find
(
    const clumpImage& image,
    DynamicList<stencilCell>& stencil
) const
{
    stencil.clear();
    const surfaceKernel& K = kernels_[image.typeId];
    const scalar support = K.support();

    pointGrid nodes;
    nodes.update(image.x);
    DynamicList<label> near;

    // A mesh cell reaches at least half its width from its centre
    for (const label celli : geometry_.find(boundBox(image.x, false), 2*support))
    {
        const point& x = geometry_[celli].x;
        const vector& h = widths_[celli];
        const boundBox box(x - support*h, x + support*h);
        if (!box.overlaps(image.box))
        {
            continue;
        }
        nodes.find(box, near);
        for (const label i : near)
        {
            const vector r(x - image.x[i]);
            const scalar k = K(r.x()/h.x())*K(r.y()/h.y())*K(r.z()/h.z());
            if (k > 0)
            {
                stencil.append({i, celli, k*geometry_[celli].volume, r});
            }
        }
    }
}


void Foam::surfaceImmersion::find(ghostExchange& ghosts, stencils& found) const
{
    UList<clumpImage>& images = ghosts.images();
    found.setSize(images.size());
    forAll(images, a)
    {
        clumpImage& image = images[a];
        found[a].clear();
        const bool surface = types_[image.typeId].hasTriangles();
        image.moments.reset(surface ? image.x.size() : 0);
        if (!surface)
        {
            image.weights = nodeWeights();
            image.force.clear();
            continue;
        }
        find(image, found[a]);
        for (const stencilCell& m : found[a])
        {
            image.moments.m0[m.node] += m.weight;
            image.moments.m1[m.node] += m.weight*m.r;
            image.moments.m2[m.node] += m.weight*sqr(m.r);
        }
    }

    ghosts.returnMoments();
    for (label a = 0; a < ghosts.nOwn(); ++a)
    {
        images[a].weights.set(images[a].moments);
    }
    ghosts.updateWeights();

    forAll(images, a)
    {
        const nodeWeights& w = images[a].weights;
        for (stencilCell& m : found[a])
        {
            m.weight *= w.a[m.node] + (w.b[m.node] & m.r);
        }
    }
}


void Foam::surfaceImmersion::update(ghostExchange& ghosts)
{
    find(ghosts, stencils_);
    fluids_.set(ghosts);
    if (interior_.valid())
    {
        interior_->set(ghosts.images(), stencils_);
    }
}


Foam::scalarField Foam::surfaceImmersion::widths
(
    const clumpImage& image,
    const vectorField& areaVectors
) const
{
    return Foam::sqrt
    (
        variances(image, areaVectors)/kernels_[image.typeId].variance()
    );
}


Foam::scalar Foam::surfaceImmersion::variance(const clumpImage& image)
{
    scalar sum = 0;
    forAll(image.x, i)
    {
        sum += tr(image.moments.covariance(i))/3;
    }
    return sum/image.x.size();
}


Foam::scalarField Foam::surfaceImmersion::variances
(
    const clumpImage& image,
    const vectorField& areaVectors
) const
{
    scalarField result(image.x.size());
    forAll(result, i)
    {
        const vector n(areaVectors[i]/max(mag(areaVectors[i]), VSMALL));
        result[i] = max(n & (image.moments.covariance(i) & n), scalar(0));
    }
    return result;
}


void Foam::surfaceImmersion::sample
(
    const volVectorField& U,
    const stencils& of,
    ghostExchange& ghosts
)
{
    forAll(of, a)
    {
        clumpImage& image = ghosts.images()[a];
        image.sampled.setSize(image.weights.a.size());
        image.sampled = Zero;
        for (const stencilCell& m : of[a])
        {
            image.sampled[m.node] += m.weight*U[m.celli];
        }
    }
    ghosts.returnSamples();
}


void Foam::surfaceImmersion::sample
(
    const volVectorField& U,
    ghostExchange& ghosts
) const
{
    sample(U, stencils_, ghosts);
}


void Foam::surfaceImmersion::sampleNew
(
    const volVectorField& U,
    ghostExchange& ghosts
) const
{
    stencils found;
    find(ghosts, found);
    sample(U, found, ghosts);
}


void Foam::surfaceImmersion::sampleShear
(
    const volVectorField& U,
    ghostExchange& ghosts,
    const scalar mu
) const
{
    const volTensorField strain(interior_->strain(U, mu));
    forAll(stencils_, a)
    {
        clumpImage& image = ghosts.images()[a];
        const vectorField& normals = interior_->normals(a);
        image.sampled.setSize(image.weights.a.size());
        image.sampled = Zero;
        if (normals.size())
        {
            for (const stencilCell& m : stencils_[a])
            {
                const vector& n = normals[m.node];
                const vector t(n & strain[m.celli]);
                image.sampled[m.node] += m.weight*(t - n*(n & t));
            }
        }
    }
    ghosts.returnSamples();
}


void Foam::surfaceImmersion::spread(ghostExchange& ghosts)
{
    ghosts.updateNodeForces();
    force_.primitiveFieldRef() = Zero;
    forAll(stencils_, a)
    {
        const clumpImage& image = ghosts.images()[a];
        for (const stencilCell& m : stencils_[a])
        {
            force_[m.celli] +=
                m.weight/geometry_[m.celli].volume*image.force[m.node];
        }
    }
    if (interior_.valid())
    {
        interior_->addSlip(ghosts.images(), stencils_, force_);
    }
}
