/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clumpMotion.H"
#include "fluidCoupling.H"
#include "touchingClumps.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

const scalar r = 1.2e-6;
const scalar rho = 1025;        // of the box
const scalar nu = 1.171e-6;

// Cut-offs in mesh cells of 1 um
const scalar pairLimit = 0.85e-6;
const scalar wallLimit = 1.3e-6;

//- Clumps in a fluid that moves with them
struct wetCloud
:
    public dryCloud
{
    //- Of what the clumps of this processor received
    scalar work;

    //- Forces of contacts and films on the spheres of each of them [N]
    DynamicList<vectorField> contacts;

    wetCloud
    (
        const scalar dt,
        const string& clumps,
        const string& more = "",
        const string& lubrication = "roughness 1e-8;"
    )
    :
        dryCloud
        (
            dt, clumps, "reducedModulus 1000; restitution 1;",
            "type implicitEuler; tolerance 1e-9; maxIterations 200;",
            "rotation { type wholeClump; }"
            "couplingScheme { type robin; coefficient 1; }"
            "immersedBoundary { solidFraction { type tetClipping; }"
            " forcing { type sharp; }"
            " hydrodynamicForce { type momentumExchange; }"
            " interiorDilation yes; }"
            "effects { fluid on; }"
            "types { bead { shape { type chain; nSpheres 1; sphereRadius 1.2e-6; }"
            " density 1000; massModel union; motion free; bondModel { type elastic;"
            " rigidities { normal 1e-12; tangential 1e-12; bending 1e-24;"
            " torsional 1e-24; } } dampingModel { type none; } } }"
            "lubrication { type squeezeFilm; " + lubrication + "}" + more
        ),
        work(0)
    {
        const fvMesh& mesh = testMesh();
        const volScalarField viscosity(uniformViscosity(mesh, nu));
        const volScalarField p
        (
            IOobject("p", testTime().timeName(), mesh),
            mesh, dimensionedScalar("p", sqr(dimVelocity), 0)
        );
        cloud->immerse(viscosity);
        const volVectorField U("U", cloud->boundary().solidVelocity());
        DynamicList<pointField> before;
        for (const clumpParcel& clump : *cloud)
        {
            before.append(clump.state().x);
        }
        cloud->evolve(U, p, viscosity);
        for (const clumpParcel& clump : *cloud)
        {
            externalForces ofFluid(cloud->type(clump).size());
            cloud->coupling().addForces
            (
                clump, testTime().deltaTValue(), ofFluid
            );
            contacts.append(vectorField(clump.step().forces.f - ofFluid.f));
        }
        cloud->accept();
        label k = 0;
        for (const clumpParcel& clump : *cloud)
        {
            work += sum(contacts[k] & (clump.state().x - before[k]));
            ++k;
        }
    }

    //- What the clumps received from each other and from walls, in the order of
    //  placement
    vectorField received() const
    {
        vectorField result(cloud->nClumps(), Zero);
        label k = 0;
        for (const clumpParcel& p : *cloud)
        {
            result[p.origId()] = sum(contacts[k++]);
        }
        reduce(result, sumOp<vectorField>());
        return result;
    }

    vector moment() const
    {
        label k = 0;
        return sumOver<vector>
        (
            [&](const clumpParcel& p, const clumpType&)
            {
                return sum(p.centres() ^ contacts[k++]);
            }
        );
    }
};

//- The impulse of a gap that changes from g0 to g1
scalar impulse
(
    const scalar R,
    const scalar g0,
    const scalar g1,
    const scalar limit = pairLimit
)
{
    return
        6*constant::mathematical::pi*rho*nu*sqr(R)
       *(
            Foam::log(g0/g1)
          - 2*(Foam::sqrt(g0/limit) - Foam::sqrt(g1/limit))
        );
}

}


