/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clumpMotion.H"
#include "contactLaws.H"
#include "testCloud.H"
#include "volFields.H"
#include "wallMotion.H"
#include "mathematicalConstants.H"
#include <cmath>

using namespace Foam;

namespace
{

const scalar radius = 2e-6;
const scalar density = 1000;
const scalar mass = density*4*constant::mathematical::pi/3*pow3(radius);

//- Acceleration of the weight, large so that the spheres move within some steps [m/s2]
const scalar g = 1e4;


//- Spheres without a fluid, under forces on all of them
autoPtr<openCloud> spheres
(
    const string& clumps,
    const vector& force,
    const scalar friction,
    const scalar modulus = 1e5,
    const string& ofWalls = "",
    const scalar rollingFriction = 0
)
{
    const string law
    (
        "restitution 0.5; friction " + Foam::name(friction) + "; rollingFriction "
      + Foam::name(rollingFriction) + "; "
    );
    OStringStream os;
    os.precision(15);
    os  << "types { ball { shape { type chain; nSpheres 1; sphereRadius " << radius
        << "; } density " << density << "; } }"
        << "placement { type list; clumps (" << clumps.c_str() << "); }"
        << "contactModel { type hertz; reducedModulus " << modulus << "; "
        << law.c_str() << "}"
        << "wallContactModel { type hertz; reducedModulus 1e5; " << law.c_str()
        << ofWalls.c_str() << "}"
        << "loads { weight { type pointForces; clumpType ball; spheres (0); forces ("
        << force << "); torques ((0 0 0)); factor 1; } }"
        << "effects { fluid off; gravity off; contact on; walls on; }";
    return autoPtr<openCloud>(new openCloud(testMesh(), dictOf(os.str())));
}


struct motion
{
    vector x = Zero;
    vector u = Zero;
    vector w = Zero;
};


//- Of the clump of a number, on all processors, after some steps
motion after(openCloud& cloud, const label nSteps, const label id = 0)
{
    for (label step = 0; step < nSteps; ++step)
    {
        cloud.evolve();
        cloud.accept();
        cloud.moveParcels();
    }
    motion result;
    for (const clumpParcel& p : cloud)
    {
        if (p.origId() == id)
        {
            result.x = p.centres()[0];
            result.u = p.state().u[0];
            result.w = p.state().w[0];
        }
    }
    reduce(result.x, sumOp<vector>());
    reduce(result.u, sumOp<vector>());
    reduce(result.w, sumOp<vector>());
    return result;
}


//- The depth at which the wall carries the weight of the test, Hertz [m]
scalar depth(const scalar N)
{
    return Foam::pow(0.75*N/(1e5*Foam::sqrt(radius)), 2.0/3.0);
}


//- A ball that the wall at y = 0 carries with the force N [N], with a velocity along it
string onWall(const scalar N, const scalar u = 0)
{
    OStringStream place;
    place.precision(15);
    place
        << "{ type ball; position (4e-6 " << radius - depth(N)
        << " 10e-6); velocity (" << u << " 0 0); }";
    return place.str();
}

}


TEST_CASE("friction: a sphere on an incline", "[contact][friction]")
{
    // The wall is at y = 0; the weight is turned. Rolling needs mu > 2/7 tan a
    const scalar mu = 0.2;
    const scalar dt = testTime().deltaTValue();
    for (const scalar angle : {0.2, 0.4, 1.0})
    {
        const scalar N = mass*g*std::cos(angle);
        const string place(onWall(N));
        autoPtr<openCloud> cloud
        (
            spheres
            (
                place,
                mass*g*vector(std::sin(angle), -std::cos(angle), 0), mu
            )
        );
        after(*cloud, 10);
        const motion begin(after(*cloud, 0));
        const label n = 40;
        const motion end(after(*cloud, n));
        const scalar a = (end.u.x() - begin.u.x())/(n*dt);
        const scalar alpha = -(end.w.z() - begin.w.z())/(n*dt);

        // Rolling 5/7 g sin a; slipping g (sin a - mu cos a), alpha = mu N r/I
        const bool rolls = std::tan(angle) < 3.5*mu;
        const scalar expected =
            rolls
          ? 5.0/7.0*g*std::sin(angle)
          : g*(std::sin(angle) - mu*std::cos(angle));
        const scalar turning =
            rolls ? expected/radius : 2.5*mu*g*std::cos(angle)/radius;
        CHECK(a == Approx(expected).epsilon(0.01));
        CHECK(alpha == Approx(turning).epsilon(0.01));
        CHECK(mag(end.u.z()) < 1e-9*mag(end.u.x()));
        if (rolls)
        {
            // The surfaces creep
            CHECK
            (
                mag(end.u.x() + end.w.z()*radius) < 2e-3*mu*g*std::cos(angle)*dt
              + 0.01*end.u.x()
            );
        }
    }
}


