/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"
#include "bondFrame.H"
#include "Map.H"
#include "mathematicalConstants.H"
#include "wallDisplacement.H"
#include <map>


void Foam::contactStep::setBonds()
{
    bondEnds_.clear();
    bondBegins_ = labelList(clumps_.size() + 1, Zero);
    if (!gaps_.bonds())
    {
        return;
    }
    orientations_ = moved_;
    exchangeOrientations();

    Map<label> own;
    for (label a = 0; a < clumps_.size(); ++a)
    {
        if (type(a).ofSpheres() && clumps_[a].pieceOf() < 0)
        {
            own.insert(clumps_[a].origId(), a);
        }
    }
    Map<DynamicList<label>> imagesOf;
    const UList<clumpImage>& images = ghosts_.images();
    forAll(images, b)
    {
        if (images[b].pieceOf < 0 && remote_.localIndex(b) >= 0)
        {
            imagesOf(images[b].id.second()).append(b);
        }
    }

    // The nearest image of the other clump; -1 if there is none
    const auto otherImage = [&](const bondEnd& end, const label id)
    {
        label result = -1;
        scalar least = GREAT;
        for (const label b : imagesOf(id))
        {
            if (b != end.a && end.j >= 0 && end.j < images[b].x.size())
            {
                const scalar away = mag(images[b].x[end.j] - images[end.a].x[end.i]);
                result = away < least ? b : result;
                least = min(away, least);
            }
        }
        return result;
    };

    List<DynamicList<bondEnd>> ofClump(clumps_.size());
    const List<surfaceBond>& bonds = gaps_.bonds()->bonds();
    forAll(bonds, number)
    {
        const surfaceBond& bond = bonds[number];
        const bondKinetics* kinetics = gaps_.kinetics(bond.law);
        for (const bool first : {true, false})
        {
            const auto found =
                own.find(first ? bond.clump.first() : bond.clump.second());
            const label i = first ? bond.sphere.first() : bond.sphere.second();
            if (!kinetics || !found.good() || i < 0 || i >= type(found.val()).size())
            {
                continue;
            }
            bondEnd end;
            end.a = found.val();
            end.i = i;
            end.b = -1;
            end.j = first ? bond.sphere.second() : bond.sphere.first();
            end.otherIndex = -1;
            end.number = number;
            end.first = first;
            end.patch =
                bond.atWall() ? mesh_.boundaryMesh().findPatchID(bond.patch) : -1;
            end.kinetics = kinetics;
            if (!bond.atWall())
            {
                end.b = otherImage
                (
                    end, first ? bond.clump.second() : bond.clump.first()
                );
                end.otherIndex = end.b < 0 ? -1 : remote_.localIndex(end.b);
            }
            if (bond.atWall() || end.b >= 0)
            {
                ofClump[end.a].append(end);
            }
        }
    }
    forAll(ofClump, a)
    {
        bondEnds_.append(ofClump[a]);
        bondBegins_[a + 1] = bondEnds_.size();
    }
}


void Foam::contactStep::exchangeOrientations()
{
    if (!gaps_.bonds())
    {
        return;
    }
    orientations_.setSize(moved_.size());
    for (label a = 0; a < clumps_.size(); ++a)
    {
        const List<quaternion>& q = clumps_[a].step().end.q;
        orientations_[a].setSize(type(a).size());
        forAll(orientations_[a], i)
        {
            orientations_[a][i] = i < q.size() ? rotationVector(q[i]) : vector(Zero);
        }
    }
    remote_.exchange(orientations_);
}


Foam::vector Foam::contactStep::arm
(
    const label index,
    const label i,
    const vector& anchor
) const
{
    return rotation(orientations_[index][i]).transform(anchor);
}


Foam::vector Foam::contactStep::wayOfWall(const bondEnd& e) const
{
    if (e.patch < 0)
    {
        return Zero;
    }
    const surfaceBond& bond = gaps_.bonds()->bonds()[e.number];
    const point place(clumps_[e.a].centres()[e.i] + bond.otherAnchor);
    return wallDisplacement(walls_, mesh_.boundaryMesh()[e.patch], place, wholeDt_);
}


