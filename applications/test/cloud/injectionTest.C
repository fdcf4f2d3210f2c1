/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "openBox.H"
#include "injection.H"
#include "patchLines.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

//- A box with open patches, an empty cloud and an injection
struct device
{
    autoPtr<polyMesh> mesh;
    PtrList<clumpType> types;
    HashTable<label> typeIds;
    autoPtr<ghostExchange> ghosts;
    autoPtr<Cloud<clumpParcel>> clumps;
    autoPtr<injection> source;

    explicit device
    (
        const string& text,
        const std::function<point(const point&)>& moved =
            [](const point& p) { return p; }
    )
    :
        mesh(openBox(moved)),
        types(2)
    {
        types.set(0, new clumpType("healthy", cellDict()));
        dictionary ball(cellDict());
        ball.set
        (
            "shape", dictOf("type chain; nSpheres 1; spacing 1e-6; sphereRadius 1e-6;")
        );
        types.set(1, new clumpType("ball", ball));
        typeIds.insert("healthy", 0);
        typeIds.insert("ball", 1);
        ghosts.reset(new ghostExchange(*mesh));
        clumps.reset
        (
            new Cloud<clumpParcel>(*mesh, "device", IDLList<clumpParcel>())
        );
        source = newSource(text);
    }

    autoPtr<injection> newSource(const string& text) const
    {
        dictionary dict(dictOf(text));
        dict.name() = "test:source";
        return selectModel<injection>
        (
            dict, injection::site{*mesh, *ghosts, types, typeIds, false}
        );
    }

    //- Put a clump where its centre is
    void add(const label typeId, const point& position, const label number)
    {
        const label celli = mesh->findCell(position);
        if (celli >= 0 && Pstream::master())
        {
            newClump c(types[typeId], typeId, position);
            c.setVelocity(types[typeId], vector(0.1, 0, 0));
            c.enter(*clumps, celli, number);
        }
    }

    //- Inject what is due in a step, or in one with these passages; returns the number
    label step() { return step(clumpCount(*mesh, types, "device")); }

    label step(const clumpCount& count)
    {
        const label before = source->nInjected();
        source->inject
        (
            *clumps,
            count,
            [&](const clumpCandidate& c, const label owner)
            {
                if (owner == Pstream::myProcNo())
                {
                    c.enter
                    (
                        *clumps, mesh->findCell(c.position), source->nInjected()
                    );
                }
                return source->nInjected();
            }
        );
        return source->nInjected() - before;
    }

    label size() const
    {
        return returnReduce(clumps->size(), sumOp<label>());
    }

    //- Least distance of surfaces over all pairs of clumps [m]
    scalar leastGap() const
    {
        scalar gap = GREAT;
        for (const clumpParcel& a : *clumps)
        {
            for (const clumpParcel& b : *clumps)
            {
                if (a.origId() < b.origId())
                {
                    for (const point& x : a.centres())
                    {
                        gap = min(gap, gapTo(x, types[a.typeId()].radii()[0], b));
                    }
                }
            }
        }
        return returnReduce(gap, minOp<scalar>());
    }

    scalar gapTo(const point& x, const scalar r, const clumpParcel& b) const
    {
        return
            min(mag(b.centres() - x) - types[b.typeId()].radii()) - r;
    }

    //- Centre of mass of the clump that was added last
    point lastCentre() const
    {
        const clumpParcel& p = *clumps->last();
        return p.centre(types[p.typeId()]);
    }
};

string rateOf(const scalar perStep, const string& others)
{
    return
        "type rate; patches (inlet); seed 3; velocity (1e-3 0 0); rate "
      + Foam::name(perStep/testTime().deltaTValue()) + "; " + others;
}

}


TEST_CASE("injection: random lines hit a patch uniformly", "[injection]")
{
    const autoPtr<polyMesh> mesh(openBox());
    const patchLines lines
    (
        *mesh, labelHashSet({mesh->boundaryMesh().findPatchID("inlet")})
    );
    const label n = 20000;
    Random random(5);

    // Cauchy and Crofton: area over twice that of the disc of the sphere around it
    label nHits = 0;
    vector mean(Zero);
    List<patchLines::hit> hits
    (
        lines.shoot(n, random, [](const label) { return 1; })
    );
    patchLines::combine(hits);
    for (const patchLines::hit& h : hits)
    {
        if (h.place < GREAT)
        {
            ++nHits;
            mean += h.x;
            CHECK(mag(h.inwards - vector(1, 0, 0)) < 1e-9);
        }
    }
    const scalar expected = 400.0/(constant::mathematical::twoPi*200);
    CHECK(scalar(nHits)/n == Approx(expected).epsilon(0.04));
    CHECK(mag(mean/nHits - point(0, 10e-6, 10e-6)) < 0.2e-6);

    // In proportion to the chance, which grows with y: the mean is at two thirds
    nHits = 0;
    mean = Zero;
    const auto chance = [&](const label facei)
    {
        return mesh->faceCentres()[facei].y()/20e-6;
    };
    hits = lines.shoot(n, random, chance);
    patchLines::combine(hits);
    for (const patchLines::hit& h : hits)
    {
        if (h.place < GREAT)
        {
            ++nHits;
            mean += h.x;
        }
    }
    CHECK(scalar(nHits)/n == Approx(0.5*expected).epsilon(0.06));
    CHECK(mean.y()/nHits == Approx(20e-6*2/3).epsilon(0.02));
}


