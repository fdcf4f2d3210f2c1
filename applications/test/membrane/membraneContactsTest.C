/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCloud.H"
#include "mathematicalConstants.H"
#include "membraneContacts.H"

using namespace Foam;
using constant::mathematical::pi;

namespace
{

//- Capsules and a bead at rest in the test box; the mesh cells are 1 um wide, so that
//  contact begins at a gap of 0.5 um
autoPtr<openCloud> scene
(
    const string& clumps, const string& more = "", const string& moreTypes = ""
)
{
    autoPtr<openCloud> cloud
    (
        new openCloud
        (
            testMesh(),
            dictOf
            (
                "types"
                "{"
                "    capsule"
                "    {"
                "        shape { type icosphere; radius 3e-6; subdivisions 2; }"
                "        density 1000;"
                "        membrane { a { type neoHookean; shearModulus 1e-6; } }"
                "    }"
                "    bead { shape { type chain; nSpheres 1; sphereRadius 2e-6; }"
                "        density 1000; }" + moreTypes +
                "}"
                "placement { type list; clumps (" + clumps + "); }"
                "effects { fluid on; }" + more
            )
        )
    );
    cloud->immerse(uniformViscosity(), true);
    return cloud;
}

//- Force of contact on a clump and its moment about the origin, on all processors
Pair<vector> wrench(openCloud& cloud, const label id)
{
    Pair<vector> result(vector::zero, vector::zero);
    for (clumpParcel& p : cloud)
    {
        if (p.origId() != id)
        {
            continue;
        }
        // That on spheres is linear in the displacement, and here that of the bodies as
        // they are imposed
        const clumpStep& step = p.step();
        const vectorField moved(testTime().deltaTValue()*step.imposedU);
        const vectorField f
        (
            cloud.type(p).hasTriangles()
          ? nodesOf(p).force
          : vectorField(step.otherKindForces.f - (step.otherKindForces.k & moved))
        );
        const pointField x(p.centres() + moved);
        forAll(f, i)
        {
            result.first() += f[i];
            result.second() += x[i] ^ f[i];
        }
    }
    reduce(result.first(), sumOp<vector>());
    reduce(result.second(), sumOp<vector>());
    return result;
}

}


TEST_CASE("membrane contact: forces and moments of a pair add up to zero",
    "[membrane][parallel]")
{
    // Along x, and obliquely
    const string second = GENERATE
    (
        string("type capsule; position (13.2e-6 10.3e-6 10.1e-6);"),
        string("type capsule; position (11.3e-6 14.3e-6 10.1e-6);"),
        string("type bead; position (12.2e-6 10.3e-6 10.1e-6);"),
        string("type bead; position (10.6e-6 13.8e-6 10.1e-6);")
    );
    INFO(second);
    auto cloud = scene
    (
        "{ type capsule; position (7e-6 10e-6 10e-6); } { " + second + " }"
    );
    const Pair<vector> first(wrench(*cloud, 0));
    const Pair<vector> other(wrench(*cloud, 1));
    CHECK(first.first().x() < 0);
    CHECK(mag(first.first()) > 1e-13);
    CHECK(mag(first.first() + other.first())/mag(first.first()) < 1e-10);
    CHECK(mag(first.second() + other.second())/mag(first.second()) < 1e-9);
}


TEST_CASE("membrane contact: a film resists what comes and what goes",
    "[membrane][parallel]")
{
    // A bead beyond the range of contact, along x and obliquely
    const string lubrication = GENERATE(string(), string("lubrication { type squeezeFilm; }"));
    const string place = GENERATE
    (
        string("(13.2e-6 10.3e-6 10.1e-6)"), string("(11.4e-6 14.3e-6 10.1e-6)")
    );
    INFO(lubrication << ' ' << place);
    for (const scalar speed : {-1e-3, 1e-3})
    {
        auto cloud = scene
        (
            "{ type capsule; position (7e-6 10e-6 10e-6); }"
            "{ type bead; position " + place + "; velocity (" + Foam::name(speed) + " 0 0); }",
            lubrication
        );
        const Pair<vector> first(wrench(*cloud, 0));
        const Pair<vector> other(wrench(*cloud, 1));
        if (lubrication.empty())
        {
            CHECK(mag(first.first()) < 1e-25);
            continue;
        }
        CHECK(first.first().x()*speed > 0);
        CHECK(mag(first.first()) > 1e-12);
        CHECK(mag(first.first() + other.first())/mag(first.first()) < 1e-10);
        CHECK(mag(first.second() + other.second())/mag(first.second()) < 1e-9);
    }
}