TEST_CASE("friction: a sphere that resists rolling", "[contact][friction]")
{
    // On an incline: at rest below atan(mu_r); above it, the moment mu_r r N and the
    // friction F at the wall give 5/7 g (sin a - mu_r cos a)
    const scalar rolling = 0.1;
    const scalar dt = testTime().deltaTValue();
    for (const scalar angle : {0.09, 0.11, 0.3})
    {
        const scalar N = mass*g*std::cos(angle);
        autoPtr<openCloud> cloud
        (
            spheres
            (
                onWall(N),
                mass*g*vector(std::sin(angle), -std::cos(angle), 0), 0.5, 1e5, "",
                rolling
            )
        );
        after(*cloud, 10);
        const motion begin(after(*cloud, 0));
        const label n = 40;
        const motion end(after(*cloud, n));
        const scalar a = (end.u.x() - begin.u.x())/(n*dt);

        // The place of contact is nearer to the centre than a radius
        const scalar arm = 1 - depth(N)/radius;
        const scalar excess =
            std::sin(angle) - rolling*std::cos(angle)/arm;
        const scalar expected = g*max(excess, scalar(0))/(1 + 0.4/sqr(arm));
        INFO(angle);
        CHECK(a == Approx(expected).epsilon(0.01).margin(1e-5*g));
        CHECK(mag(end.u.x() + end.w.z()*arm*radius) < 1e-3*g*dt + 0.01*end.u.x());
    }

    // One that spins about the line of centres goes on
    autoPtr<openCloud> cloud
    (
        spheres(onWall(mass*g), vector(0, -mass*g, 0), 0.5, 1e5, "", rolling)
    );
    for (clumpParcel& p : *cloud)
    {
        p.state().w[0] = vector(0, 1e3, 0);
    }
    CHECK(after(*cloud, 20).w.y() == Approx(1e3).epsilon(1e-6));
}


TEST_CASE("friction: a sphere that rolls and spins", "[contact][friction]")
{
    // It rolls on straight, while it turns about the normal of the wall by 0.3 rad a step.
    // The rotation vector of a step, by which the slip is measured, is turned by the spin
    const scalar dt = testTime().deltaTValue();
    const scalar turn = 0.3/dt;
    const scalar N = mass*g;
    OStringStream place;
    place.precision(15);
    place
        << "{ type ball; position (4e-6 " << radius - depth(N) << " 10e-6); velocity ("
        << turn*radius << " 0 0); angularVelocity (0 " << turn << " " << -turn << "); }";
    autoPtr<openCloud> cloud(spheres(place.str(), mass*g*vector(0, -1, 0), 0.5));

    const label n = 10;
    const motion end(after(*cloud, n));
    CHECK(end.u.x() == Approx(turn*radius).epsilon(0.01));
    CHECK(mag(end.u.z()) < 0.01*end.u.x());

    const label solves = returnReduce(cloud->motion().nSolves(), sumOp<label>());
    INFO(scalar(solves)/n << " solutions in a step");
    CHECK(solves <= 60*n);
}


