/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "sphereGrid.H"
#include "contactModel.H"
#include "mathematicalConstants.H"
#include <array>
#include <chrono>
#include <set>
#include <utility>

using namespace Foam;

TEST_CASE("contact: the grid finds what all pairs find", "[contact][serial]")
{
    PtrList<clumpType> types(1);
    types.set(0, new clumpType("cell", cellDict()));
    const clumpType& type = types[0];
    Random random(15);

    DynamicList<clumpImage> images;
    for (label a = 0; a < 12; ++a)
    {
        const clumpState s(type, randomRotation(random));
        clumpImage image;
        image.typeId = 0;
        image.x = s.x + 8e-6*randomVector(random);
        image.u = s.u;
        image.box = boundBox();
        forAll(image.x, i)
        {
            image.box.add(image.x[i] - type.radii()[i]*vector::one);
            image.box.add(image.x[i] + type.radii()[i]*vector::one);
        }
        images.append(image);
    }

    const label nOwn = 8;
    std::set<std::array<label, 4>> found, expected;
    sphereGrid::forEachContact
    (
        images, nOwn, types,
        [&](label a, label i, label b, label j)
        {
            const std::array<label, 4> pair{{a, i, b, j}};
            CHECK(found.insert(pair).second);
        }
    );

    for (label a = 0; a < nOwn; ++a)
    {
        forAll(images[a].x, i)
        {
            forAll(images, b)
            {
                forAll(images[b].x, j)
                {
                    // Spheres of one clump never touch each other
                    if
                    (
                        a != b
                     && mag(images[a].x[i] - images[b].x[j])
                      < type.radii()[i] + type.radii()[j]
                    )
                    {
                        expected.insert({{a, i, b, j}});
                    }
                }
            }
        }
    }

    CHECK(!expected.empty());
    CHECK(found == expected);
}


TEST_CASE("contact: the grid finds boxes of sizes 1 to 20", "[contact][serial]")
{
    PtrList<clumpType> types(2);
    forAll(types, i)
    {
        dictionary dict
        (
            dictOf("shape { type chain; nSpheres 1; sphereRadius 1; } density 1;")
        );
        dict.set("scale", i ? 5e-6 : 0.25e-6);
        types.set(i, new clumpType(i ? "large" : "small", dict));
    }
    Random random(17);
    DynamicList<clumpImage> images;
    for (label a = 0; a < 600; ++a)
    {
        clumpImage image;
        image.typeId = a % 50 ? 0 : 1;
        const clumpType& type = types[image.typeId];
        image.x = pointField(1, point(2e-5*randomVector(random)));
        const vector half(type.radii()[0]*vector::one);
        image.box = boundBox(image.x[0] - half, image.x[0] + half);
        images.append(image);
    }

    const label nOwn = 400;
    std::set<std::pair<label, label>> found, expected;
    label last = -1;
    bool ascending = true;
    sphereGrid::forEachNear
    (
        images, nOwn, scalarField(nOwn, 0.1e-6),
        [&](label a, label b)
        {
            const std::pair<label, label> pair(a, b);
            CHECK(found.insert(pair).second);
            ascending = ascending && (a*images.size() + b > last);
            last = a*images.size() + b;
        }
    );
    label ofBothSizes = 0;
    for (label a = 0; a < nOwn; ++a)
    {
        boundBox box(images[a].box);
        box.min() -= 0.1e-6*vector::one;
        box.max() += 0.1e-6*vector::one;
        forAll(images, b)
        {
            if (a != b && box.overlaps(images[b].box))
            {
                expected.insert(std::make_pair(a, b));
                ofBothSizes += images[a].typeId != images[b].typeId;
            }
        }
    }
    CHECK(ofBothSizes > 10);
    CHECK(ascending);
    CHECK(found == expected);
}


TEST_CASE("contact: time of the grid", "[.][contact][serial]")
{
    // Clumps on a cubic lattice, at the same distances for any number
    PtrList<clumpType> types(1);
    types.set(0, new clumpType("cell", cellDict()));
    const clumpType& type = types[0];
    Random random(16);

    for (const label side : {5, 10, 16})
    {
        DynamicList<clumpImage> images;
        for (label a = 0; a < side*side*side; ++a)
        {
            const clumpState s(type, randomRotation(random));
            const vector place(a % side, (a/side) % side, a/(side*side));
            clumpImage image;
            image.typeId = 0;
            image.x = s.x + 7.5e-6*place;
            image.box = boundBox();
            forAll(image.x, i)
            {
                image.box.add(image.x[i] - type.radii()[i]*vector::one);
                image.box.add(image.x[i] + type.radii()[i]*vector::one);
            }
            images.append(image);
        }

        label near = 0, pairs = 0, allPairs = 0;
        const auto start = std::chrono::steady_clock::now();
        sphereGrid::forEachNear
        (
            images, images.size(), scalarField(images.size(), Zero),
            [&](label, label) { ++near; }
        );
        const auto boxes = std::chrono::steady_clock::now();
        sphereGrid::forEachContact
        (
            images, images.size(), types,
            [&](label, label, label, label) { ++pairs; }
        );
        const auto spheres = std::chrono::steady_clock::now();
        forAll(images, a)
        {
            forAll(images, b)
            {
                allPairs += a != b && images[a].box.overlaps(images[b].box);
            }
        }
        const auto end = std::chrono::steady_clock::now();
        CHECK(near == allPairs);

        const auto ms = [](const std::chrono::steady_clock::duration& d)
        {
            return 1e3*std::chrono::duration<double>(d).count();
        };
        Info<< images.size() << " clumps, " << pairs << " pairs: near "
            << ms(boxes - start) << " ms (all pairs of boxes "
            << ms(end - spheres) << " ms), contacts "
            << ms(spheres - boxes) << " ms" << endl;
    }
}


