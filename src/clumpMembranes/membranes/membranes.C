/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membranes.H"
#include "addToRunTimeSelectionTable.H"
#include "buckledPart.H"
#include "checkedEntries.H"
#include "foamCompat.H"
#include "membraneTensions.H"
#include "surfaceSpacing.H"

namespace
{
    //- Part of the surface above which a membrane counts as buckled
    constexpr Foam::scalar buckles = 0.02;

    //- Compression at rest that counts, over the stiffness in shear per area
    constexpr Foam::scalar compresses = 0.01;

    //- Second derivative of the energy of a membrane by the logarithmic strain of a pure
    //  shear across x, y or z, their mean over its volume [Pa]
    Foam::scalar stressOfShear(const Foam::membraneMechanics& m)
    {
        return m.shearStiffness()/m.surface().volume(m.stressFree());
    }

    //- Part of the surface whose smaller tension is below a part of the stiffness in
    //  shear per area
    Foam::scalar partBelow
    (
        const Foam::membraneMechanics& m,
        const Foam::pointField& x,
        const Foam::scalar part
    )
    {
        const Foam::membraneTensions state(m, x);
        return state.partBelow(part*m.shearStiffness()/sum(state.areas()));
    }

    struct addEntries
    {
        addEntries() { Foam::clumpKind::entries().append("membraneContact"); }
    };
    const addEntries added;
}


namespace Foam
{
    defineTypeNameAndDebug(membranes, 0);
    addToRunTimeSelectionTable(clumpKind, membranes, cloud);
}


Foam::membranes::membranes(const clumpKind::site& s)
:
    mesh_(s.mesh),
    types_(s.types),
    clumpProperties_(s.clumpProperties),
    contacts_(s.types, s.mesh.boundaryMesh(), s.clumpProperties)
{}


void Foam::membranes::read(const label typei, const dictionary& dict)
{
    for
    (
        const word key :
        {
            "bondModel", "dampingModel", "conservationModel",
            "conservationModels", "massModel", "mass", "inertia"
        }
    )
    {
        if (dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "': the shape of the type is a surface, whose"
                << " nodes are held together by the entry 'membrane' around a fluid of"
                << " the entry 'density'."
                << exit(FatalIOError);
        }
    }

    // The last three are those of membraneMechanics and surfaceImmersion
    checkEntries
    (
        dict,
        {
            "shape", "density", "motion", "nominalVolume", "scale", "classOf",
            "share", "viscosityRatio", "membrane", "kernel", "unresolvedFlow"
        }
    );
    if (types_[typei].fixed())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'motion': a membrane moves with the fluid and cannot be fixed."
            << exit(FatalIOError);
    }
    steps_.setSize(types_.size());
    steps_.set(typei, new membraneStep(types_[typei], dict, contacts_));
    if (dict.getOrDefault<Switch>("unresolvedFlow", false))
    {
        const clumpType& type = types_[typei];
        if (type.size() == type.surface().nNodes())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'unresolvedFlow' is for a solid, of the shape 'filled': waves that"
                << " the mesh does not resolve would buckle a membrane. Remove it."
                << exit(FatalIOError);
        }
        completed_.insert(typei);
    }
    unchecked_.insert(typei);
    if (!steps_[typei].mechanics().bends())
    {
        unbent_.insert(typei);
        warnOfCompression(typei);
    }
}


void Foam::membranes::check(const scene& s) const
{
    if (!s.coupled)
    {
        FatalIOErrorInFunction(getDict(clumpProperties_, "types"))
            << "Entry 'types': a membrane has no inertia of its own and needs a fluid"
            << " that feels it; without a fluid, or with feedback off or a frozen"
            << " flow, there are only clumps of spheres." << exit(FatalIOError);
    }
    if (!s.damps)
    {
        FatalIOErrorInFunction(getDict(clumpProperties_, "couplingScheme"))
            << "Entry 'type': a membrane is coupled implicitly. Valid here: robin"
            << exit(FatalIOError);
    }
    if (!s.implicit)
    {
        FatalIOErrorInFunction(getDict(clumpProperties_, "integrator"))
            << "Entry 'type': a membrane is advanced implicitly. Valid here:"
            << " implicitEuler" << exit(FatalIOError);
    }
    if (s.clumpsMayTouch)
    {
        contacts_.refuseSmallSpheres(getDict(clumpProperties_, "types"));
    }
}


void Foam::membranes::immerseIn(const scalar rho)
{
    surfaces_.reset
    (
        new surfaceImmersion(mesh_, types_, getDict(clumpProperties_, "types"), rho)
    );
    contacts_.readInside(clumpProperties_, rho);
}