TEST_CASE("injection: clumps touch the inlet and nothing else", "[injection]")
{
    device d(rateOf(2, "fractions { healthy 0.5; ball 0.5; }"));
    for (label k = 0; k < 30; ++k)
    {
        d.step();
    }

    // Not all 60 fit; the others wait
    const label n = d.source->nInjected();
    CHECK(n > 5);
    CHECK(n < 60);
    CHECK(d.source->nWaiting() == 60 - n);
    CHECK(d.size() == n);
    CHECK(d.leastGap() >= 0);

    label nBalls = 0;
    for (const clumpParcel& p : *d.clumps)
    {
        const scalarField& r = d.types[p.typeId()].radii();
        const pointField x(p.centres());
        nBalls += p.typeId();
        CHECK(mag(min(x.component(0) - r)) < 1e-6*r[0]);
        CHECK(max(x.component(0) + r) < 20e-6);
        for (const direction cmpt : {1, 2})
        {
            CHECK(min(x.component(cmpt) - r) > -1e-6*r[0]);
            CHECK(max(x.component(cmpt) + r) < 20e-6 + 1e-6*r[0]);
        }
        CHECK(mag(p.state().u[0] - vector(1e-3, 0, 0)) < 1e-15);
    }
    nBalls = returnReduce(nBalls, sumOp<label>());
    CHECK(nBalls > 0);
    CHECK(nBalls < n);
}


TEST_CASE("injection: clumps touch a curved inlet", "[injection]")
{
    // Bulged outwards like a dome, 4 um high
    const auto dome = [](const point& p)
    {
        const scalar y = p.y()/10e-6 - 1;
        const scalar z = p.z()/10e-6 - 1;
        const scalar bulge = 4e-6*(1 - 0.5*(sqr(y) + sqr(z)));
        return point(p.x() - bulge*(1 - p.x()/20e-6), p.y(), p.z());
    };
    device d(rateOf(1, "clumpType healthy; nTries 200;"), dome);
    for (label k = 0; k < 10 && d.size() < 2; ++k)
    {
        d.step();
    }
    REQUIRE(d.size() >= 1);

    const polyPatch& inlet = d.mesh->boundaryMesh()["inlet"];
    for (const clumpParcel& p : *d.clumps)
    {
        const scalarField& r = d.types[p.typeId()].radii();
        const pointField x(p.centres());
        scalar gap = GREAT;
        for (const face& f : inlet)
        {
            forAll(x, i)
            {
                gap = min
                (
                    gap,
                    f.nearestPoint(x[i], d.mesh->points()).distance() - r[i]
                );
            }
        }
        CHECK(mag(gap) < 1e-3*r[0]);
    }
}


TEST_CASE("injection: a restart goes on as the whole run", "[injection]")
{
    const string text(rateOf(0.7, "fractions { healthy 0.4; ball 0.6; }"));
    device whole(text), parts(text);
    for (label k = 0; k < 12; ++k)
    {
        whole.step();
        parts.step();

        dictionary state;
        parts.source->writeState(state);
        parts.source = parts.newSource(text);
        parts.source->readState(state);
    }
    REQUIRE(whole.size() > 3);
    REQUIRE(whole.size() == parts.size());
    auto other = parts.clumps->cbegin();
    for (const clumpParcel& p : *whole.clumps)
    {
        const clumpParcel& q = *other;
        CHECK(p.typeId() == q.typeId());
        CHECK(p.position() == q.position());
        CHECK(p.state().x == q.state().x);
        ++other;
    }

    // Other seeds give other clumps
    device third(rateOf(0.7, "clumpType ball;").replace("seed 3", "seed 4"));
    device fourth(rateOf(0.7, "clumpType ball;"));
    for (label k = 0; k < 2; ++k)
    {
        third.step();
        fourth.step();
    }
    REQUIRE(third.size() == 1);
    REQUIRE(fourth.size() == 1);
    if (third.clumps->size())
    {
        CHECK
        (
            third.clumps->first()->position() != fourth.clumps->first()->position()
        );
    }
}


TEST_CASE("injection: several at once are those of one after the other", "[injection]")
{
    // A new source tries one clump first, one that has put in some tries more at once
    const string text(rateOf(6, "fractions { healthy 0.2; ball 0.8; } nTries 20;"));
    device several(text), single(text);
    label most = 0;
    for (label k = 0; k < 4; ++k)
    {
        const label before = several.size();
        several.step();
        single.step();
        most = max(most, several.size() - before);

        dictionary state;
        single.source->writeState(state);
        single.source = single.newSource(text);
        single.source->readState(state);
    }
    CHECK(most > 1);
    CHECK(several.source->nWaiting() > 0);
    CHECK(several.leastGap() >= 0);
    REQUIRE(several.size() == single.size());
    auto other = single.clumps->cbegin();
    for (const clumpParcel& p : *several.clumps)
    {
        CHECK(p.typeId() == (*other).typeId());
        CHECK(p.position() == (*other).position());
        CHECK(p.state().x == (*other).state().x);
        ++other;
    }
}


