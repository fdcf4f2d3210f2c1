/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tableRows.H"
#include "testCatch.H"
#include "testCloud.H"
#include "clumpDispersion.H"
#include "clusterMean.H"
#include "lagDispersion.H"
#include "stateList.H"
#include "wallVisits.H"
#include "OSspecific.H"
#include <map>

using namespace Foam;
using functionObjects::clumpDispersion;
using functionObjects::clusterMean;
using functionObjects::lagDispersion;
using functionObjects::wallVisits;

namespace
{

//- A standard normal number, the sum of twelve uniform ones
scalar normal(Random& random)
{
    scalar sum = -6;
    for (label k = 0; k < 12; ++k)
    {
        sum += random.sample01<scalar>();
    }
    return sum;
}


//- Random walks of so many clumps over so many steps of a length of one, in which a walker
//  keeps a part of its last step; D of the long run is 1/2 in each direction
lagDispersion walk
(
    Random& random, const label clumps, const label steps, const scalar lag,
    const scalar memory = 0
)
{
    lagDispersion d(lag);
    std::vector<vector> x(clumps, vector::zero), step(clumps, vector::zero);
    for (label k = 0; k < clumps; ++k)
    {
        d.begin(k, 0, x[k]);
    }
    for (label n = 0; n < steps; ++n)
    {
        for (label k = 0; k < clumps; ++k)
        {
            const vector fresh(normal(random), normal(random), normal(random));
            step[k] = memory*step[k] + (1 - memory)*fresh;
            const vector before(x[k]);
            x[k] += step[k];
            d.follow(k, n, before, n + 1, x[k]);
        }
        d.reach(n + 1);
    }
    return d;
}

}


TEST_CASE("dispersion: the mean of clusters and its error", "[tables][serial]")
{
    // Sizes and sums of ten clusters
    Random random(3);
    clusterMean m;
    scalarList n(10);
    List<vector> S(10);
    scalar sizes = 0;
    vector sum(Zero);
    forAll(n, c)
    {
        if (c < 8)
        {
            CHECK(std::isnan(m.error().x()));
        }
        n[c] = 1 + label(20*random.sample01<scalar>());
        S[c] = 5*vector::one + randomVector(random);
        m.add(n[c], S[c]);
        sizes += n[c];
        sum += S[c];
    }
    const vector mean(sum/sizes);
    for (direction d = 0; d < 3; ++d)
    {
        scalar squares = 0;
        forAll(n, c)
        {
            squares += sqr(S[c][d] - n[c]*mean[d]);
        }
        CHECK(m.mean()[d] == Approx(mean[d]));
        CHECK(m.error()[d] == Approx(std::sqrt(10.0/9*squares)/sizes));
    }

    // Of clusters of the same size: that of the mean of their means
    clusterMean same;
    for (label c = 0; c < 8; ++c)
    {
        same.add(4, 4*c*vector::one);
    }
    CHECK(same.mean().y() == Approx(3.5));
    CHECK(same.error().y() == Approx(std::sqrt(42.0/(8*7))));
}


TEST_CASE("dispersion: constant velocity over irregular steps", "[tables][serial]")
{
    const vector v(2e-3, -1e-4, 5e-2);
    const scalar lag = GENERATE(1e-3, 1.7e-2, 0.25);
    Random random(5);
    lagDispersion d(lag);
    const scalar begun = 0.013;
    scalar t = begun;
    d.begin(7, t, begun*v);
    while (t < 1)
    {
        const scalar next = t + 4e-3*random.sample01<scalar>();
        d.follow(7, t, t*v, next, next*v);
        d.reach(next);
        t = next;
    }
    for (direction k = 0; k < 3; ++k)
    {
        CHECK(d.mean()[k] == Approx(v[k]*lag));
        CHECK(d.msd()[k] == Approx(sqr(v[k]*lag)));
    }
    CHECK(d.nPaths() == 1);

    // Origins at the multiples of an eighth of the lag
    const scalar first = std::ceil(8*begun/lag);
    CHECK(d.n() == Approx(std::floor(8*t/lag) - first - 7).margin(0.1));
}