void Foam::contactStep::evaluate(bondEnd& e) const
{
    const surfaceBond& bond = gaps_.bonds()->bonds()[e.number];
    const vector own
    (
        arm(e.a, e.i, e.first ? bond.anchor : bond.otherAnchor)
    );
    if (e.b < 0)
    {
        e.spring.evaluate
        (
            *e.kinetics, bond.otherAnchor + wayOfWall(e) - moved_[e.a][e.i], own, Zero
        );
        return;
    }
    const UList<clumpImage>& images = ghosts_.images();
    const vector between
    (
        images[e.b].x[e.j] + moved_[e.otherIndex][e.j]
      - images[e.a].x[e.i] - moved_[e.a][e.i]
    );
    const vector other
    (
        arm(e.otherIndex, e.j, e.first ? bond.otherAnchor : bond.anchor)
    );
    e.spring.evaluate(*e.kinetics, between, own, other);
}


void Foam::contactStep::addBonds(const label m)
{
    const label a = clumpOf_[m];
    for (label k = bondBegins_[a]; k < bondBegins_[a + 1]; ++k)
    {
        bondEnd& e = bondEnds_[k];
        evaluate(e);
        const bool both = e.b >= 0 && isCoupled_[e.otherIndex];
        energies_[m] += (both ? 0.5 : 1)*e.spring.energy();
        forces_[m][e.i] += e.spring.force();
        torques_[m][e.i] +=
            rotationVectorGradient(turned_[a][e.i], e.spring.torque());
    }
}


Foam::scalar Foam::contactStep::bondEnergy() const
{
    scalar result = 0;
    for (const label a : clumpOf_)
    {
        for (label k = bondBegins_[a]; k < bondBegins_[a + 1]; ++k)
        {
            const bondEnd& e = bondEnds_[k];
            const bool both = e.b >= 0 && isCoupled_[e.otherIndex];
            result += (both ? 0.5 : 1)*e.spring.energy();
        }
    }
    return result;
}


void Foam::contactStep::coupleBonds(const motions& p, motions& Ap)
{
    const List<vectorField> moves(gatherVectors(p));
    const List<vectorField> turns(gatherVectors(p, 3));
    vector F, M;
    forAll(coupled_, m)
    {
        const label a = clumpOf_[m];
        for (label k = bondBegins_[a]; k < bondBegins_[a + 1]; ++k)
        {
            const bondEnd& e = bondEnds_[k];
            if (e.b >= 0 && moves[e.otherIndex].size())
            {
                e.spring.ofOther
                (
                    moves[e.otherIndex][e.j], turns[e.otherIndex][e.j], F, M
                );
                Ap[m].segment<6>(6*e.i) -=
                    (Eigen::Matrix<scalar, 6, 1>()
                  << F.x(), F.y(), F.z(), M.x(), M.y(), M.z()).finished();
            }
        }
    }
}


Foam::surfaceBond Foam::contactStep::bondAt
(
    const sphereContact& t,
    const word& law,
    const label surface
) const
{
    surfaceBond b;
    b.law = law;
    b.clump = labelPair(clumps_[t.a].origId(), -1);
    b.sphere = labelPair(t.i, surface);
    if (t.b < 0)
    {
        b.patch = mesh_.boundaryMesh()[t.patch].name();
    }
    else
    {
        b.clump.second() = ghosts_.images()[t.b].id.second();
        b.sphere.second() = t.j;
    }
    return b;
}


void Foam::contactStep::setAnchors
(
    surfaceBond& b,
    const sphereContact& t,
    const scalar gap,
    const vector& n,
    const bondKinetics::molecule& values
) const
{
    // At any distance h from gap to reach between the surfaces, since the area of the
    // rings is proportional to dh. Spheres that are nearer by h - gap meet in this ring
    const label now = mesh_.time().timeIndex();
    const auto chance = [&](const surfaceBonds::chance what)
    {
        return surfaceBonds::uniform(what, values.seed, b, now);
    };
    const scalar r = type(t.a).radii()[t.i];
    const scalar other = t.b < 0 ? GREAT : otherRadius(t);
    const scalar nearer =
        chance(surfaceBonds::distance)*min(values.reach - gap, min(r, other));
    scalar along = r - nearer;
    if (t.b >= 0)
    {
        const scalar d = r + other - nearer;
        along = (sqr(d) + sqr(r) - sqr(other))/(2*d);
    }
    const scalar away = Foam::sqrt(max(sqr(r) - sqr(along), scalar(0)));
    const scalar angle =
        constant::mathematical::twoPi*chance(surfaceBonds::angle);

    const vector e1
    (
        normalised
        (
            n ^ (mag(n.x()) < 0.7 ? vector(1, 0, 0) : vector(0, 1, 0))
        )
    );
    const vector e2(n ^ e1);
    const vector aside(away*(Foam::cos(angle)*e1 + Foam::sin(angle)*e2));

    const vector own(aside - along*n);
    const auto turnedBack = [&](const label index, const label i, const vector& v)
    {
        return conjugate(rotation(orientations_[index][i])).transform(v);
    };
    b.born = now;
    b.anchor = turnedBack(t.a, t.i, own);
    if (t.b < 0)
    {
        b.otherAnchor = aside - (r + gap)*n;
        b.length = mag(b.otherAnchor - own);
        return;
    }
    const vector there(aside + (r + other - nearer - along)*n);
    b.otherAnchor = turnedBack(t.otherIndex, t.j, there);
    b.length = mag(there - (r + other + gap)*n - own);
}