TEST_CASE("injection: wrong entries are refused", "[injection]")
{
    CHECK_THROWS(device(rateOf(1, "clumpType bull;")));
    CHECK_THROWS(device(rateOf(1, "clumpType ball;").replace("velocity", "speed")));
    CHECK_THROWS(device(rateOf(1, "clumpType ball;").replace("inlet", "walls")));
}


TEST_CASE("injection: a stretch repeats itself", "[injection]")
{
    const string text("type preInlet; patches (inlet); length 8e-6;");
    device d(text);
    CHECK_THROWS(d.source->begin(*d.clumps));

    // A ball of 1 um in the stretch, and one that lies across its end
    d.add(1, point(3e-6, 10e-6, 10e-6), 5);
    d.add(1, point(8e-6, 5e-6, 10e-6), 6);
    d.source->begin(*d.clumps);
    CHECK(d.step() == 0);

    // Across the end, and behind it
    d.clumps->clear();
    d.add(1, point(8.9e-6, 9e-6, 11e-6), 5);
    CHECK(d.step() == 0);
    d.clumps->clear();
    d.add(1, point(9.1e-6, 9e-6, 11e-6), 5);
    d.add(1, point(12e-6, 5e-6, 10e-6), 6);
    CHECK(d.step() == 1);
    REQUIRE(d.size() == 3);
    if (d.clumps->size())
    {
        CHECK
        (
            mag(d.lastCentre() - point(1.1e-6, 9e-6, 11e-6)) < 1e-15
        );
    }
    const label copy = d.source->nInjected();

    // The original only once; now the copy belongs to the stretch, also after a
    // restart
    CHECK(d.step() == 0);
    dictionary state;
    d.source->writeState(state);
    d.source = d.newSource(text);
    d.source->readState(state);
    d.clumps->clear();
    d.add(1, point(10e-6, 5e-6, 5e-6), copy);
    d.add(1, point(2.5e-6, 5e-6, 5e-6), 99);
    CHECK(d.step() == 0);
    CHECK(d.source->nWaiting() == 1);
    d.clumps->clear();
    d.add(1, point(11e-6, 5e-6, 5e-6), copy);
    CHECK(d.step() == 1);
    CHECK(d.source->nWaiting() == 0);

    // It waited: it touches the inlet
    if (d.clumps->size())
    {
        CHECK
        (
            mag(d.lastCentre() - point(1e-6, 5e-6, 5e-6)) < 1e-15
        );
    }
}


TEST_CASE("injection: what enters again has the shape that it left with", "[injection]")
{
    const string text
    (
        "type recirculation; from (outlet); patches (inlet); seed 1; velocity (1e-3 0 0);"
        " weighting uniform;"
    );
    device d(text + " minGap 30e-6;");
    const clumpType& type = d.types[0];
    const label outlet = d.mesh->boundaryMesh().findPatchID("outlet");

    // One that is stretched and turned and has lost a bond, and one by another patch
    clumpState left(type, quaternion(vector(1, 2, 3)/Foam::sqrt(14.0), 0.7));
    for (point& x : left.x)
    {
        x.z() *= 1.2;
    }
    left.broken = scalarField(type.pairs().size(), Zero);
    left.broken[1] = 1;
    d.add(0, point(18e-6, 10e-6, 10e-6), 7);
    d.add(1, point(10e-6, 18e-6, 10e-6), 8);
    clumpCount count(*d.mesh, d.types, "device");
    for (clumpParcel& p : *d.clumps)
    {
        if (p.origId() == 7)
        {
            p.state() = left;
        }
        count.leave(p, outlet - (p.origId() == 8));
    }

    // There is no room, and the run is stopped and continued
    d.clumps->clear();
    d.add(1, point(10e-6, 10e-6, 10e-6), 9);
    CHECK(d.step(count) == 0);
    CHECK(d.source->nWaiting() == 1);
    dictionary state;
    d.source->writeState(state);
    d.source = d.newSource(text);
    d.source->readState(state);
    d.clumps->clear();
    REQUIRE(d.step() == 1);
    CHECK(d.source->nWaiting() == 0);

    for (const clumpParcel& p : *d.clumps)
    {
        REQUIRE(p.typeId() == 0);
        const clumpState& s = p.state();
        CHECK(s.broken == left.broken);
        CHECK(mag(s.centre(type)) < 1e-15);
        const vector arm(left.x[0] - left.centre(type));
        for (label i = 0; i < s.x.size(); ++i)
        {
            const scalar distance = mag(left.x[i] - left.x[0]);
            CHECK(std::abs(mag(s.x[i] - s.x[0]) - distance) < 1e-17);

            // In the spheres' own frames, too
            const vector was(conjugate(left.q[i]).transform(arm));
            const vector now(s.x[0] - s.centre(type));
            const vector is(conjugate(s.q[i]).transform(now));
            CHECK(mag(is - was) < 1e-17);
        }
    }
}