TEST_CASE("dispersion: displacements that begin between two places", "[tables][serial]")
{
    // Up at 1 m/s, then three times as fast from x = 5 on
    lagDispersion low(0.8, scalarMinMax(0.95, 4.15)), high(0.8, scalarMinMax(5, 100));
    for (lagDispersion* d : {&low, &high})
    {
        d->begin(0, 0, Zero);
        d->follow(0, 0, Zero, 5, vector(5, 0, 1));
        d->follow(0, 5, vector(5, 0, 1), 10, vector(20, 0, 2));
    }
    CHECK(low.msd().x() == Approx(sqr(0.8)));
    CHECK(low.n() == 32);
    CHECK(high.msd().x() == Approx(sqr(2.4)));
    CHECK(high.n() == 100 - 8 - 50 + 1);
}


TEST_CASE("dispersion: what is kept does not grow", "[tables][serial]")
{
    lagDispersion d(1);
    label first = 0;
    for (label n = 0; n < 4000; ++n)
    {
        d.follow(0, 0.1*n, vector(n, 0, 0), 0.1*(n + 1), vector(n + 1, 0, 0));
        d.reach(0.1*(n + 1));
        const dictionary state(d.state());
        const label size =
            state.get<scalarList>("paths").size() + state.get<scalarList>("sums").size();
        if (n == 400)
        {
            first = size;
        }
        CHECK((n <= 400 || size <= first + 10));
    }
    CHECK(first < 100);
}


TEST_CASE("dispersion: random walks within their error bars", "[tables][serial]")
{
    // Many clumps for a short time, a single clump for a long one
    const bool many = GENERATE(true, false);
    const label clumps = many ? 40 : 1;
    const label steps = many ? 320 : 6400;
    const scalar lag = 16;
    const label runs = 200;
    Random random(11);
    label within = 0;
    scalar squares = 0, errors = 0, mean = 0, naive = 0;
    for (label run = 0; run < runs; ++run)
    {
        const lagDispersion d(walk(random, clumps, steps, lag));
        for (direction k = 0; k < 3; ++k)
        {
            const scalar D = d.msd()[k]/(2*lag);
            const scalar error = d.error()[k]/(2*lag);
            within += mag(D - 0.5) < 1.96*error;
            mean += D/(3*runs);
            squares += sqr(D - 0.5)/(3*runs);
            errors += sqr(error)/(3*runs);
        }
        naive += 2*0.25/d.n()/runs;
    }

    // The variance of overlapping displacements from all origins, 4/3 D^2 T/L for each clump
    const scalar expected = 4.0/3*0.25*lag/(clumps*scalar(steps - lag));
    INFO("within " << within/(3.0*runs) << ", error^2 " << errors/squares << ", variance "
        << squares/expected << ", as if independent " << naive/squares);
    CHECK(mean == Approx(0.5).epsilon(0.02));
    CHECK(squares == Approx(expected).epsilon(0.15));
    CHECK(errors/squares > 0.85);
    CHECK(errors/squares < 1.4);
    CHECK(within >= 0.92*3*runs);
    CHECK(within <= 0.99*3*runs);

    // Origins that overlap are not independent
    CHECK(naive < 0.3*squares);
}


TEST_CASE("dispersion: steps with a memory", "[tables][serial]")
{
    // msd = lag + 2 sum (lag - k) c_k, with the correlation c_k = a^k (1 - a)/(1 + a), plus
    // that of a step with itself
    const scalar a = 0.8, lag = 8;
    scalar msd = lag*(1 - a)/(1 + a);
    for (label k = 1; k < lag; ++k)
    {
        msd += 2*(lag - k)*std::pow(a, k)*(1 - a)/(1 + a);
    }
    Random random(2);
    const lagDispersion d(walk(random, 400, 600, lag, a));
    for (direction k = 0; k < 3; ++k)
    {
        // The walkers begin at rest, which they forget over some steps of 600
        CHECK(mag(d.msd()[k] - msd) < 3.5*d.error()[k] + 0.02*msd);
    }
    CHECK(msd < 0.6*lag);
}