TEST_CASE("membrane contact: an attraction is the integral of its pressure",
    "[membrane][parallel]")
{
    // Of a capsule of 642 nodes with a bead, 0.2 um beyond the range of contact, along x
    // and obliquely. The law is that of depletion with w0 = 1e-6 J/m2 and r = 1 um
    const vector e(normalised(GENERATE(vector(1, 0, 0), vector(0.6, 0.7, 0.2))));
    const string other = GENERATE(string("bead"), string("fine"));
    INFO(e.x() << ' ' << e.y() << ' ' << e.z() << ' ' << other);
    const scalar radius = other == "bead" ? 2 : 3, D = 3 + radius + 0.5 + 0.2;
    const string fine =
        "fine { shape { type icosphere; radius 3e-6; subdivisions 3; } density 1000;"
        " membrane { a { type neoHookean; shearModulus 1e-6; } } }";
    const point at(1e-6*(vector(7, 10, 10) + D*e));
    const string places =
        "{ type fine; position (7e-6 10e-6 10e-6); } { type " + other + "; position ("
      + Foam::name(at.x()) + ' ' + Foam::name(at.y()) + ' ' + Foam::name(at.z()) + "); }";
    const string law = " { type depletion; energy 1e-6; range 1; ";
    auto cloud = scene(places, "surfaceForces { a" + law + "} }", fine);
    const Pair<vector> first(wrench(*cloud, 0));
    const Pair<vector> second(wrench(*cloud, 1));
    CHECK(mag(first.first() + second.first())/mag(first.first()) < 1e-10);
    CHECK(mag(first.second() + second.second())/mag(first.second()) < 1e-9);

    // p = 6 w0/r x (1 - x) with x = (gap - 0.5 um)/r, over the sphere of 3 um
    scalar expected = 0;
    const label n = 20000;
    for (label k = 0; k < n; ++k)
    {
        const scalar c = 1 - 2*(k + 0.5)/n;
        const scalar along = D - 3*c;
        const scalar distance = Foam::sqrt(sqr(along) + 9*(1 - sqr(c)));
        const scalar x = distance - radius - 0.5;
        if (x < 1)
        {
            expected += 6e-6/1e-6*x*(1 - x)*along/distance*4*pi*9e-12/n;
        }
    }
    CHECK((first.first() & e) == Approx(expected).epsilon(0.05));
    CHECK(mag(first.first() - (first.first() & e)*e) < 0.05*expected);

    // The law does not act between other types, and at walls only where it names them
    cloud.clear();
    cloud = scene
    (
        places,
        "surfaceForces { a" + law + "types (capsule bead); } b" + law
      + "patches (walls); } }",
        fine
    );
    CHECK(mag(wrench(*cloud, 0).first()) < 1e-25);
    CHECK(mag(wrench(*cloud, 1).first()) < 1e-25);
}


TEST_CASE("membrane contact: attraction at a wall", "[membrane][parallel]")
{
    const string patches = GENERATE(string("patches (walls);"), string());
    auto cloud = scene
    (
        "{ type capsule; position (10e-6 3.7e-6 10e-6); }",
        "surfaceForces { a { type depletion; energy 1e-6; range 1; " + patches + " } }"
    );
    const vector f(wrench(*cloud, 0).first());
    if (patches.empty())
    {
        CHECK(mag(f) < 1e-25);
    }
    else
    {
        CHECK(f.y() < -1e-12);
        CHECK(mag(f.y()) > 10*mag(vector(f.x(), 0, f.z())));
    }
}