TEST_CASE("contact: Hertz's law", "[contact][serial]")
{
    const auto model
    (
        selectModel<contactModel>
        (
            dictOf("type hertz; reducedModulus 1000; restitution 1;")
        )
    );
    const scalar r = 2e-6, m = 1e-14;

    // 4/3 E* sqrt(R*) d^1.5, R* = r/2
    const scalar d = 1e-7;
    CHECK
    (
        model->force(d, 0, r, r, m, m)
     == Approx(4.0/3.0*1000*Foam::sqrt(0.5*r)*Foam::pow(d, 1.5))
    );
}


TEST_CASE("contact: the overlap that is allowed under a stress", "[contact][serial]")
{
    const scalar part = GENERATE(0.02, 0.1), p = 15, m = 1e-14;
    OStringStream os;
    os  << "type hertz; allowedOverlap " << part << "; stress " << p
        << "; restitution 1;";
    const auto model(selectModel<contactModel>(dictOf(os.str())));
    for (const scalar r : {0.5e-6, 3e-6})
    {
        const scalar F = constant::mathematical::pi*sqr(r)*p;
        CHECK(model->force(part*r, 0, r, r, m, m) == Approx(F));
        CHECK(model->force(0.794*part*r, 0, r, m) == Approx(F).epsilon(1e-3));
    }
    for
    (
        const string& wrong :
        {
            string("allowedOverlap 0.05;"),
            string("stress 15;"),
            string("reducedModulus 1000; stress 15;"),
            string("reducedModulus 1000; allowedOverlap 0.05; stress 15;"),
            string("allowedOverlap 0.9; stress 15;"),
            string("allowedOverlap 0.05; stress -15;")
        }
    )
    {
        CHECK_THROWS
        (
            selectModel<contactModel>
            (
                dictOf("type hertz; restitution 1; " + wrong)
            )
        );
    }
}


TEST_CASE("contact: a step has a potential", "[contact][serial]")
{
    // Force and stiffness are its derivatives, the force is that of the law at the
    // mean rate of the step, and the potential is convex
    const scalar e = GENERATE(1.0, 0.5);
    const scalar first = GENERATE(-3e-7, -1e-9, 2e-8, 1e-7, 4e-7);
    OStringStream os;
    os << "type hertz; reducedModulus 1000; restitution " << e << ";";
    const auto model(selectModel<contactModel>(dictOf(os.str())));
    const scalar R = 1e-6, m = 1e-14, h = 1e-12;

    for (const scalar dt : {1e-9, 1e-7, 1e-5, 1e-2})
    {
        for (scalar d = 1e-9; d < 5e-7; d *= 1.7)
        {
            const auto w = model->step(d, first, dt, R, m);
            const auto more = model->step(d + h, first, dt, R, m);
            const auto less = model->step(d - h, first, dt, R, m);
            INFO(e << ' ' << first << ' ' << dt << ' ' << d);
            CHECK
            (
                w.force
             == Approx(model->force(d, (d - first)/dt, R, m)).margin(1e-24)
            );
            CHECK(w.stiffness >= 0);
            CHECK(more.force >= w.force*(1 - 1e-12));
            if (less.force > 0)
            {
                CHECK
                (
                    w.force
                 == Approx((more.energy - less.energy)/(2*h)).epsilon(1e-3)
                );
                CHECK
                (
                    w.stiffness
                 == Approx((more.force - less.force)/(2*h)).epsilon(1e-3)
                );
            }
        }
    }
}


TEST_CASE("contact: a wall is a sphere without end", "[contact][serial]")
{
    const auto model
    (
        selectModel<contactModel>
        (
            dictOf("type hertz; reducedModulus 1000; restitution 0.5;")
        )
    );
    const scalar r = 2e-6, m = 1e-14, d = 1e-7, v = 1e-3;
    const scalar wall = model->force(d, v, r, m);
    CHECK(wall > model->force(d, 0, r, m));
    CHECK(wall > 1.2*model->force(d, v, r, r, m, m));
    CHECK(wall == Approx(model->force(d, v, r, 1e10*r, m, 1e10*m)).epsilon(1e-8));
    CHECK
    (
        model->step(d, 0, 1e-6, r, m).force
     == Approx
        (
            model->step
            (
                d, 0, 1e-6,
                contactModel::reduced(r, 1e10*r), contactModel::reduced(m, 1e10*m)
            ).force
        ).epsilon(1e-8)
    );
}


TEST_CASE("contact: coefficient of restitution", "[contact][serial]")
{
    // A sphere meets a wall; the law's damping gives back the fraction e of
    // its speed whatever the speed
    const scalar e = GENERATE(1.0, 0.8, 0.4);
    const scalar speed = GENERATE(1e-3, 1e-2);
    OStringStream os;
    os << "type hertz; reducedModulus 1000; restitution " << e << ";";
    const auto model(selectModel<contactModel>(dictOf(os.str())));

    const scalar r = 2e-6, m = 1e-14, dt = 1e-10;
    scalar overlap = 0, approach = speed;
    do
    {
        approach -= dt*model->force(max(overlap, scalar(0)), approach, r, m)/m;
        overlap += dt*approach;
    } while (overlap > 0);

    CHECK(-approach/speed == Approx(e).epsilon(0.03));
}
