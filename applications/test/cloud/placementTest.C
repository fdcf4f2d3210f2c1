/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "clumpTotals.H"
#include "foamCompat.H"
#include "placement.H"
#include "randomSeed.H"
#include "sizeClasses.H"
#include <cstdlib>

using namespace Foam;

namespace
{

//- Rings with the size of the cells of the paper, as numbers of a type
dictionary ringDict(const label n, const scalar R, const scalar r)
{
    dictionary dict(cellDict());
    dictionary& shape = dict.subDict("shape");
    shape.set("nSpheres", n);
    shape.set("ringRadius", R);
    shape.set("sphereRadius", r);
    return dict;
}


//- The clumps that a placement makes in the test box, on all processors
struct placedClumps
{
    PtrList<clumpType> types;
    HashTable<label> typeIds;
    List<label> typeOf;
    List<label> ids;
    List<pointField> centres;

    explicit placedClumps(const string& text)
    {
        // A red cell of 94 um3, a smaller ring, and a sphere
        dictionary all;
        all.set("healthy", ringDict(10, 2.434e-6, 1.476e-6));
        all.set("small", ringDict(8, 1e-6, 0.7e-6));
        const dictionary sphere
        (
            dictOf
            (
                "shape { type chain; nSpheres 1; sphereRadius 1e-6; } density 1098;"
            )
        );
        dictionary ball(sphere);
        ball.set("nominalVolume", 8e-18);
        all.set("ball", ball);

        // Spheres of eight sizes, and of two
        dictionary grain(sphere);
        grain.set
        (
            "sizes", dictOf("distribution lognormal; mean 0.5e-6; deviation 0.25e-6;")
        );
        all.set("grain", grain);
        dictionary mixed(sphere);
        mixed.set
        (
            "sizes",
            dictOf("distribution list; radii (0.2e-6 4e-6); fractions (0.99 0.01);")
        );
        all.set("mixed", mixed);

        const dictionary expanded(sizeClasses::expanded(all));
        for (const word& name : expanded.toc())
        {
            typeIds.insert(name, types.size());
            types.append(new clumpType(name, expanded.subDict(name)));
        }

        Cloud<clumpParcel> cloud(testMesh(), "placed", IDLList<clumpParcel>());
        labelHashSet followFlow;
        selectModel<placement>(dictOf(text), types, typeIds)->place
        (
            testMesh(), cloud, followFlow
        );
        CHECK(followFlow.size() == cloud.size());
        gather(cloud);
    }

    void gather(const Cloud<clumpParcel>& cloud)
    {
        List<labelList> t(Pstream::nProcs()), k(Pstream::nProcs());
        List<List<pointField>> x(Pstream::nProcs());
        const label me = Pstream::myProcNo();
        for (const clumpParcel& p : cloud)
        {
            t[me].append(p.typeId());
            k[me].append(p.origId());
            x[me].append(p.centres());
        }
        gatherToAll(t);
        gatherToAll(k);
        gatherToAll(x);
        forAll(t, proci)
        {
            typeOf.append(t[proci]);
            ids.append(k[proci]);
            centres.append(x[proci]);
        }
    }

    label number(const label typeId) const
    {
        label n = 0;
        for (const label t : typeOf)
        {
            n += t == typeId;
        }
        return n;
    }

    //- Least gap [m] between spheres of different clumps, x and z periodic
    scalar leastGap() const
    {
        scalar gap = GREAT;
        forAll(centres, a)
        {
            for (label b = a + 1; b < centres.size(); ++b)
            {
                forAll(centres[a], i)
                {
                    forAll(centres[b], j)
                    {
                        vector d(centres[a][i] - centres[b][j]);
                        d.x() -= 2e-5*std::round(d.x()/2e-5);
                        d.z() -= 2e-5*std::round(d.z()/2e-5);
                        gap = min
                        (
                            gap,
                            mag(d) - types[typeOf[a]].radii()[i]
                          - types[typeOf[b]].radii()[j]
                        );
                    }
                }
            }
        }
        return gap;
    }

    //- Box of the surfaces of all clumps
    boundBox box() const
    {
        boundBox result(boundBox::invertedBox);
        forAll(centres, a)
        {
            forAll(centres[a], i)
            {
                const scalar r = types[typeOf[a]].radii()[i];
                result.add(centres[a][i] - r*vector::one);
                result.add(centres[a][i] + r*vector::one);
            }
        }
        return result;
    }
};

const scalar V = 8e-15;

}