TEST_CASE("membrane contact: across periodic patches as elsewhere", "[membrane][parallel]")
{
    auto inside = scene
    (
        "{ type capsule; position (7e-6 10e-6 10e-6); }"
        "{ type capsule; position (13.2e-6 10.3e-6 10.1e-6); }"
    );
    const vector expected(wrench(*inside, 0).first());
    inside.clear();
    auto across = scene
    (
        "{ type capsule; position (17e-6 10e-6 19e-6); }"
        "{ type capsule; position (3.2e-6 10.3e-6 19.1e-6); }"
    );
    CHECK(mag(wrench(*across, 0).first() - expected) < 1e-9*mag(expected));
    CHECK(mag(wrench(*across, 1).first() + expected) < 1e-9*mag(expected));
}


TEST_CASE("membrane contact: with a wall, and none beyond its range", "[membrane][parallel]")
{
    {
        auto near = scene("{ type capsule; position (10e-6 3.2e-6 10e-6); }");
        const vector f(wrench(*near, 0).first());
        CHECK(f.y() > 0);
        CHECK(f.y() > 10*mag(vector(f.x(), 0, f.z())));
    }
    auto far = scene("{ type capsule; position (10e-6 3.6e-6 10e-6); }");
    CHECK(mag(wrench(*far, 0).first()) < 1e-25);
}


TEST_CASE("membrane contact: what is off does not act", "[membrane][serial]")
{
    auto cloud = scene
    (
        "{ type capsule; position (7e-6 10e-6 10e-6); }"
        "{ type capsule; position (13.2e-6 10e-6 10e-6); }"
        "{ type capsule; position (10e-6 3.2e-6 14e-6); }",
        "contactModel { type none; } wallContactModel { type none; }"
    );
    for (label id = 0; id < 3; ++id)
    {
        CHECK(mag(wrench(*cloud, id).first()) < 1e-25);
    }
}


TEST_CASE("membrane contact: impossible starts are refused", "[membrane][serial]")
{
    CHECK_THROWS
    (
        scene
        (
            "{ type capsule; position (7e-6 10e-6 10e-6); }"
            "{ type capsule; position (12e-6 10e-6 10e-6); }"
        )
    );
    CHECK_THROWS
    (
        scene
        (
            "{ type capsule; position (7e-6 10e-6 10e-6); }"
            "{ type bead; position (11e-6 10e-6 10e-6); }"
        )
    );

    // A bead that would pass between the nodes
    CHECK_THROWS
    (
        scene
        (
            "{ type capsule; position (7e-6 10e-6 10e-6); }",
            "",
            "dust { shape { type chain; nSpheres 1; sphereRadius 2e-7; }"
            " density 1000; }"
        )
    );
}


