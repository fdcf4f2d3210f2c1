/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneContacts.H"
#include "checkedEntries.H"
#include "foamCompat.H"
#include "sphereGrid.H"
#include "surfaceSpacing.H"

namespace
{

using namespace Foam;

//- The law of the entry type; null without it
autoPtr<contactModel> lawOf(const dictionary& dict)
{
    if (!dict.found("type"))
    {
        checkEntries(dict, {"range", "stress", "filmCutOff", "inside"});
        return autoPtr<contactModel>();
    }
    dictionary own(dict);
    own.remove("range");
    own.remove("filmCutOff");
    own.remove("inside");
    autoPtr<contactModel> result(selectModel<contactModel>(own));
    if (result->frictional())
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'friction' and 'rollingFriction' do not act on membranes."
            << " Remove them from membraneContact." << exit(FatalIOError);
    }
    return result;
}


nodeContact contactOf
(
    const label i,
    const vector& normal,
    const scalar gap,
    const scalar area,
    const scalar moves,
    const scalar radius
)
{
    nodeContact c;
    c.nodes = -1;
    c.weights = scalar(0);
    c.nodes[0] = i;
    c.weights[0] = 1;
    c.normal = normal;
    c.gap = gap;
    c.start = gap;
    c.radius = radius;
    c.faces = false;
    c.atWall = false;
    c.first = -1;
    c.second = -1;
    c.area = area;
    c.moves = moves;
    return c;
}

}


Foam::membraneContacts::membraneContacts
(
    const PtrList<clumpType>& types,
    const polyBoundaryMesh& patches,
    const dictionary& dict
)
:
    types_(types),
    patches_(patches),
    law_(lawOf(dict.subOrEmptyDict("membraneContact"))),
    stress_(0),
    range_(0),
    dt_(0),
    film_(nullptr),
    layer_({0, 0, 0}),
    gaps_(nullptr),
    beyond_(0),
    width_(0),
    meshVelocity_(Zero)
{
    const dictionary entries(dict.subOrEmptyDict("membraneContact"));
    cells_ = getBetweenOrDefault
    (
        entries, "range", scalar(surfaceSpacing::byDefault), 0.05, 2
    );
    cutOff_ = getBetweenOrDefault(entries, "filmCutOff", 2, 0.2, 5);
    if (!law_.valid() && entries.found("stress"))
    {
        stress_ = getPositive(entries, "stress");
    }
}


Foam::vector Foam::membraneContacts::coordinates
(
    const triFace& t,
    const pointField& x,
    const point& p
)
{
    const vector a(x[t[1]] - x[t[0]]);
    const vector b(x[t[2]] - x[t[0]]);
    const vector r(p - x[t[0]]);
    const vector n(a ^ b);
    const scalar size = max(magSqr(n), VSMALL);
    const scalar weightA = ((r ^ b) & n)/size;
    const scalar weightB = ((a ^ r) & n)/size;
    return vector(1 - weightA - weightB, weightA, weightB);
}


void Foam::membraneContacts::setTriangle
(
    nodeContact& c,
    const triFace& t,
    const pointField& x,
    const point& at
)
{
    const vector w(coordinates(t, x, at));
    for (label n = 0; n < 3; ++n)
    {
        c.nodes[n] = t[n];
        c.weights[n] = -w[n];
    }
}


void Foam::membraneContacts::refuseSmallSpheres(const dictionary& types) const
{
    for (const clumpType& membrane : types_)
    {
        if (!membrane.hasTriangles())
        {
            continue;
        }
        const scalar least =
            0.6*membrane.surface().edgeLength(membrane.centres());
        for (const clumpType& other : types_)
        {
            if (!other.hasTriangles() && min(other.radii()) < least)
            {
                FatalIOErrorInFunction(types)
                    << "Spheres of type " << other.name() << " have a radius of "
                    << min(other.radii()) << " m and would pass between the nodes of"
                    << " membranes of type " << membrane.name() << ", which need "
                    << least << " m. Refine the surface (entry subdivisions), or switch"
                    << " the effect contact off." << exit(FatalIOError);
            }
        }
    }
}