TEST_CASE("placement: dense packing has no overlaps", "[placement]")
{
    for (const char* seed : {"1", "2", "3"})
    {
        const placedClumps packed
        (
            string("type random; clumpType healthy; haematocrit 0.45; seed ")
          + seed + ";"
        );
        const label n = packed.centres.size();
        CHECK(n == label(std::round(0.45*V/packed.types[0].volume())));
        CHECK(packed.leastGap() >= -1e-15);
        CHECK(packed.box().min().y() >= -1e-15);
        CHECK(packed.box().max().y() <= 2e-5 + 1e-15);

        // Every number once
        labelHashSet ids(packed.ids);
        CHECK(ids.size() == n);
        CHECK(max(packed.ids) == n - 1);
    }
}


TEST_CASE("placement: several types", "[placement]")
{
    SECTION("numbers")
    {
        const placedClumps packed
        (
            "type random; numbers { healthy 10; small 30; ball 20; } seed 4;"
            "minGap 0.1e-6;"
        );
        CHECK(packed.number(0) == 10);
        CHECK(packed.number(1) == 30);
        CHECK(packed.number(2) == 20);
        CHECK(packed.leastGap() >= 0.1e-6*(1 - 1e-6));
        CHECK(packed.box().min().y() >= 0.1e-6*(1 - 1e-6));
    }
    SECTION("fractions of the number, a volume fraction of the unions")
    {
        const placedClumps packed
        (
            "type random; fractions { healthy 0.5; small 0.3; ball 0.2; }"
            "volumeFraction 0.3; seed 4;"
        );
        const label n = packed.typeOf.size();
        scalar volume = 0;
        forAll(packed.types, i)
        {
            volume += packed.number(i)*packed.types[i].volume();
        }
        CHECK(volume == Approx(0.3*V).epsilon(0.03));
        CHECK(mag(packed.number(0) - 0.5*n) <= 1);
        CHECK(mag(packed.number(1) - 0.3*n) <= 1);
        CHECK(mag(packed.number(2) - 0.2*n) <= 1);
        CHECK(packed.leastGap() >= -1e-15);
    }
    SECTION("the haematocrit counts the nominal volume")
    {
        const placedClumps packed
        (
            "type random; clumpType ball; haematocrit 0.1; seed 4;"
        );
        CHECK(packed.number(2) == 100);

        labelList numbers(packed.types.size(), Zero);
        numbers[2] = 100;
        const Pair<scalar> f(volumeFractions(packed.types, numbers, V));
        CHECK(f.first() == Approx(0.1));
        CHECK(f.second() == Approx(100*4.18879e-18/V).epsilon(1e-3));
    }
}


TEST_CASE("placement: sizes of a lognormal distribution", "[placement]")
{
    const placedClumps packed
    (
        "type random; clumpType grain; volumeFraction 0.1; seed 5;"
    );
    const label n = packed.typeOf.size();
    scalar cubes = 0, fourths = 0;
    forAll(packed.types, i)
    {
        const clumpType& type = packed.types[i];
        const scalar fraction = type.family() == "grain" ? type.share() : 0;
        CHECK(mag(packed.number(i) - fraction*n) <= 1);
        cubes += packed.number(i)*pow3(type.radii()[0]);
        fourths += packed.number(i)*pow4(type.radii()[0]);
    }
    // The volume, and the mean radius by volume: m (1 + (d/m)^2)^3
    CHECK(4.18879*cubes == Approx(0.1*V).epsilon(0.02));
    CHECK(fourths/cubes == Approx(0.5e-6*pow3(1.25)).epsilon(0.03));
    CHECK(packed.leastGap() >= -1e-15);
}


TEST_CASE("placement: spheres of sizes 1 to 20 without overlaps", "[placement]")
{
    const placedClumps packed
    (
        "type random; numbers { mixed 400; ball 10; } seed 5; minGap 0.02e-6;"
    );
    const label first = packed.typeIds["mixed_1"];
    CHECK(packed.number(first) == 396);
    CHECK(packed.number(first + 1) == 4);
    CHECK(packed.number(packed.typeIds["ball"]) == 10);
    CHECK(packed.leastGap() >= 0.02e-6*(1 - 1e-6));
    CHECK(packed.box().min().y() >= 0.02e-6*(1 - 1e-6));
}