TEST_CASE("membrane contact: the force is the gradient of the potential",
    "[membrane][serial]")
{
    PtrList<clumpType> types(1);
    types.set
    (
        0,
        new clumpType
        (
            "test",
            dictOf
            (
                "density 1; membrane {}"
                " shape { type icosphere; radius 1; subdivisions 1; }"
            )
        )
    );
    const string law = GENERATE
    (
        string("stress 2;"), string("type hertz; reducedModulus 3; restitution 0.5;"),
        string("type elasticLayer; modulus 2; thickness 0.3;")
    );
    INFO(law);
    membraneContacts contacts
    (
        types, testMesh().boundaryMesh(),
        dictOf("membraneContact { range 1; " + law + " }")
    );
    ghostExchange ghosts(testMesh());

    // Without a film and with one, which acts below the gap 0.2 and is renewed by the step
    const scalar mu = GENERATE(0.0, 0.5);
    INFO(mu);

    // The same of an attraction beyond the range of contact, 0.1
    const string attraction = GENERATE
    (
        string(), string("surfaceForces { a { type depletion; energy 0.1; range 2; } }")
    );
    INFO(attraction);
    const gapForces gaps
    (
        dictOf("lubrication { type squeezeFilm; } " + attraction), types,
        testMesh().boundaryMesh()
    );
    contacts.begin(ghosts, 0.1, 1, Zero, gaps, mu > 0, mu);

    DynamicList<nodeContact> list;
    nodeContact c;
    c.nodes = -1;
    c.weights = scalar(0);
    c.nodes[0] = 3;
    c.weights[0] = 1;
    c.normal = vector(0.6, 0, 0.8);
    c.gap = 0.03;
    c.start = 0.15;
    c.radius = 0.4;
    c.faces = true;
    c.atWall = false;
    c.first = 0;
    c.second = 0;
    c.area = 0.2;
    c.moves = 1;
    list.append(c);
    const triFace& t = types[0].surface().triangles()[5];
    for (label n = 0; n < 3; ++n)
    {
        c.nodes[n] = t[n];
    }
    c.weights[0] = -0.2;
    c.weights[1] = -0.5;
    c.weights[2] = -0.3;
    c.gap = -0.01;
    c.start = 0.02;
    c.moves = 2;
    list.append(c);

    const label n = types[0].size();
    const auto potential = [&](const vectorField& d)
    {
        vectorField unused(n, Zero);
        return contacts.add(list, d, unused, nullptr);
    };
    Random random(2);
    vectorField d(n);
    for (vector& e : d)
    {
        e = 0.01*randomVector(random);
    }
    vectorField gradient(n, Zero);
    membraneTangent tangent(types[0].surface(), 1);
    tangent.clear(true);
    contacts.add(list, d, gradient, &tangent);
    for (label k = 0; k < 10; ++k)
    {
        vectorField v(n);
        for (vector& e : v)
        {
            e = randomVector(random);
        }
        const scalar h = 1e-6;
        const scalar slope =
            (potential(d + h*v) - potential(d - h*v))/(2*h);
        CHECK(sum(gradient & v) == Approx(slope).epsilon(1e-6));

        vectorField up(n, Zero), down(n, Zero);
        contacts.add(list, d + h*v, up, nullptr);
        contacts.add(list, d - h*v, down, nullptr);
        const vectorField change((up - down)/(2*h));
        const Eigen::VectorXd Hv(tangent.times(membraneTangent::asVector(v)));
        const auto reference = membraneTangent::asVector(change);
        CHECK((Hv - reference).norm() < 1e-5*reference.norm());
    }

    // At the positions imposed, the force that the fluid is given
    vectorField F(n, Zero);
    contacts.addForces(list, F);
    vectorField at(n, Zero);
    contacts.add(list, vectorField(n, Zero), at, nullptr);
    CHECK(max(mag(F + at)) < 1e-14);
    CHECK(max(mag(F)) > 0.01);
}


TEST_CASE("membrane contact: a bond pulls both of its ends", "[membrane][parallel]")
{
    // Of a node with a point of a triangle, from the files of a run. The two capsules are
    // so far apart that nothing else acts
    const label node = 5, triangle = 20;
    const vector weights(0.2, 0.3, 0.5);
    surfaceBond bond;
    bond.law = "a";
    bond.clump = labelPair(0, 1);
    bond.sphere = labelPair(node, triangle);
    bond.otherAnchor = weights;
    bond.length = 14e-6;
    {
        surfaceBonds file(testTime());
        file.replace(List<surfaceBond>(Pstream::master() ? 1 : 0, bond));
        file.regIOobject::write();
    }
    auto cloud = scene
    (
        "{ type capsule; position (6e-6 10e-6 10e-6); }"
        "{ type capsule; position (14e-6 10.5e-6 9e-6); }",
        "surfaceForces { a { type bell; types (capsule capsule); density 1e12; reach 1e-7;"
        " onRate 0; offRate 0; compliance 0; stiffness 1e-5; restLength 1e-7; } }"
    );
    rm(testTime().timePath()/"uniform"/"surfaceBonds");

    const clumpType& type = cloud->types()[0];
    const triFace& t = type.surface().triangles()[triangle];
    const pointField& x = type.centres();
    const vector d
    (
        vector(8e-6, 0.5e-6, -1e-6)
      + weights[0]*x[t[0]] + weights[1]*x[t[1]] + weights[2]*x[t[2]] - x[node]
    );

    // The string is as long as the range of contact, 0.5 um, longer than its rest length,
    // and tightens over a tenth of that
    const scalar tension = 1e-5*(mag(d) - 0.5e-6 - 1e-7 - 0.5e-8);
    const Pair<vector> first(wrench(*cloud, 0));
    const Pair<vector> second(wrench(*cloud, 1));
    CHECK(mag(first.first() - tension*d/mag(d)) < 1e-9*tension);
    CHECK(mag(first.first() + second.first()) < 1e-10*tension);
    CHECK(mag(first.second() + second.second()) < 1e-10*tension*1e-5);
}