TEST_CASE("lubrication: two spheres and a sphere at a wall", "[lubrication]")
{
    // Approaching or parting, one pair across a periodic boundary, for any step
    const scalar dt = GENERATE(1e-7, 1e-5, 1e-3);
    const scalar sign = GENERATE(1, -1);
    const scalar g0 = 2e-7, u = sign*min(1e-4, 1e-7/dt);
    const scalar D = 2*r + g0;
    const vector away(0.36, 0.48, 0.8);
    wetCloud t
    (
        dt,
        at("bead", point(6e-6, 10e-6, 10e-6), u*away)
      + at("bead", point(6e-6, 10e-6, 10e-6) + D*away, -u*away)
      + at("bead", point(0.2e-6, 14e-6, 10e-6), vector(-u, 0, 0))
      + at("bead", point(0.2e-6 - D + 20e-6, 14e-6, 10e-6), vector(u, 0, 0))
      + at("bead", point(14e-6, r + g0, 4e-6), vector(0, -u, 0))
      + at("bead", point(14e-6, 10e-6, 4e-6), vector(0, -u, 0))
    );
    const vectorField f(t.received());
    const vectorField x(t.centres());
    const scalar h = mag(x[1] - x[0]) - 2*r;
    const scalar w = x[4].y() - r;
    const scalar across = 20e-6 - mag(x[3] - x[2]) - 2*r;
    INFO(dt << ' ' << sign << ": gaps " << h << ' ' << w);

    // The start is rounded to the digits of the input
    CHECK(sign*(g0 - h) > 1e-5*g0);
    CHECK((f[1] & away) == Approx(impulse(0.5*r, g0, h)/dt).epsilon(1e-6));
    CHECK(mag(f[1] - (f[1] & away)*away) < 1e-6*mag(f[1]));
    CHECK(f[2].x() == Approx(impulse(0.5*r, g0, across)/dt).epsilon(1e-6));
    CHECK(f[4].y() == Approx(impulse(r, g0, w, wallLimit)/dt).epsilon(1e-6));
    CHECK(mag(f[0] + f[1]) < 1e-12*mag(f[1]));
    CHECK(mag(f[2] + f[3]) < 1e-12*mag(f[2]));
    CHECK(mag(f[5]) == 0);
}


TEST_CASE("lubrication: opposite forces without a moment, dissipation", "[lubrication]")
{
    const scalar dt = GENERATE(1e-6, 1e-4);
    wetCloud t
    (
        dt,
        at
        (
            "cell", point(5.2e-6, 10e-6, 10e-6), vector(1e-3, 0, 0),
            "axis (1 1 0); angle 40;"
        )
      + at("cell", point(13.1e-6, 11.7e-6, 9.1e-6), vector(-1e-3, 0, 0))
    );
    const vectorField f(t.received());
    REQUIRE(mag(f[0]) > 0);
    CHECK(mag(f[0] + f[1]) < 1e-12*mag(f[0]));
    CHECK(mag(t.moment()) < 1e-12*mag(f[0])*20e-6);

    CHECK(returnReduce(t.work, sumOp<scalar>()) < 0);
}


TEST_CASE("lubrication: the spheres of a clump share a gap", "[lubrication]")
{
    // Face to face, the force does not depend on the number of spheres, and a clump
    // has none with itself
    const scalar dt = 1e-6, gap = 1.5e-7, u = 1e-3;
    scalarField forces(2);
    forAll(forces, k)
    {
        const label n = k ? 20 : 12;
        OStringStream types;
        types.precision(15);
        types
            << "types { ring { shape { type ring; nSpheres " << n
            << "; ringRadius 2.4e-6; sphereRadius 1.4e-6; }"
            << " density 1000; massModel union; motion free;"
            << " bondModel { type elastic; rigidities { normal 1e-12;"
            << " tangential 1e-12; bending 1e-24; torsional 1e-24; } }"
            << " dampingModel { type none; } } }";
        wetCloud t
        (
            dt,
            at("ring", point(10e-6, 10e-6, 5e-6), vector(0, 0, u))
          + at("ring", point(10e-6, 10e-6, 7.8e-6 + gap), vector(0, 0, -u))
          + at("ring", point(10e-6, 10e-6, 14e-6), vector(0, 0, -u)),
            types.str()
        );
        const vectorField f(t.received());
        const vectorField x(t.centres());
        forces[k] =
            f[1].z()*dt/impulse(0.7e-6, gap, x[1].z() - x[0].z() - 2.8e-6);
        CHECK(mag(f[2]) < 1e-12*mag(f[1]));
    }
    // L/(r sqrt(pi/2))
    CHECK(forces[0] == Approx(8.59).epsilon(0.15));
    CHECK(forces[1] == Approx(8.59).epsilon(0.15));
}