TEST_CASE("friction: absent unless asked for", "[contact][friction]")
{
    const string place(onWall(mass*g, 1e-3));
    const vector weight(0, -mass*g, 0);
    const motion smooth(after(*spheres(place, weight, 0), 20));
    CHECK(smooth.u.x() == Approx(1e-3).epsilon(1e-9));
    CHECK(mag(smooth.w) < 1e-9);

    // Half of its angular momentum about the place of contact: 5/7 of the velocity
    const motion rough(after(*spheres(place, weight, 0.5), 200));
    CHECK(rough.u.x() == Approx(1e-3*5/7).epsilon(0.01));
    CHECK(-rough.w.z()*radius == Approx(1e-3*5/7).epsilon(0.01));
}


TEST_CASE("friction: two spheres that meet obliquely", "[contact][friction]")
{
    // Before: one moves along x with an offset in y. In the direction t across the line
    // of centres, a slipping contact has the impulse mu times that along it
    const string places =
        "{ type ball; position (6e-6 9e-6 10e-6); velocity (0.5 0 0); }"
        "{ type ball; position (10.02e-6 10.5e-6 10e-6); velocity (-0.5 0 0); }";
    const scalar mu = 0.05;
    const scalar dt = testTime().deltaTValue();
    testTime().setDeltaT(2e-8, false);
    autoPtr<openCloud> cloud(spheres(places, Zero, mu, 1e7));
    const motion a(after(*cloud, 60, 0));
    const motion b(after(*cloud, 0, 1));
    testTime().setDeltaT(dt, false);

    // Momenta: linear, and angular about the middle between the two
    CHECK(mag(a.u + b.u) < 1e-8);
    CHECK(mag(a.w - b.w) < 1e-6*mag(a.w));
    CHECK(mag(a.w) > 1e3);

    // The change of the velocity: normal part J/m, tangential part mu J/m, and the spin
    // 5/2 mu J/(m r)
    const vector change(a.u - vector(0.5, 0, 0));
    const scalar spin = 0.4*radius*mag(a.w);
    const scalar normal = Foam::sqrt(magSqr(change) - sqr(spin));
    CHECK(normal > 0.1);
    CHECK(spin/normal == Approx(mu).epsilon(0.02));
}


namespace
{

//- U of the test box with walls that move as a rigid body, as fixedValue
autoPtr<volVectorField> movingWalls(const vector& u, const vector& w)
{
    const fvMesh& mesh = testMesh();
    wordList kinds(mesh.boundary().size());
    forAll(kinds, patchi)
    {
        const word& type = mesh.boundary()[patchi].type();
        kinds[patchi] = type == "wall" ? word("fixedValue") : type;
    }
    autoPtr<volVectorField> U
    (
        new volVectorField
        (
            IOobject("U", mesh.time().timeName(), mesh),
            mesh, dimensionedVector(dimVelocity, Zero), kinds
        )
    );
    forAll(kinds, patchi)
    {
        if (kinds[patchi] == "fixedValue")
        {
            U->boundaryFieldRef()[patchi] ==
                u + (w ^ mesh.boundary()[patchi].Cf());
        }
    }
    return U;
}

}


TEST_CASE("friction: a wall that moves", "[contact][friction]")
{
    // A sphere that rests on a belt takes 2/7 of its velocity when it rolls without
    // slip: its angular momentum about the place of contact stays zero. This place is
    // nearer to the centre than a radius
    const scalar belt = 1e-3;
    const autoPtr<volVectorField> U(movingWalls(vector(belt, 0, 0), Zero));
    const string place(onWall(mass*g));
    const vector weight(0, -mass*g, 0);
    const scalar mu = 0.5;
    autoPtr<openCloud> cloud(spheres(place, weight, mu));

    // While it slips, its acceleration is mu g
    const scalar dt = testTime().deltaTValue();
    const motion first(after(*cloud, 1));
    CHECK(first.u.x() > 0);
    CHECK(first.u.x() <= 1.02*mu*g*dt);
    const motion middle(after(*cloud, 100));
    const motion end(after(*cloud, 100));
    const scalar arm = radius - depth(mass*g);
    const scalar expected = belt/(1 + 2.5*sqr(arm/radius));
    CHECK(expected == Approx(2.0/7*belt).epsilon(0.02));
    const scalar mean = (end.x.x() - middle.x.x())/(100*dt);
    CHECK(mean == Approx(expected).epsilon(1e-3));

    // In a single step spheres that stick may slip by this velocity, see contactStep
    const scalar slip = 1e-3*mu*g*dt;
    CHECK(mag(end.u.x() - expected) < slip);
    CHECK(mag(end.u.x() + end.w.z()*arm - belt) < slip);

    // And stays at rest where the pair has no friction
    const motion smooth
    (
        after
        (
            *spheres
            (
                place, weight, mu, 1e5,
                "pairs { smooth { patches (walls); friction 0; } }"
            ),
            20
        )
    );
    CHECK(mag(smooth.u.x()) < 1e-9*belt);
}