void Foam::membranes::setContactStress(const scalar ofScene, const string& reason)
{
    scalar ofShear = 0;
    forAll(steps_, i)
    {
        if (steps_.set(i))
        {
            ofShear = max(ofShear, stressOfShear(steps_[i].mechanics()));
        }
    }

    // Stiffer contacts would be of no use: the membranes deform instead
    const bool soft = ofShear > 0 && ofShear < ofScene;
    const scalar stress = soft ? ofShear : ofScene;
    contacts_.setStress(min(stress, largestEntry));
    Info<< "membraneContact: " << stress << " Pa where surfaces touch, "
        << (soft ? "that of the stiffest membrane in shear" : reason.c_str()) << endl;
}


void Foam::membranes::beginContacts
(
    const Cloud<clumpParcel>& clumps,
    const ghostExchange& ghosts,
    const vector& meshVelocity,
    const gapForces& gaps,
    const bool films,
    const scalar mu
)
{
    contacts_.begin
    (
        ghosts,
        surfaceSpacing::narrowest(clumps, types_),
        mesh_.time().deltaTValue(),
        meshVelocity,
        gaps,
        films,
        mu
    );
}


void Foam::membranes::immerse
(
    Cloud<clumpParcel>& clumps,
    ghostExchange& ghosts,
    const scalar mu
)
{
    surfaces_->update(ghosts);
    label index = 0;
    for (clumpParcel& p : clumps)
    {
        const clumpImage& image = ghosts.images()[index++];
        if (isOne(p))
        {
            const label typei = p.typeId();
            steps_[typei].setFlowGeometry(p, image.x);
            nodeFlow& nodes = nodesOf(p);
            const surfaceKernel& kernel = surfaces_->kernel(typei);
            const scalar ratio = types_[typei].viscosityRatio();
            const scalarField widths(surfaces_->widths(image, nodes.areaVectors));
            nodes.smoothing = widths;
            forAll(widths, i)
            {
                nodes.smoothing[i] *=
                    kernel.meanDistance(normalised(nodes.areaVectors[i]));
            }
            nodes.unresolved = completed_.found(typei) ? surfaces_->variance(image) : 0;
            if (ratio != 1)
            {
                nodes.layer = mu*kernel.deficit(ratio)*widths;
            }
        }
    }
    if (unchecked_.size())
    {
        warnOfLeaks(clumps, ghosts);
    }
    if (unbent_.size())
    {
        warnOfBuckling(clumps);
    }
}


void Foam::membranes::warnOfLeaks
(
    const Cloud<clumpParcel>& clumps,
    const ghostExchange& ghosts
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
            const scalarField widths
            (
                surfaces_->widths(image, surface.areaVectors(image.x))
            );
            const scalar h = sum(widths)/surface.nNodes();
            apart[typei] =
                max(apart[typei], surface.edgeLength(image.x)/max(h, VSMALL));
        }
    }
    reduceList(apart, maxEqOp<scalar>());
    forAll(apart, typei)
    {
        // Types of pieces that have broken off, and those without a membrane, have no kernel
        if (apart[typei] == 0)
        {
            continue;
        }
        unchecked_.erase(typei);

        const scalar allowed = min(surfaces_->kernel(typei).support(), scalar(1.5));
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


void Foam::membranes::warnOfBuckling(const Cloud<clumpParcel>& clumps)
{
    scalarList parts(types_.size(), Zero);
    for (const clumpParcel& p : clumps)
    {
        const label typei = p.typeId();
        if (unbent_.found(typei))
        {
            const pointField& x = p.state().x;
            const scalar part = buckledPart(types_[typei].surface(), x);

            // Waves have no tension where they are; a drop has it everywhere
            if
            (
                part > max(buckles, parts[typei])
             && partBelow(steps_[typei].mechanics(), x, compresses) > buckles
            )
            {
                parts[typei] = part;
            }
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

        WarningInFunction
            << "A membrane of '" << type.name() << "' is buckled in waves as short as"
            << " its triangles, over " << 100*parts[typei] << " % of its surface at"
            << " time " << mesh_.time().timeName() << ". It is under compression and"
            << " nothing resists its bending, so that its shape depends on its"
            << " triangles. Give its membrane, for example,  bending { type helfrich;"
            << " bendingStiffness " << enoughBending(typei) << "; }" << endl;
    }
}


Foam::scalar Foam::membranes::enoughBending(const label typei) const
{
    return
        0.1*steps_[typei].mechanics().shearStiffness()
       /types_[typei].surface().nNodes();
}


void Foam::membranes::warnOfCompression(const label typei) const
{
    const clumpType& type = types_[typei];
    const membraneMechanics& mechanics = steps_[typei].mechanics();
    const membraneTensions state(mechanics, type.centres());
    const scalar part = partBelow(mechanics, type.centres(), -compresses);
    if (part <= buckles)
    {
        return;
    }
    scalar least = 0;
    for (const Pair<scalar>& T : state.tensions())
    {
        least = min(least, T.second());
    }
    WarningInFunction
        << "The membrane of '" << type.name() << "' is under compression at rest, over "
        << 100*part << " % of its surface and up to " << -least << " N/m, and nothing"
        << " resists its bending: it buckles in waves as short as its triangles. Give it"
        << " another entry stressFree (scaled with a factor below 1 is under tension), a"
        << " tension { type surfaceTension; tension " << -least << "; }, or  bending {"
        << " type helfrich; bendingStiffness " << enoughBending(typei) << "; }" << endl;
}


void Foam::membranes::impose
(
    Cloud<clumpParcel>& clumps,
    ghostExchange& ghosts,
    const bool clumpsTouch,
    const wallContacts* walls
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
            image.force = nodesOf(p).force;
        }
    }
    surfaces_->spread(ghosts);
}


