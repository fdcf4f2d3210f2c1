/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cloudMembranes.H"
#include "buckledPart.H"
#include "foamCompat.H"
#include "sceneScales.H"

namespace
{
    //- Part of the surface above which a membrane counts as buckled
    constexpr Foam::scalar buckles = 0.02;
}


Foam::cloudMembranes::cloudMembranes
(
    const fvMesh& mesh,
    const PtrList<clumpType>& types,
    const dictionary& clumpProperties
)
:
    mesh_(mesh),
    types_(types),
    contacts_(types, clumpProperties)
{}


void Foam::cloudMembranes::read(const label typei, const dictionary& dict)
{
    steps_.setSize(types_.size());
    if (types_[typei].hasSurface())
    {
        steps_.set(typei, new membraneStep(types_[typei], dict, contacts_));
        unchecked_.insert(typei);
        if (!mechanics(typei).bends())
        {
            unbent_.insert(typei);
        }
    }
}


void Foam::cloudMembranes::setContactStress(scalar stress, string reason)
{
    scalar ofShear = 0;
    forAll(types_, i)
    {
        if (types_[i].hasSurface())
        {
            ofShear = max(ofShear, stressOfShear(mechanics(i)));
        }
    }

    // Stiffer contacts would be of no use: the membranes deform instead
    if (ofShear > 0 && ofShear < stress)
    {
        stress = ofShear;
        reason = "that of the stiffest membrane in shear";
    }
    contacts_.setStress(min(stress, largestEntry));
    Info<< "membraneContact: " << stress << " Pa where surfaces touch, "
        << reason.c_str() << endl;
}


void Foam::cloudMembranes::beginContacts
(
    const Cloud<clumpParcel>& clumps,
    const ghostExchange& ghosts,
    const vector& meshVelocity,
    const scalar mu
)
{
    contacts_.begin
    (
        ghosts,
        membraneContacts::narrowest(clumps, types_),
        mesh_.time().deltaTValue(),
        meshVelocity,
        mu
    );
}


void Foam::cloudMembranes::immerse
(
    Cloud<clumpParcel>& clumps,
    ghostExchange& ghosts,
    surfaceImmersion& surfaces,
    const scalar mu
)
{
    surfaces.update(ghosts);
    label index = 0;
    for (clumpParcel& p : clumps)
    {
        const clumpImage& image = ghosts.images()[index++];
        if (isOne(p))
        {
            const label typei = p.typeId();
            steps_[typei].meet(p, image.x);
            nodeFlow& nodes = p.step().nodes;
            const surfaceKernel& kernel = surfaces.kernel(typei);
            const scalar ratio = types_[typei].viscosityRatio();
            const scalarField widths(surfaces.widths(image, nodes.areaVectors));
            nodes.smoothing = widths;
            forAll(widths, i)
            {
                nodes.smoothing[i] *=
                    kernel.meanDistance(normalised(nodes.areaVectors[i]));
            }
            if (ratio != 1)
            {
                nodes.layer = mu*kernel.deficit(ratio)*widths;
            }
        }
    }
    if (unchecked_.size())
    {
        warnOfLeaks(clumps, ghosts, surfaces);
    }
    if (unbent_.size())
    {
        warnOfBuckling(clumps);
    }
}


void Foam::cloudMembranes::warnOfLeaks
(
    const Cloud<clumpParcel>& clumps,
    const ghostExchange& ghosts,
    const surfaceImmersion& surfaces
)
{
    scalarList apart(types_.size(), Zero);
    label index = 0;
    for (const clumpParcel& p : clumps)
    {
        const clumpImage& image = ghosts.images()[index++];
        const label typei = p.typeId();
        if (unchecked_.found(typei))
        {
            const closedSurface& surface = types_[typei].surface();
            const scalar h =
                average(surfaces.widths(image, surface.areaVectors(image.x)));
            apart[typei] =
                max(apart[typei], surface.edgeLength(image.x)/max(h, VSMALL));
        }
    }
    reduceList(apart, maxEqOp<scalar>());
    forAll(apart, typei)
    {
        const scalar allowed = min(surfaces.kernel(typei).support(), scalar(1.5));
        if (apart[typei] > 0)
        {
            unchecked_.erase(typei);
        }
        if (apart[typei] > allowed)
        {
            WarningInFunction
                << "Neighbouring nodes of '" << types_[typei].name() << "' are "
                << apart[typei] << " mesh cells apart (mean of a membrane); above "
                << allowed << " with its kernel, fluid passes between them. Give its"
                << " shape more subdivisions (or the surface file more triangles), or"
                << " use a coarser mesh." << endl;
        }
    }
}