void Foam::membraneContacts::refuseOverlaps
(
    const ghostExchange& ghosts,
    const dictionary& placement
) const
{
    const UList<clumpImage>& images = ghosts.images();
    sphereGrid::forEachNear
    (
        images, ghosts.nOwn(), scalarField(ghosts.nOwn(), Zero),
        [&](const label a, const label b)
        {
            const clumpImage& A = images[a];
            const clumpImage& B = images[b];
            bool overlap = false;
            if (!typeOf(A).hasTriangles())
            {
                return;
            }
            if (typeOf(B).hasTriangles())
            {
                const surfaceDistance distance
                (
                    typeOf(B).surface(), B.x, B.transform.invertsHands()
                );
                const scalar side = isInside(A, A.x, B, distance) ? -1 : 1;
                for (const auto& p : distance.nearest(A.x, typeOf(B).halfWidth()))
                {
                    overlap = overlap || (p.found && side*p.distance < 0);
                }

                // Also of surfaces that are the same, if none may be inside the other
                const pointField centre(1, average(A.x));
                const auto p = distance.nearest(centre, typeOf(B).reach())[0];
                overlap =
                    overlap
                 || (
                        p.found && p.distance < 0
                     && !inside_.found(labelPair(A.typeId, B.typeId))
                     && !inside_.found(labelPair(B.typeId, A.typeId))
                    );
            }
            else
            {
                forAll(B.x, j)
                {
                    overlap =
                        overlap
                     || min(mag(A.x - B.x[j])) < typeOf(B).radii()[j];
                }
            }
            if (overlap && A.id == B.id)
            {
                FatalIOErrorInFunction(placement)
                    << "Entry 'position': the surface of clump " << A.id.second()
                    << " (type " << typeOf(A).name() << ") reaches into its own"
                    << " periodic image: it is wider than the mesh. Check the unit of"
                    << " its shape (entry 'scale' of a surface from a file)."
                    << exit(FatalIOError);
            }
            if (overlap)
            {
                FatalIOErrorInFunction(placement)
                    << "Entry 'position': the surface of clump " << A.id.second()
                    << " (type " << typeOf(A).name() << ") reaches into clump "
                    << B.id.second() << " (type " << typeOf(B).name()
                    << "); move them apart." << exit(FatalIOError);
            }
        }
    );
}


Foam::contactModel::pressure Foam::membraneContacts::law
(
    const nodeContact& c,
    const scalar gap
) const
{
    contactModel::pressure result;
    if (law_.valid())
    {
        result = law_->surfacePressure(range_ - gap, c.radius);
    }
    else
    {
        const scalar s = max(1 - gap/range_, scalar(0));
        result =
        {
            stress_*range_/3*pow3(s), stress_*sqr(s), 2*stress_/range_*s
        };
    }
    if (c.faces && film_)
    {
        result += film_->surfacePressure(gap, c.start, dt_, c.radius, layer_);
    }
    if (c.faces && gaps_)
    {
        // Beyond the range of contact
        result += gaps_->surfacePressure
        (
            gap - range_, c.start - range_, dt_, c.radius,
            {c.first, c.second, c.atWall, width_}
        );
    }
    return result;
}


void Foam::membraneContacts::setStart
(
    nodeContact& c,
    const body& nodes,
    const vector& moved
) const
{
    const label i = c.nodes[0];
    if ((nodes.outwards[i] & c.normal) < 0)
    {
        // Where the nearest point jumps along an edge, the gap was not one before
        const scalar opened = c.normal & (nodes.moved[i] - moved);
        c.start = max(c.gap - opened, min(c.gap, scalar(0)));
        c.faces = true;
    }
}


Foam::scalar Foam::membraneContacts::filmLimit() const
{
    scalar smallest = GREAT;
    for (const clumpType& type : types_)
    {
        if (type.hasTriangles())
        {
            smallest = min(smallest, type.halfWidth());
        }
    }
    return smallest < GREAT ? smallest : 0;
}