TEST_CASE("friction: a wall whose images would move otherwise", "[contact][friction]")
{
    // It turns about y, the box is periodic in x and z
    const autoPtr<volVectorField> U(movingWalls(Zero, vector(0, 50, 0)));
    const string place(onWall(mass*g));
    const vector weight(0, -mass*g, 0);
    CHECK_THROWS(after(*spheres(place, weight, 0.5), 1));

    // Without friction the walls have no motion
    CHECK_NOTHROW(after(*spheres(place, weight, 0), 1));
}


TEST_CASE("friction: motion of a wall", "[contact][friction]")
{
    const vector u(1e-3, 0, -2e-3);
    const vector w(0, 50, 0);
    autoPtr<volVectorField> U(movingWalls(u, w));
    forAll(U->boundaryField(), patchi)
    {
        if (U->boundaryField()[patchi].patch().type() == "wall")
        {
            const wallMotion turns(U->boundaryField()[patchi]);
            const point x(3e-6, 20e-6, 7e-6);
            CHECK(turns.moves());
            CHECK(mag(turns(x) - u - (w ^ x)) < 1e-9*mag(u));
            CHECK(mag(turns.w() - w) < 1e-8*mag(w));

            // Stretched along x: not that of a rigid body
            U->boundaryFieldRef()[patchi] ==
                100*U->boundaryField()[patchi].patch().Cf();
            CHECK_THROWS(wallMotion(U->boundaryField()[patchi]));
        }
    }
}


TEST_CASE("friction: laws of pairs of types and of patches", "[contact][friction]")
{
    PtrList<clumpType> types(3);
    const wordList names({"glass", "steel", "wood"});
    forAll(types, i)
    {
        types.set
        (
            i,
            new clumpType
            (
                names[i],
                dictOf
                (
                    "shape { type chain; nSpheres 1; sphereRadius 1e-6; } density 1000;"
                )
            )
        );
    }
    const string law("type hertz; reducedModulus 1e5; restitution 0.5; friction 0.3; ");
    const contactLaws laws
    (
        dictOf
        (
            law
          + "pairs { a { types (glass steel); friction 0.1; }"
            " b { types (wood wood); allowedOverlap 0.1; stress 10; } }"
        ),
        types
    );
    CHECK(laws(0, 0).friction() == 0.3);
    CHECK(laws(0, 1).friction() == 0.1);
    CHECK(laws(1, 0).friction() == 0.1);
    CHECK(laws(1, 2).friction() == 0.3);
    CHECK(laws(2, 2).friction() == 0.3);
    CHECK(laws.frictional());
    const scalar E = 3*constant::mathematical::pi*10/Foam::pow(0.2, 1.5);
    CHECK
    (
        laws(2, 2).force(1e-8, 0, 1e-6, 1e-15)
     == Approx(E/1e5*laws(0, 1).force(1e-8, 0, 1e-6, 1e-15))
    );

    const auto walls = [&](const string& pairs)
    {
        return contactLaws
        (
            dictOf(law + "pairs { " + pairs + " }"), types, testMesh().boundaryMesh()
        );
    };
    const label wall = testMesh().boundaryMesh().findPatchID("walls");
    const contactLaws some(walls("a { types (steel); patches (\"wa.*\"); friction 0; }"));
    CHECK(some(0, wall).friction() == 0.3);
    CHECK(some(1, wall).friction() == 0);
    CHECK(!walls("a { types (steel); type none; }")(1, wall).active());

    // What cannot be
    for
    (
        const char* pairs :
        {
            "a { friction 0; }", "a { types (iron); friction 0; }",
            "a { patches (inlet); friction 0; }", "a { patches (none); }",
            "a { patches (walls); } b { types (wood); }",
            "a { patches (walls); frction 0; }"
        }
    )
    {
        INFO(pairs);
        CHECK_THROWS(walls(pairs));
    }
    for
    (
        const char* pairs :
        {
            "a { types (glass); }", "a { types (glass steel wood); }",
            "a { types (glass steel); patches (walls); }", "a { }",
            "a { types (glass steel); } b { types (steel glass); }"
        }
    )
    {
        INFO(pairs);
        CHECK_THROWS(contactLaws(dictOf(law + "pairs { " + pairs + " }"), types));
    }
}