void Foam::membranes::addBonds
(
    const Cloud<clumpParcel>& clumps,
    const ghostExchange& ghosts,
    const gapForces& gaps,
    DynamicList<surfaceBond>& bonds
)
{
    contacts_.addBonds(clumps, ghosts, gaps, mesh_.time().timeIndex(), bonds);
}


void Foam::membranes::sample
(
    const volVectorField& U,
    Cloud<clumpParcel>& clumps,
    ghostExchange& ghosts,
    const scalar mu
) const
{
    surfaces_->sample(U, ghosts);
    label index = 0;
    for (clumpParcel& p : clumps)
    {
        const clumpImage& image = ghosts.images()[index++];
        if (isOne(p))
        {
            nodeFlow& nodes = nodesOf(p);
            nodes.u = nodes.withoutFlux(image.sampled);
        }
    }
    if (mu > 0)
    {
        sharpen(U, clumps, ghosts, mu);
    }
}


void Foam::membranes::sampleFlow(const volVectorField& U, ghostExchange& ghosts) const
{
    surfaces_->sampleNew(U, ghosts);
    for (label i = 0; i < ghosts.nOwn(); ++i)
    {
        clumpImage& image = ghosts.images()[i];
        const clumpType& type = types_[image.typeId];
        if (type.hasTriangles())
        {
            nodeFlow nodes;
            nodes.areaVectors = type.surface().areaVectors(image.x);
            image.sampled = nodes.withoutFlux(image.sampled);
        }
    }
}


void Foam::membranes::sharpen
(
    const volVectorField& U,
    Cloud<clumpParcel>& clumps,
    ghostExchange& ghosts,
    const scalar mu
) const
{
    const bool other = surfaces_->interior();
    if (other)
    {
        surfaces_->sampleShear(U, ghosts, mu);
    }
    label index = 0;
    for (clumpParcel& p : clumps)
    {
        const clumpImage& image = ghosts.images()[index++];
        if (!isOne(p))
        {
            continue;
        }
        nodeFlow& nodes = nodesOf(p);
        const clumpType& type = types_[p.typeId()];
        const scalar ratio = type.viscosityRatio();
        const vectorField n(nodes.normals());
        vectorField kink(n.size(), Zero);
        if (other)
        {
            // The part of the force follows in membraneStep
            kink = (1 - 1/ratio)*image.sampled;
            const surfaceKernel& kernel = surfaces_->kernel(p.typeId());
            const scalarField widths(surfaces_->widths(image, nodes.areaVectors));
            forAll(n, i)
            {
                nodes.u[i] -= kernel.correlation(n[i])*widths[i]*kink[i];
            }
        }
        scalar mobility = 0.5*(1 + 1/ratio);
        if (nodes.unresolved > 0)
        {
            // unresolvedFlow has what remains in a fluid of the mean viscosity
            mobility -= 0.4*(3 + 2*ratio)/(ratio*(1 + ratio));
        }
        const vectorField& F = nodes.force;
        kink -= mobility/mu*(F - n*(n & F))/nodes.areas;
        nodes.u +=
            ratio/(3 + 2*ratio)*surfaces_->variances(image, nodes.areaVectors)
           *type.surface().divergence(image.x, kink)*n;
    }
}


void Foam::membranes::setViscosities
(
    const volScalarField& nu,
    Cloud<clumpParcel>& clumps,
    ghostExchange& ghosts
) const
{
    // The mobility of a membrane is that of the fluid at its nodes
    surfaces_->sample((1/nu)*dimensionedVector("x", dimless, vector(1, 0, 0)), ghosts);
    label index = 0;
    for (clumpParcel& p : clumps)
    {
        const clumpImage& image = ghosts.images()[index++];
        if (isOne(p))
        {
            p.step().nu = 1/average(image.sampled).x();
        }
    }
}


void Foam::membranes::advance(clumpParcel& p, const scalar mu) const
{
    steps_[p.typeId()].advance
    (
        p, mu, mesh_.time().deltaTValue(), mesh_.time().deltaT0Value()
    );
}


Foam::vectorField Foam::membranes::acceleration(const clumpParcel& p) const
{
    return membraneStep::acceleration
    (
        p, mesh_.time().deltaTValue(), mesh_.time().deltaT0Value()
    );
}
