/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneContacts.H"
#include "foamCompat.H"
#include "HashSet.H"
#include "Map.H"
#include "toEigen.H"
#include "wallDisplacement.H"
#include <map>

Foam::membraneContacts::bondForce Foam::membraneContacts::bondLaw
(
    const bondKinetics& kinetics,
    const vector& d
) const
{
    const scalar length = mag(d);
    const scalar s = length - range_;
    const scalar tension = kinetics.tension(s);
    if (!(tension > 0))
    {
        return {0, Zero, Zero};
    }
    const vector e(d/length);
    return
    {
        kinetics.energy(s),
        tension*e,
        kinetics.stiffness(s)*sqr(e) + tension/length*(symmTensor::I - sqr(e))
    };
}


void Foam::membraneContacts::findBonds
(
    const ghostExchange& ghosts,
    UPtrList<clumpParcel>& own,
    const wallContacts* walls
) const
{
    if (!gaps_ || !gaps_->bonds())
    {
        return;
    }
    const UList<clumpImage>& images = ghosts.images();
    Map<label> ownOf;
    Map<DynamicList<label>> imagesOf;
    forAll(images, a)
    {
        if (typeOf(images[a]).hasTriangles())
        {
            const label id = images[a].id.second();
            imagesOf(id).append(a);
            if (a < ghosts.nOwn())
            {
                ownOf.insert(id, a);
            }
        }
    }

    // Where an end of a bond is, on an image; false where its surface has no such place
    const auto at = [&]
    (
        const surfaceBond& bond, const bool first, const label image, nodeBond& end, point& x
    )
    {
        const clumpType& type = typeOf(images[image]);
        const UList<triFace>& triangles = type.surface().triangles();
        end.nodes = -1;
        end.weights = scalar(0);
        if (first && bond.sphere.first() >= 0 && bond.sphere.first() < type.size())
        {
            end.nodes[0] = bond.sphere.first();
            end.weights[0] = 1;
        }
        else if
        (
            !first && bond.sphere.second() >= 0
         && bond.sphere.second() < triangles.size()
        )
        {
            const triFace& t = triangles[bond.sphere.second()];
            for (label n = 0; n < 3; ++n)
            {
                end.nodes[n] = t[n];
                end.weights[n] = bond.otherAnchor[n];
            }
        }
        else
        {
            return false;
        }
        x = end.of(bodies_[image].x);
        return true;
    };

    const List<surfaceBond>& bonds = gaps_->bonds()->bonds();
    forAll(bonds, number)
    {
        const surfaceBond& bond = bonds[number];
        const bondKinetics* kinetics = gaps_->kinetics(bond.law);
        for (const bool first : {true, false})
        {
            const auto found =
                ownOf.find(first ? bond.clump.first() : bond.clump.second());
            nodeBond end;
            point x;
            if (!kinetics || !found.good() || !at(bond, first, found.val(), end, x))
            {
                continue;
            }
            const label a = found.val();
            end.d = Zero;
            end.number = number;
            end.first = first;
            end.kinetics = kinetics;
            end.moves = bond.atWall() ? 1 : 2;
            if (bond.atWall())
            {
                const label patchi = patches_.findPatchID(bond.patch);
                end.d = bond.otherAnchor - dt_*images[a].u[bond.sphere.first()];
                if (walls && patchi >= 0)
                {
                    end.d += wallDisplacement
                    (
                        *walls, patches_[patchi], x + bond.otherAnchor, dt_
                    );
                }
                nodesOf(own[a]).bonds.append(end);
                continue;
            }

            // The nearest image of the other clump
            bool near = false;
            for
            (
                const label b
              : imagesOf(first ? bond.clump.second() : bond.clump.first())
            )
            {
                nodeBond other;
                point there;
                if
                (
                    b != a && at(bond, !first, b, other, there)
                 && (!near || magSqr(there - x) < magSqr(end.d))
                )
                {
                    near = true;
                    end.d = there - x;
                }
            }
            if (near)
            {
                nodesOf(own[a]).bonds.append(end);
            }
        }
    }
}


void Foam::membraneContacts::addForces
(
    const UList<nodeBond>& bonds,
    vectorField& F
) const
{
    for (const nodeBond& b : bonds)
    {
        b.spread(bondLaw(*b.kinetics, b.d).force, F);
    }
}


Foam::scalar Foam::membraneContacts::add
(
    const UList<nodeBond>& bonds,
    const vectorField& d,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    scalar potential = 0;
    for (const nodeBond& b : bonds)
    {
        const bondForce w(bondLaw(*b.kinetics, b.d - b.moves*b.of(d)));
        potential += w.energy/b.moves;
        b.spread(-w.force, gradient);
        if (tangent)
        {
            addBlocks(b, b.moves*toEigen(w.stiffness), *tangent);
        }
    }
    return potential;
}