void Foam::cloudMembranes::warnOfBuckling(const Cloud<clumpParcel>& clumps)
{
    scalarList parts(types_.size(), Zero);
    for (const clumpParcel& p : clumps)
    {
        const label typei = p.typeId();
        if (unbent_.found(typei))
        {
            const scalar part =
                buckledPart(types_[typei].surface(), p.state().x);
            parts[typei] = max(parts[typei], part);
        }
    }
    reduceList(parts, maxEqOp<scalar>());
    forAll(parts, typei)
    {
        const clumpType& type = types_[typei];
        if
        (
            parts[typei] <= buckles
         || parts[typei] - buckledPart(type.surface(), type.centres()) <= buckles
        )
        {
            continue;
        }
        unbent_.erase(typei);

        // Against a compression of a fifth of the shear modulus, in waves of six edges
        const scalar enough =
            0.1*mechanics(typei).shearStiffness()/type.surface().nNodes();
        WarningInFunction
            << "A membrane of '" << type.name() << "' is buckled in waves as short as"
            << " its triangles, over " << 100*parts[typei] << " % of its surface at"
            << " time " << mesh_.time().timeName() << ". It is under compression and"
            << " nothing resists its bending, so that its shape depends on its"
            << " triangles. Give its membrane, for example,  bending { type helfrich;"
            << " bendingStiffness " << enough << "; }" << endl;
    }
}


void Foam::cloudMembranes::impose
(
    Cloud<clumpParcel>& clumps,
    ghostExchange& ghosts,
    surfaceImmersion& surfaces,
    const bool clumpsTouch,
    const wallSurface* walls
)
{
    contacts_.find(ghosts, clumps, clumpsTouch, walls);
    label index = 0;
    for (clumpParcel& p : clumps)
    {
        clumpImage& image = ghosts.images()[index++];
        if (isOne(p))
        {
            steps_[p.typeId()].impose
            (
                p, mesh_.time().deltaTValue(), mesh_.time().deltaT0Value()
            );
            image.force = p.step().nodes.force;
        }
    }
    surfaces.spread(ghosts);
}


void Foam::cloudMembranes::sample
(
    const volVectorField& U,
    Cloud<clumpParcel>& clumps,
    ghostExchange& ghosts,
    surfaceImmersion& surfaces,
    const scalar mu
) const
{
    surfaces.sample(U, ghosts);
    label index = 0;
    for (clumpParcel& p : clumps)
    {
        const clumpImage& image = ghosts.images()[index++];
        if (isOne(p))
        {
            nodeFlow& nodes = p.step().nodes;
            nodes.u = nodes.withoutFlux(image.sampled);
        }
    }
    if (mu > 0)
    {
        sharpen(U, clumps, ghosts, surfaces, mu);
    }
}


void Foam::cloudMembranes::sharpen
(
    const volVectorField& U,
    Cloud<clumpParcel>& clumps,
    ghostExchange& ghosts,
    const surfaceImmersion& surfaces,
    const scalar mu
) const
{
    const bool other = surfaces.interior();
    if (other)
    {
        surfaces.sampleShear(U, ghosts, mu);
    }
    label index = 0;
    for (clumpParcel& p : clumps)
    {
        const clumpImage& image = ghosts.images()[index++];
        if (!isOne(p))
        {
            continue;
        }
        nodeFlow& nodes = p.step().nodes;
        const clumpType& type = types_[p.typeId()];
        const scalar ratio = type.viscosityRatio();
        const vectorField n(nodes.areaVectors/mag(nodes.areaVectors));
        vectorField kink(n.size(), Zero);
        if (other)
        {
            // The part of the force follows in membraneStep
            kink = (1 - 1/ratio)*image.sampled;
            const surfaceKernel& kernel = surfaces.kernel(p.typeId());
            const scalarField widths(surfaces.widths(image, nodes.areaVectors));
            forAll(n, i)
            {
                nodes.u[i] -= kernel.overlap(n[i])*widths[i]*kink[i];
            }
        }
        const vectorField& F = nodes.force;
        kink -= 0.5*(1 + 1/ratio)/mu*(F - n*(n & F))/nodes.areas;
        nodes.u +=
            ratio/(3 + 2*ratio)*surfaces.variances(image, nodes.areaVectors)
           *type.surface().divergence(image.x, kink)*n;
    }
}


void Foam::cloudMembranes::advance(clumpParcel& p, const scalar mu) const
{
    steps_[p.typeId()].advance
    (
        p, mu, mesh_.time().deltaTValue(), mesh_.time().deltaT0Value()
    );
}