TEST_CASE("membrane contact: a bond has the gradient and the tangent of its potential",
    "[membrane][serial]")
{
    PtrList<clumpType> types(1);
    types.set
    (
        0,
        new clumpType
        (
            "test",
            dictOf
            (
                "density 1; membrane {}"
                " shape { type icosphere; radius 1; subdivisions 1; }"
            )
        )
    );
    membraneContacts contacts(types, testMesh().boundaryMesh(), dictionary());
    ghostExchange ghosts(testMesh());
    const gapForces gaps
    (
        dictOf
        (
            "surfaceForces { a { type bell; density 1; reach 1; onRate 0; offRate 0;"
            " compliance 0; stiffness 2; restLength 0.5; } }"
        ),
        types, testMesh().boundaryMesh()
    );
    contacts.begin(ghosts, 0.2, 1, Zero, gaps, false, 0);

    // Slack, tightening, and tight; contact begins at 0.1
    const scalar length = GENERATE(0.5, 0.62, 0.9);
    INFO(length);
    DynamicList<nodeBond> list;
    nodeBond b;
    b.nodes = -1;
    b.weights = scalar(0);
    b.nodes[0] = 3;
    b.weights[0] = 1;
    b.d = length*vector(0.6, 0, 0.8);
    b.moves = 1;
    b.number = 0;
    b.first = true;
    b.kinetics = gaps.kinetics("a");
    list.append(b);
    const triFace& t = types[0].surface().triangles()[5];
    for (label n = 0; n < 3; ++n)
    {
        b.nodes[n] = t[n];
    }
    b.weights[0] = 0.2;
    b.weights[1] = 0.5;
    b.weights[2] = 0.3;
    b.moves = 2;
    list.append(b);

    const label n = types[0].size();
    vectorField F(n, Zero);
    contacts.addForces(list, F);
    const scalar s = length - 0.6;
    const scalar tension =
        s < 0 ? 0 : s < 0.05 ? 2*sqr(s)/0.1 : 2*(s - 0.025);
    CHECK(mag(F[3] - tension*vector(0.6, 0, 0.8)) < 1e-12);
    CHECK(mag(sum(F) - 2*tension*vector(0.6, 0, 0.8)) < 1e-12);

    vectorField d(n);
    Random random(2);
    for (vector& e : d)
    {
        e = 0.001*randomVector(random);
    }
    vectorField gradient(n, Zero);
    membraneTangent tangent(types[0].surface(), 1);
    tangent.clear(true);
    contacts.add(list, d, gradient, &tangent);
    for (label k = 0; k < 5; ++k)
    {
        vectorField v(n);
        for (vector& e : v)
        {
            e = randomVector(random);
        }
        const scalar h = 1e-6;
        vectorField up(n, Zero), down(n, Zero);
        const scalar slope =
            (
                contacts.add(list, d + h*v, up, nullptr)
              - contacts.add(list, d - h*v, down, nullptr)
            )/(2*h);
        CHECK(sum(gradient & v) == Approx(slope).epsilon(1e-6).margin(1e-9));
        const vectorField rate((up - down)/(2*h));
        const Eigen::VectorXd Kv(tangent.times(membraneTangent::asVector(v)));
        CHECK
        (
            (Kv - membraneTangent::asVector(rate)).norm()
         <= 1e-5*Kv.norm() + 1e-9
        );
    }
}