namespace
{

//- Height of the top of four spheres, one on three that touch each other, after it has
//  had the time to collapse [radii]
scalar heapOfFour(const scalar mu, const scalar ofFloor, const scalar rolling)
{
    const scalar R = 2*radius/std::sqrt(3.0);
    const scalar sunk = depth(4.0/3*mass*g);
    OStringStream os;
    os.precision(15);
    for (label k = 0; k < 3; ++k)
    {
        const scalar angle = constant::mathematical::twoPi*k/3;
        os  << "{ type ball; position ("
            << 10e-6 + 0.9999*R*std::cos(angle) << ' ' << radius - sunk << ' '
            << 10e-6 + 0.9999*R*std::sin(angle) << "); velocity (0 0 0); }";
    }
    os  << "{ type ball; position (10e-6 "
        << radius - sunk + 2*radius*std::sqrt(2.0/3)*0.9999
        << " 10e-6); velocity (0 0 0); }";
    autoPtr<openCloud> cloud
    (
        spheres
        (
            os.str(), vector(0, -mass*g, 0), mu, 1e7,
            "pairs { floor { patches (walls); friction " + Foam::name(ofFloor)
          + "; } }",
            rolling
        )
    );
    after(*cloud, 120);
    scalar top = 0;
    for (const clumpParcel& p : *cloud)
    {
        top = max(top, p.position().y());
    }
    return returnReduce(top, maxOp<scalar>())/radius - 1;
}

}


TEST_CASE("friction: a heap of four", "[contact][friction]")
{
    // A sphere on three others that touch each other, with a = 35.26 degrees between the
    // lines of centres and the vertical. Balance of moments of a lower sphere: both of its
    // frictions are f; of horizontal forces: f (1 + cos a) = N sin a. So the spheres need
    // mu > tan(a/2) = 0.318, and the floor, with N_floor = 4/3 W and f = W/3 tan(a/2),
    // mu > tan(a/2)/4 = 0.079
    const scalar a = std::asin(1/std::sqrt(3.0));
    const scalar between = std::tan(0.5*a);
    const scalar high = 2*std::sqrt(2.0/3);
    CHECK(heapOfFour(1.15*between, 0.3*between, 0) == Approx(high).epsilon(0.03));
    CHECK(heapOfFour(0.85*between, 0.3*between, 0) < 0.9*high);
    CHECK(heapOfFour(1.15*between, 0.2*between, 0) < 0.9*high);

    // With the moments mu_r r/2 N between the spheres and mu_r r N_floor on the floor, the
    // friction on the floor is f + mu_r (N/2 + N_floor), and mu needs to be larger than
    // tan(a/2) - mu_r (1/2 + 4 (cos a + mu sin a))/(1 + cos a)
    const scalar mu = 0.8*between;
    const scalar rolling =
        (between - mu)*(1 + std::cos(a))
       /(0.5 + 4*(std::cos(a) + mu*std::sin(a)));
    CHECK(heapOfFour(mu, between, 1.2*rolling) == Approx(high).epsilon(0.03));
    CHECK(heapOfFour(mu, between, 0.5*rolling) < 0.9*high);
}