TEST_CASE("dispersion: clumps come and go, and a restart continues", "[tables][serial]")
{
    Random random(9);
    const auto x = [](const label id, const scalar t)
    {
        return vector(std::sin(3*t + id), t*t, std::exp(-t)*id);
    };
    lagDispersion whole(0.4), parts(0.4);
    const auto advance = [&](lagDispersion& d, const label from, const label to)
    {
        for (label n = from; n < to; ++n)
        {
            const scalar t0 = 0.03*n, t1 = 0.03*(n + 1);
            for (label id = 0; id < 20; ++id)
            {
                // Clump id is there from step 10 id to step 10 id + 200
                if (n == 10*id)
                {
                    d.begin(id, t0, x(id, t0));
                }
                if (n >= 10*id && n < 10*id + 200)
                {
                    d.follow(id, t0, x(id, t0), t1, x(id, t1));
                }
                if (n == 10*id + 200)
                {
                    d.end(id);
                }
            }
            d.reach(t1);
        }
    };
    advance(whole, 0, 450);
    advance(parts, 0, 333);
    OStringStream os;
    os.precision(6);
    os << parts.state();
    lagDispersion second(parts.state());
    advance(second, 333, 450);
    CHECK(whole.n() == second.n());
    CHECK(whole.nPaths() == 20);
    CHECK(second.nPaths() == 20);
    CHECK(whole.msd() == second.msd());
    CHECK(whole.mean() == second.mean());
    CHECK(whole.error() == second.error());
    CHECK_FALSE(std::isnan(whole.error().x()));
}


TEST_CASE("dispersion: a clump that was away does not jump", "[tables][serial]")
{
    lagDispersion d(1);
    d.begin(0, 0, Zero);
    d.follow(0, 0, Zero, 2, vector(2, 0, 0));
    d.end(0);
    d.begin(0, 10, vector(100, 0, 0));
    d.follow(0, 10, vector(100, 0, 0), 12, vector(102, 0, 0));
    CHECK(d.msd().x() == Approx(1));
    CHECK(d.n() == 18);
    CHECK(d.nPaths() == 2);
}


TEST_CASE("dispersion: visits at a wall", "[tables][serial]")
{
    typedef std::map<label, bool> clumps;
    wallVisits v;
    v.add(clumps{{0, true}, {1, false}, {2, false}}, 0.5);
    CHECK(v.arrivals() == 0);
    v.add(clumps{{0, false}, {1, true}, {2, false}}, 0.5);
    v.add(clumps{{0, false}, {1, true}, {2, true}, {3, true}}, 1);

    // Clump 2 leaves the mesh from the wall
    wallVisits w(v.state());
    for (wallVisits* each : {&v, &w})
    {
        each->add(clumps{{0, true}, {1, true}, {3, false}}, 1);
        CHECK(each->clumps() == 3);
        CHECK(each->atWall() == 2);
        CHECK(each->share() == Approx(2.0/3));
        CHECK(each->arrivals() == 3);
        CHECK(each->departures() == 2);

        // At the wall for 0.5 + 0.5 + 3 + 2 s, of 1.5 + 1.5 + 4 + 3 s
        CHECK(each->timeShare() == Approx(0.6));
        CHECK(each->stay() == Approx(3));
        CHECK(each->flux(0.25) == Approx(1/(0.25*3)));
    }
    wallVisits none;
    CHECK(std::isnan(none.share()));
    CHECK(std::isnan(none.stay()));
}