void Foam::membraneContacts::begin
(
    const ghostExchange& ghosts,
    const scalar width,
    const scalar dt,
    const vector& meshVelocity,
    const gapForces& gaps,
    const bool films,
    const scalar mu
)
{
    width_ = width;
    range_ = cells_*width;
    film_ = films ? gaps.film() : nullptr;
    gaps_ = gaps.hasLaws() ? &gaps : nullptr;
    beyond_ = gaps.lawRange(width);
    const scalar limit = min(cutOff_*width, filmLimit());
    layer_ = {mu, film_ ? limit : 0, min(0.1*width, limit)};
    dt_ = dt;
    meshVelocity_ = meshVelocity;
    const UList<clumpImage>& images = ghosts.images();
    startU_.setSize(images.size());
    forAll(images, a)
    {
        startU_[a] = images[a].u;
    }
}


Foam::tmp<Foam::pointField> Foam::membraneContacts::imposed
(
    const ghostExchange& ghosts,
    const label a
) const
{
    const clumpImage& image = ghosts.images()[a];
    const clumpType& type = typeOf(image);
    if (type.hasTriangles())
    {
        return image.x + dt_*(image.u - startU_[a]);
    }

    // Spheres are coupled with the fluid in the middle of the step, see deformableCloud
    const vector velocity
    (
        type.fixed()
      ? vector::zero : sum(type.masses()*startU_[a])/type.mass()
    );
    return
        image.x - 0.5*dt_*(velocity - meshVelocity_)
      + dt_*(type.fixed() ? vectorField(image.u.size(), Zero) : image.u)
      - dt_*meshVelocity_;
}


const Foam::surfaceDistance& Foam::membraneContacts::distance
(
    const ghostExchange& ghosts,
    const label a
)
{
    body& b = bodies_[a];
    if (!b.distance.valid())
    {
        const clumpImage& image = ghosts.images()[a];
        b.distance.reset
        (
            new surfaceDistance
            (
                typeOf(image).surface(), b.x, image.transform.invertsHands()
            )
        );
    }
    return *b.distance;
}


void Foam::membraneContacts::findNodes
(
    const ghostExchange& ghosts,
    const label nodes,
    const label triangles,
    const bool ofNodes,
    DynamicList<nodeContact>& contacts
)
{
    const body& from = bodies_[nodes];
    const body& to = bodies_[triangles];
    const clumpType& type = typeOf(ghosts.images()[triangles]);

    const boundBox around(grown(to.box, reach()));
    DynamicList<label> near;
    forAll(from.x, i)
    {
        if (around.contains(from.x[i]))
        {
            near.append(i);
        }
    }
    if (near.empty())
    {
        return;
    }

    const scalar R = contactModel::reduced
    (
        typeOf(ghosts.images()[nodes]).halfWidth(), type.halfWidth()
    );

    // Of a container the inner side counts
    const scalar side =
        inside_.size()
     && isInside
        (
            ghosts.images()[nodes], from.x,
            ghosts.images()[triangles], distance(ghosts, triangles)
        )
      ? -1 : 1;

    // Deep inside, too
    const pointField x(from.x, near);
    const auto places = distance(ghosts, triangles).nearest
    (
        x, max(reach(), type.halfWidth())
    );
    forAll(near, k)
    {
        const auto& p = places[k];
        if (!p.found || side*p.distance >= reach())
        {
            continue;
        }
        nodeContact c
        (
            contactOf
            (
                near[k], side*p.outwards, side*p.distance, 0.5*from.areas[near[k]], 2, R
            )
        );
        const triFace& t = type.surface().triangles()[p.triangle];
        if (acrossGaps())
        {
            c.first = ghosts.images()[nodes].typeId;
            c.second = ghosts.images()[triangles].typeId;
            const vector w(coordinates(t, to.x, p.at));
            setStart
            (
                c, from,
                w[0]*to.moved[t[0]] + w[1]*to.moved[t[1]] + w[2]*to.moved[t[2]]
            );
        }
        if (!ofNodes)
        {
            setTriangle(c, t, to.x, p.at);
        }
        contacts.append(c);
    }
}


void Foam::membraneContacts::findSelf
(
    const ghostExchange& ghosts,
    const label a,
    DynamicList<nodeContact>& contacts
)
{
    const label typei = ghosts.images()[a].typeId;
    const clumpType& type = types_[typei];
    selves_.setSize(types_.size());
    if (!selves_.set(typei))
    {
        selves_.set(typei, new selfDistance(type.surface(), type.centres()));
    }
    const selfDistance& self = selves_[typei];
    const scalar range = min(range_, 0.9*self.thickness());

    const body& b = bodies_[a];
    for (const auto& p : self.find(b.x, range))
    {
        // The force begins at the gap of this range
        const nodeContact c
        (
            contactOf
            (
                p.node, p.opens, p.gap + range_ - range, 0.5*b.areas[p.node], 2,
                0.5*type.halfWidth()
            )
        );
        contacts.append(c);
        contacts.append(c);
        setTriangle(contacts.last(), type.surface().triangles()[p.triangle], b.x, p.at);
    }
}