TEST_CASE("lubrication: on where something is near", "[lubrication][effects]")
{
    const auto active = [](const string& clumps, const string& more = "")
    {
        wetCloud t(1e-5, clumps, more);
        return t.cloud->effects().active("lubrication");
    };
    const string one(at("bead", point(10e-6, 10e-6, 10e-6), Zero));
    CHECK(!active(one));
    CHECK(active(one + at("bead", point(13.1e-6, 10e-6, 10e-6), Zero)));
    CHECK(!active(one + at("bead", point(15e-6, 10e-6, 10e-6), Zero)));
    CHECK(active(at("bead", point(10e-6, 1.9e-6, 10e-6), Zero)));
    CHECK
    (
        !active
        (
            one + at("bead", point(13.1e-6, 10e-6, 10e-6), Zero),
            "effects { lubrication off; }"
        )
    );
}


TEST_CASE("lubrication: nothing bounces below a Stokes number of ten", "[lubrication]")
{
    // Two equal spheres in half of the duration of a contact
    const scalar density = 1e9, mu = rho*nu;
    const auto solves = [&](const scalar Stokes)
    {
        // St = m*/(6 pi mu R*^2) 2 u
        const scalar m = density*4.0/3.0*constant::mathematical::pi*pow3(r);
        const scalar u = Stokes*6*constant::mathematical::pi*mu*sqr(0.5*r)/m;
        const scalar k = 4.0/3.0*1000*Foam::sqrt(0.5*r);
        const scalar T = 2.943*Foam::pow(1.25*0.5*m*sqr(2*u)/k, 0.4)/(2*u);
        OStringStream heavy;
        heavy << "types { bead { density " << density << "; } }";
        wetCloud t
        (
            0.5*T,
            at("bead", point(5e-6, 10e-6, 10e-6), vector(u, 0, 0))
          + at("bead", point(5e-6 + 2*r + 1e-10, 10e-6, 10e-6), vector(-u, 0, 0)),
            heavy.str()
        );
        return returnReduce(t.cloud->motion().nSolves(), sumOp<label>());
    };
    const label below = solves(9), above = solves(11);
    INFO(below << " and " << above << " solutions");
    CHECK(below < 30);
    CHECK(above > 2*16);
}


TEST_CASE("lubrication: what it needs", "[lubrication]")
{
    const string pair
    (
        at("bead", point(10e-6, 10e-6, 10e-6), Zero)
      + at("bead", point(12.9e-6, 10e-6, 10e-6), Zero)
    );
    // A fluid that feels the clumps
    CHECK_THROWS(wetCloud(1e-5, pair, "effects { fluid off; lubrication on; }"));
    // A contact for the gaps to end at
    CHECK_THROWS
    (
        wetCloud
        (
            1e-5, pair,
            "contactModel { type none; } wallContactModel { type none; }"
            "effects { lubrication on; }"
        )
    );
    // An implicit step
    CHECK_THROWS
    (
        wetCloud
        (
            1e-5, pair, "integrator { type velocityVerlet; stepFraction 0.1; }"
        )
    );
    CHECK_THROWS(wetCloud(1e-5, pair, "", "roughness 0;"));
    CHECK_THROWS(wetCloud(1e-5, pair, "", "cut 0.8; roughness 1e-8;"));
    CHECK_THROWS(wetCloud(1e-5, pair, "lubrication { type film; }"));
}
