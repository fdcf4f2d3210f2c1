/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "catch2/catch.hpp"
#include "testCloud.H"
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
    const scalar modulus = 1e5
)
{
    OStringStream os;
    os.precision(15);
    os  << "types { ball { shape { type chain; nSpheres 1; sphereRadius " << radius
        << "; } density " << density << "; } }"
        << "placement { type list; clumps (" << clumps.c_str() << "); }"
        << "contactModel { type hertz; reducedModulus " << modulus
        << "; restitution 0.5; friction " << friction << "; }"
        << "wallContactModel { type hertz; reducedModulus 1e5; restitution 0.5;"
        << " friction " << friction << "; }"
        << "loads { weight { type pointForces; clumpType ball; spheres (0); forces ("
        << force << "); torques ((0 0 0)); factor 1; } }"
        << "effects { fluid off; gravity off; contact on; walls on; }";
    return autoPtr<openCloud>(new openCloud(testMesh(), dictOf(os.str())));
}


struct motion
{
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
            result.u = p.state().u[0];
            result.w = p.state().w[0];
        }
    }
    reduce(result.u, sumOp<vector>());
    reduce(result.w, sumOp<vector>());
    return result;
}


//- The depth at which the wall carries the weight of the test, Hertz [m]
scalar depth(const scalar N)
{
    return Foam::pow(0.75*N/(1e5*Foam::sqrt(radius)), 2.0/3.0);
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
        OStringStream place;
        place.precision(15);
        place
            << "{ type ball; position (4e-6 " << radius - depth(N)
            << " 10e-6); velocity (0 0 0); }";
        autoPtr<openCloud> cloud
        (
            spheres
            (
                place.str(),
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


TEST_CASE("friction: absent unless asked for", "[contact][friction]")
{
    OStringStream place;
    place.precision(15);
    place
        << "{ type ball; position (4e-6 " << radius - depth(mass*g)
        << " 10e-6); velocity (1e-3 0 0); }";
    const vector weight(0, -mass*g, 0);
    const motion smooth(after(*spheres(place.str(), weight, 0), 20));
    CHECK(smooth.u.x() == Approx(1e-3).epsilon(1e-9));
    CHECK(mag(smooth.w) < 1e-9);

    // Half of its angular momentum about the place of contact: 5/7 of the velocity
    const motion rough(after(*spheres(place.str(), weight, 0.5), 200));
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