Foam::DynamicList<Foam::membraneContacts::bondPlace>
Foam::membraneContacts::bondPlaces
(
    const ghostExchange& ghosts,
    const label a,
    const clumpParcel& p
)
{
    DynamicList<bondPlace> result;
    const UList<clumpImage>& images = ghosts.images();
    const body& from = bodies_[a];

    // From where the nodes end the step, not from where they were imposed
    const vectorField left(dt_*(images[a].u - p.step().end.u));
    for (const nodeContact& c : nodesOf(p).contacts)
    {
        if (c.atWall && c.faces)
        {
            const label i = c.nodes[0];
            const scalar gap = max(c.gap, scalar(0));
            result.append({i, c.gap, -1, c.second, left[i] - gap*c.normal});
        }
    }
    const boundBox around(grown(from.box, reach()));
    forAll(images, b)
    {
        const clumpType& type = typeOf(images[b]);
        if
        (
            !type.hasTriangles() || images[b].id.second() <= images[a].id.second()
         || !bodies_[b].box.overlaps(around)
        )
        {
            continue;
        }
        const boundBox reached(grown(bodies_[b].box, reach()));
        DynamicList<label> near;
        forAll(from.x, i)
        {
            if (reached.contains(from.x[i]))
            {
                near.append(i);
            }
        }
        const pointField x(from.x, near);
        const auto places = distance(ghosts, b).nearest(x, reach());
        forAll(near, k)
        {
            const auto& at = places[k];
            if (at.found && (from.outwards[near[k]] & at.outwards) < 0)
            {
                const triFace& t = type.surface().triangles()[at.triangle];
                result.append
                (
                    {
                        near[k], at.distance, b, at.triangle,
                        coordinates(t, bodies_[b].x, at.at)
                    }
                );
            }
        }
    }
    return result;
}


void Foam::membraneContacts::addBonds
(
    const Cloud<clumpParcel>& clumps,
    const ghostExchange& ghosts,
    const gapForces& gaps,
    const label timeIndex,
    DynamicList<surfaceBond>& result
)
{
    constexpr scalar bound = -1;
    const UList<clumpImage>& images = ghosts.images();
    const List<surfaceBond>& bonds = gaps.bonds()->bonds();
    labelHashSet untouched;
    label a = -1;
    for (const clumpParcel& p : clumps)
    {
        ++a;
        if (!types_[p.typeId()].hasTriangles())
        {
            continue;
        }
        if (range_ <= 0)
        {
            untouched.insert(p.origId());
            continue;
        }

        // The places that are bound, and those whose bond breaks, with its rate. A place
        // is that of the node, whichever triangle is nearest
        std::map<surfaceBond, scalar> places;
        const auto placeOf = [](surfaceBond b)
        {
            b.sphere.second() = 0;
            return b;
        };
        for (const nodeBond& end : nodesOf(p).bonds)
        {
            if (!end.first)
            {
                continue;
            }
            surfaceBond b(bonds[end.number]);
            const label i = b.sphere.first();
            if (b.atWall())
            {
                b.otherAnchor = end.d + dt_*(images[a].u[i] - p.step().end.u[i]);
            }
            b.length = mag(b.atWall() ? b.otherAnchor : end.d);
            const scalar rate = offRate(*end.kinetics, b.length);
            const scalar u = surfaceBonds::uniform
            (
                surfaceBonds::breaking, end.kinetics->values().seed, b, timeIndex
            );
            if (u < end.kinetics->toBreak(rate, dt_))
            {
                places[placeOf(b)] = rate;
                continue;
            }
            places[placeOf(b)] = bound;
            result.append(b);
        }

        // Those that form
        for (const bondPlace& place : bondPlaces(ghosts, a, p))
        {
            const bool atWall = place.image < 0;
            const gapForces::place where
            {
                p.typeId(), atWall ? place.surface : images[place.image].typeId, atWall,
                width_
            };
            for (const gapForces::namedKinetics& law : gaps.kineticsAt(where))
            {
                const bondKinetics& kinetics = *law.second();
                const bondKinetics::molecule& values = kinetics.values();
                if (place.gap - range_ >= values.reach)
                {
                    continue;
                }
                surfaceBond b;
                b.law = law.first();
                b.clump =
                    labelPair(p.origId(), atWall ? -1 : images[place.image].id.second());
                b.sphere = labelPair(place.node, 0);
                if (atWall)
                {
                    b.patch = patches_[place.surface].name();
                }

                // A part of a place is one by chance, the same at all times
                const scalar number = values.density*bodies_[a].areas[place.node];
                const label nPlaces
                (
                    number
                  + surfaceBonds::uniform(surfaceBonds::number, values.seed, b, 0)
                );
                b.born = timeIndex;
                b.otherAnchor = place.anchor;
                b.length = max(place.gap, scalar(0));
                for (b.place = 0; b.place < nPlaces; ++b.place)
                {
                    const auto known = places.find(b);
                    if (known != places.end() && known->second == bound)
                    {
                        continue;
                    }
                    const scalar chance =
                        known != places.end()
                      ? kinetics.toFormAnew(known->second, dt_)
                      : kinetics.toForm(offRate(kinetics, b.length), dt_);
                    if
                    (
                        surfaceBonds::uniform
                        (
                            surfaceBonds::forming, values.seed, b, timeIndex
                        ) < chance
                    )
                    {
                        places[b] = bound;
                        result.append(b);
                        if (!atWall)
                        {
                            result.last().sphere.second() = place.surface;
                        }
                    }
                }
            }
        }
    }
    for (const surfaceBond& b : bonds)
    {
        if (untouched.found(b.clump.first()))
        {
            result.append(b);
        }
    }
}