void Foam::membraneContacts::findSpheres
(
    const ghostExchange& ghosts,
    const label membrane,
    const label spheres,
    DynamicList<nodeContact>& contacts,
    DynamicList<label>& nearest
)
{
    const body& nodes = bodies_[membrane];
    const body& others = bodies_[spheres];
    const clumpType& type = typeOf(ghosts.images()[spheres]);
    const scalarField& r = type.radii();

    const scalar halfWidth = typeOf(ghosts.images()[membrane]).halfWidth();
    const boundBox around(grown(others.box, max(r) + reach()));
    forAll(nodes.x, i)
    {
        if (!around.contains(nodes.x[i]))
        {
            continue;
        }
        scalar gap = reach();
        label at = -1;
        forAll(others.x, j)
        {
            const scalar g = mag(nodes.x[i] - others.x[j]) - r[j];
            if (g < gap)
            {
                gap = g;
                at = j;
            }
        }
        if (at >= 0)
        {
            const vector d(nodes.x[i] - others.x[at]);
            contacts.append
            (
                contactOf
                (
                    i, d/max(mag(d), SMALL*r[at]), gap, nodes.areas[i],
                    type.fixed() ? 1 : 2, contactModel::reduced(halfWidth, r[at])
                )
            );
            if (acrossGaps())
            {
                contacts.last().first = ghosts.images()[membrane].typeId;
                contacts.last().second = ghosts.images()[spheres].typeId;
                setStart(contacts.last(), nodes, others.moved[at]);
            }
            nearest.append(at);
        }
    }
}


void Foam::membraneContacts::findWalls
(
    const label a,
    const label type,
    const wallSurface& walls,
    DynamicList<nodeContact>& contacts
) const
{
    const scalar halfWidth = types_[type].halfWidth();
    const body& nodes = bodies_[a];
    if (walls.empty() || walls.near(grown(nodes.box, reach())).empty())
    {
        return;
    }
    forAll(nodes.x, i)
    {
        wallSurface::nearPlace wall;
        if
        (
            walls.nearest(nodes.x[i], max(4*range_, reach()), wall)
         && wall.height < reach()
        )
        {
            contacts.append
            (
                contactOf(i, wall.away, wall.height, nodes.areas[i], 1, halfWidth)
            );
            if (acrossGaps())
            {
                contacts.last().first = type;
                contacts.last().second = wall.patch;
                contacts.last().atWall = true;
                setStart(contacts.last(), nodes, wall.moved);
            }
        }
    }
}