Foam::DynamicList<Foam::surfaceBond> Foam::contactStep::renewedBonds()
{
    const label now = mesh_.time().timeIndex();
    const scalar dt = wholeDt_;
    move(true);

    // The places that are bound, and those whose bond breaks, with its rate
    DynamicList<surfaceBond> result;
    constexpr scalar bound = -1;
    std::map<surfaceBond, scalar> places;
    for (bondEnd& e : bondEnds_)
    {
        if (!e.first)
        {
            continue;
        }
        evaluate(e);
        surfaceBond b(gaps_.bonds()->bonds()[e.number]);
        const scalar offRate = e.kinetics->offRate(e.spring.tension());
        const scalar u = surfaceBonds::uniform
        (
            surfaceBonds::breaking, e.kinetics->values().seed, b, now
        );
        if (u < e.kinetics->toBreak(offRate, dt))
        {
            places[b] = offRate;
            continue;
        }
        places[b] = bound;
        b.length = e.spring.length();
        if (e.b < 0)
        {
            b.otherAnchor += wayOfWall(e) - moved_[e.a][e.i];
        }
        result.append(b);
    }

    // Those that form
    label a = -1;
    std::map<labelPair, label> surfaces;
    for (const sphereContact& t : sphereContacts_)
    {
        if (t.a != a)
        {
            a = t.a;
            surfaces.clear();
        }
        const label surface =
            t.b < 0 && t.reaches ? surfaces[labelPair(t.i, t.patch)]++ : 0;
        const labelPair ids
        (
            clumps_[a].origId(),
            t.b < 0 ? labelMax : ghosts_.images()[t.b].id.second()
        );
        const bool first =
            ids.first() < ids.second()
         || (ids.first() == ids.second() && t.i < t.j);
        if
        (
            !t.reaches || !first || clumps_[a].pieceOf() >= 0
         || (t.b >= 0 && ghosts_.images()[t.b].pieceOf >= 0)
        )
        {
            continue;
        }
        vector n(Zero);
        const scalar gap = -overlap(t, n);
        const scalar R = Foam::sqrt(t.gapR.first*t.gapR.second);
        for (const gapForces::namedKinetics& law : gaps_.kineticsAt(placeOf(t)))
        {
            const bondKinetics& kinetics = *law.second();
            const bondKinetics::molecule& values = kinetics.values();
            if (gap >= values.reach || mag(n) < 0.5)
            {
                continue;
            }
            surfaceBond b(bondAt(t, law.first(), surface));
            const auto chance = [&]
            (
                const surfaceBonds::chance what, const label timeIndex
            )
            {
                return surfaceBonds::uniform(what, values.seed, b, timeIndex);
            };

            // A part of a place is one by chance, the same at all times
            const scalar number =
                t.gapWeight*values.density
               *constant::mathematical::twoPi*R*(values.reach - gap);
            const label nPlaces(number + chance(surfaceBonds::number, 0));
            for (b.place = 0; b.place < nPlaces; ++b.place)
            {
                const auto known = places.find(b);
                if (known != places.end() && known->second == bound)
                {
                    continue;
                }
                setAnchors(b, t, gap, n, values);
                const scalar p =
                    known != places.end()
                  ? kinetics.toFormAnew(known->second, dt)
                  : kinetics.toForm
                    (
                        kinetics.offRate(kinetics.tension(b.length)), dt
                    );
                if (chance(surfaceBonds::forming, now) < p)
                {
                    result.append(b);
                }
            }
        }
    }
    return result;
}