TEST_CASE("placement: a lattice mixes sizes evenly", "[placement]")
{
    const placedClumps placed
    (
        "type lattice; clumpType grain; origin (1e-6 2e-6 1e-6);"
        "spacing (3e-6 3e-6 3e-6); number (6 6 6);"
    );
    REQUIRE(placed.typeOf.size() == 216);
    forAll(placed.types, i)
    {
        const clumpType& type = placed.types[i];
        const scalar fraction = type.family() == "grain" ? type.share() : 0;
        CHECK(mag(placed.number(i) - fraction*216) <= 3);
    }
}


TEST_CASE("placement: the seed decides", "[placement]")
{
    const auto first = [](const char* seed)
    {
        return placedClumps
        (
            string("type random; clumpType healthy; haematocrit 0.2; seed ")
          + seed + ";"
        ).centres[0][0];
    };
    const point one(first("1"));
    CHECK(first("1") == one);
    CHECK(first("2") != one);
}


TEST_CASE("placement: seeds are those of labels of any size", "[placement][serial]")
{
    // The numbers of POSIX, two for a number in [0, 1)
    for (const label seed : {1, 7, 2147483646})
    {
        Random random(seed);
        srand48(seed);
        for (label k = 0; k < 100; ++k)
        {
            const double low = lrand48();
            const double high = lrand48();
            const double sample = (low + 2147483648.0*high)/4611686018427387904.0;
            CHECK(randomSeed(random) == label(int64_t(2147483647.0*sample)));
        }
    }

    // Three numbers of 32 bits, lowest byte first
    const unsigned char bytes[] = {5, 0, 0, 0, 1, 0, 0, 0, 0x39, 0x30, 0, 0};
    const word name("inlet");
    const unsigned hash = Hasher(bytes, 12, Hasher(name.c_str(), name.size()));
    CHECK(randomSeed(name, 5, 1, 12345) == label(hash & 0x7fffffff));
}


TEST_CASE("placement: a box within the mesh, and one orientation", "[placement]")
{
    const placedClumps packed
    (
        "type random; numbers { healthy 5; } seed 1; axis (1 0 0); angle 90;"
        "min (0 3e-6 2e-6); max (2e-5 17e-6 12e-6);"
    );
    const boundBox box(packed.box());
    CHECK(box.min().y() >= 3e-6 - 1e-15);
    CHECK(box.max().y() <= 17e-6 + 1e-15);
    CHECK(box.min().z() >= 2e-6 - 1e-15);
    CHECK(box.max().z() <= 12e-6 + 1e-15);
    CHECK(packed.leastGap() >= -1e-15);

    // The axis of a ring, z, is turned to -y
    for (const pointField& x : packed.centres)
    {
        for (const point& p : x)
        {
            CHECK(p.y() == Approx(x[0].y()));
        }
    }
}


TEST_CASE("placement: lattice", "[placement]")
{
    const placedClumps lattice
    (
        "type lattice; clumpType ball; origin (2e-6 3e-6 4e-6);"
        "spacing (4e-6 5e-6 6e-6); number (4 3 2);"
    );
    CHECK(lattice.centres.size() == 24);
    forAll(lattice.ids, k)
    {
        if (lattice.ids[k] == 23)
        {
            CHECK(mag(lattice.centres[k][0] - point(14e-6, 13e-6, 10e-6)) < 1e-12);
        }
    }
}


TEST_CASE("placement: what cannot be", "[placement]")
{
    for
    (
        const char* wrong :
        {
            "clumpType healthy; haematocrit 0.8;",
            "clumpType healthy; haematocrit 1.2;",
            "clumpType healthy; haematocrit 1e-6;",
            "clumpType unknown; haematocrit 0.1;",
            "clumpType healthy;",
            "clumpType healthy; haematocrit 0.1; volumeFraction 0.1;",
            "fractions { healthy 0.5; small 0.4; } haematocrit 0.1;",
            "numbers { healthy 0; }",
            "numbers { healthy 3; } cellZone none;",
            "numbers { healthy 3; } min (0 2e-5 0); max (1e-5 1e-5 1e-5);"
        }
    )
    {
        INFO(wrong);
        CHECK_THROWS
        (
            placedClumps(string("type random; seed 1; ") + wrong)
        );
    }
    CHECK_THROWS(placedClumps("type rondom;"));
    CHECK_THROWS(placedClumps("type random; numbers { healthy 3; }"));
}