TEST_CASE("dispersion: clumps that cross periodic faces both ways", "[tables]")
{
    // Two beads without a fluid: along x and back, 0.4 um/step, with a period of 20 um; the
    // second one at 1.5 um from the upper wall, of a radius of 1 um, until it falls
    const scalar dt = testTime().deltaTValue();
    const label index = testTime().timeIndex();
    const dictionary properties
    (
        dictOf
        (
            "types { light { shape { type chain; nSpheres 1; sphereRadius 1e-6; }"
            " density 1000; } heavy { shape { type chain; nSpheres 1;"
            " sphereRadius 1e-6; } density 2000; } }"
            "placement { type list; clumps ("
            "{ type light; position (19e-6 10e-6 5e-6); velocity (0.4 0 0.1); }"
            "{ type heavy; position (1e-6 18.5e-6 15e-6); velocity (-0.4 -0.051 0); }); }"
            "contactModel { type hertz; reducedModulus 1000; restitution 1; }"
            "wallContactModel { type hertz; reducedModulus 1000; restitution 1; }"
            "effects { fluid off; gravity off; }"
        )
    );
    openCloud cloud(testMesh(), properties);
    const fileName folder(testTime().globalPath()/"postProcessing/dispersion");
    const fileName wallFolder(folder + "Walls");
    for (const fileName& old : {folder, wallFolder})
    {
        if (Pstream::master() && isDir(old))
        {
            rmDir(old);
        }
    }
    clumpDispersion object
    (
        "dispersion", testTime(),
        dictOf("lags (8e-6 4e-5); wallDistance 1e-6; types (light heavy);")
    );
    for (label n = 1; n <= 160; ++n)
    {
        testTime().setTime(n*1e-6, index + n);
        testTime().setDeltaT(1e-6, false);
        cloud.evolve();
        cloud.accept();
        cloud.moveParcels();
        object.execute();
    }
    object.write();
    testTime().setTime(0, index);
    testTime().setDeltaT(dt, false);
    if (!Pstream::master())
    {
        return;
    }

    const fileName start(readDir(folder, fileName::DIRECTORY)[0]);
    const auto rows(rowsOf(folder/start/"clumpDispersion.dat"));
    REQUIRE(rows.size() == 4);
    for (auto row : rows)
    {
        const auto value = [&row](const char* name) { return std::stod(row[name]); };
        const scalar lag = value("lag");
        const bool light = row["type"] == "light";
        CHECK(value("clumps") == 1);
        CHECK(value("meanFlow") == Approx((light ? 0.4 : -0.4)*lag).epsilon(1e-4));
        CHECK(value("msdFlow") == Approx(sqr(0.4*lag)).epsilon(1e-4));
        CHECK(value("msdGradient") == Approx(sqr(light ? 0 : 0.051*lag)).epsilon(1e-4));
        CHECK(value("msdVorticity") == Approx(sqr(light ? 0.1*lag : 0)).epsilon(1e-4));
        CHECK(value("DGradient") == Approx(value("msdGradient")/(2*lag)).epsilon(1e-4));
        CHECK(std::isnan(value("errorGradient")));

        // Places after each step, and after every fifth one
        CHECK(value("n") == (lag < 1e-5 ? 152 : 24));
    }

    // Its surface leaves the layer of 1 um in step 10
    const auto walls(rowsOf(wallFolder/start/"clumpDispersionWalls.dat"));
    REQUIRE(walls.size() == 2);
    for (auto row : walls)
    {
        const bool light = row["type"] == "light";
        CHECK(row["atWall"] == "0");
        CHECK(std::stod(row["arrivals"]) == 0);
        CHECK(std::stod(row["departures"]) == (light ? 0 : 1));
        CHECK(std::stod(row["timeShare"]) == Approx(light ? 0 : 9.0/160).margin(1e-6));
        if (!light)
        {
            CHECK(std::stod(row["stay"]) == Approx(9e-6).epsilon(1e-4));
            CHECK(std::stod(row["flux"]) == Approx(-1/(2*4e-10*160e-6)).epsilon(1e-4));
        }
    }
}


TEST_CASE("dispersion: entries that do not fit are refused", "[tables]")
{
    testCloud t(point(10e-6, 10e-6, 10e-6), Zero, Zero, "wholeClump", false);
    const auto make = [](const std::string& entries)
    {
        clumpDispersion("dispersion", testTime(), dictOf(entries));
    };
    CHECK_NOTHROW(make("lags (1e-3); types (cell);"));
    CHECK_THROWS(make("lags (1e-3); types (sphere);"));
    CHECK_THROWS(make("lags (1e-3); types ();"));
    CHECK_THROWS(make("lags (1e-3 0);"));
    CHECK_THROWS(make("lags ();"));
    CHECK_THROWS(make("lags (1e-3); between (1 0);"));
    CHECK_THROWS(make("lags (1e-3); between (1 2 3);"));
    CHECK_THROWS(make("lags (1e-3); wallPatches (top);"));
    CHECK_THROWS(make("lags (1e-3); wallDistance 1e-6; wallPatches (none);"));
    CHECK_THROWS(make("lags (1e-3); wallDistance -1e-6;"));
}