void Foam::membraneContacts::find
(
    const ghostExchange& ghosts,
    Cloud<clumpParcel>& clumps,
    const bool betweenClumps,
    const wallContacts* walls
)
{
    const UList<clumpImage>& images = ghosts.images();
    UPtrList<clumpParcel> own(ghosts.nOwn());
    label n = 0;
    for (clumpParcel& p : clumps)
    {
        nodesOf(p).contacts.clear();
        nodesOf(p).bonds.clear();
        p.step().otherKindForces = externalForces();
        own.set(n++, &p);
    }
    if (range_ <= 0)
    {
        return;
    }

    bodies_.clear();
    bodies_.setSize(images.size());
    forAll(images, a)
    {
        bodies_.set(a, new body);
        body& b = bodies_[a];
        b.x = imposed(ghosts, a);
        if (acrossGaps())
        {
            const clumpType& type = typeOf(images[a]);
            b.moved = scalar(!type.fixed())*dt_*images[a].u;
            if (type.hasTriangles())
            {
                b.outwards = type.surface().areaVectors(b.x);
                b.outwards *= images[a].transform.invertsHands() ? -1 : 1;
            }
        }
        b.box = boundBox(b.x, false);
        if (typeOf(images[a]).hasTriangles())
        {
            b.areas = typeOf(images[a]).surface().nodeAreas(images[a].x);
            if (a < ghosts.nOwn() && walls)
            {
                findWalls
                (
                    a, images[a].typeId, walls->surface(),
                    nodesOf(own[a]).contacts
                );
            }
            if (a < ghosts.nOwn() && betweenClumps)
            {
                findSelf(ghosts, a, nodesOf(own[a]).contacts);
            }
        }
    }
    findBonds(ghosts, own, walls);
    if (!betweenClumps)
    {
        return;
    }
    sphereGrid::forEachNear
    (
        images, ghosts.nOwn(), scalarField(ghosts.nOwn(), max(4*range_, reach())),
        [&](const label a, const label b)
        {
            const bool membrane = typeOf(images[a]).hasTriangles();
            const bool other = typeOf(images[b]).hasTriangles();
            if (membrane && other)
            {
                findNodes(ghosts, a, b, true, nodesOf(own[a]).contacts);
                findNodes(ghosts, b, a, false, nodesOf(own[a]).contacts);
            }
            else if (membrane)
            {
                DynamicList<label> unused;
                findSpheres(ghosts, a, b, nodesOf(own[a]).contacts, unused);
            }
            else if (other)
            {
                addToSpheres(ghosts, b, a, own[a]);
            }
        }
    );
}


void Foam::membraneContacts::addToSpheres
(
    const ghostExchange& ghosts,
    const label membrane,
    const label spheres,
    clumpParcel& p
)
{
    DynamicList<nodeContact> contacts;
    DynamicList<label> nearest;
    findSpheres(ghosts, membrane, spheres, contacts, nearest);
    externalForces& ext = p.step().otherKindForces;
    if (contacts.size() && ext.f.empty())
    {
        ext = externalForces(p.state().x.size());
    }
    forAll(contacts, k)
    {
        // Linear in the displacement from where the sphere was imposed
        const nodeContact& c = contacts[k];
        const auto w(law(c, c.gap));
        const label j = nearest[k];
        const symmTensor K
        (
            c.moves*c.area*max(w.stiffness, scalar(0))*sqr(c.normal)
        );
        ext.k[j] += K;
        ext.f[j] +=
            (K & (dt_*p.step().imposedU[j])) - c.area*w.value*c.normal;
    }
}


void Foam::membraneContacts::addBlocks
(
    const surfacePoint& at,
    const Eigen::Matrix3d& K,
    membraneTangent& tangent
)
{
    for (label n = 0; n < 3 && at.nodes[n] >= 0; ++n)
    {
        for (label m = 0; m < 3 && at.nodes[m] >= 0; ++m)
        {
            if (at.nodes[n] >= at.nodes[m])
            {
                tangent.add
                (
                    at.nodes[n], at.nodes[m], at.weights[n]*at.weights[m]*K
                );
            }
        }
    }
}


void Foam::membraneContacts::addForces
(
    const UList<nodeContact>& contacts,
    vectorField& F
) const
{
    for (const nodeContact& c : contacts)
    {
        c.spread(c.area*law(c, c.gap).value*c.normal, F);
    }
}


Foam::scalar Foam::membraneContacts::add
(
    const UList<nodeContact>& contacts,
    const vectorField& d,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    scalar potential = 0;
    for (const nodeContact& c : contacts)
    {
        scalar opened = 0;
        for (label n = 0; n < 3 && c.nodes[n] >= 0; ++n)
        {
            opened += c.weights[n]*(c.normal & d[c.nodes[n]]);
        }
        const auto w(law(c, c.gap + c.moves*opened));
        potential += c.area/c.moves*w.energy;

        const Eigen::Vector3d normal(c.normal.x(), c.normal.y(), c.normal.z());
        const scalar k = tangent ? tangent->kept(w.stiffness) : 0;
        const Eigen::Matrix3d K(c.moves*c.area*k*normal*normal.transpose());
        for (label n = 0; n < 3 && c.nodes[n] >= 0; ++n)
        {
            gradient[c.nodes[n]] -= c.weights[n]*c.area*w.value*c.normal;
        }
        if (tangent)
        {
            addBlocks(c, K, *tangent);
        }
    }
    return potential;
}
