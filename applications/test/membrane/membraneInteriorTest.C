/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testImmersion.H"
#include "foamCompat.H"
#include "mathematicalConstants.H"
#include "variableViscosity.H"

using namespace Foam;

TEST_CASE("viscosity ratio: the inside has its volume", "[membrane][parallel]")
{
    // In the middle, and across periodic patches and processors
    const point centre = GENERATE
    (
        point(10e-6, 10e-6, 10e-6), point(0.5e-6, 9e-6, 19e-6)
    );
    const scalar ratio = GENERATE(0.2, 5.0);
    const testInterior sphere(List<point>(1, centre), ratio);
    const scalarField& f = sphere.factor().primitiveField();
    const scalar V = gSum(testMesh().V()*(1/f - 1))/(1/ratio - 1);

    // The kernel of the variance s^2 adds a shell with the second moment 4 pi R s^2
    const scalar R = 4, s2 = 0.3;
    const scalar expected = constant::mathematical::pi*(4.0/3.0*pow3(R) + 4*R*s2);
    CHECK(V*1e18 == Approx(expected).epsilon(0.01));
    CHECK(gMin(f) == Approx(min(1.0, ratio)));
    CHECK(gMax(f) == Approx(max(1.0, ratio)));
}


TEST_CASE("viscosity ratio: two surfaces in a mesh cell", "[membrane][parallel]")
{
    List<point> centres(2, point(6e-6, 10e-6, 10e-6));
    centres[1].x() = 13.7e-6;
    const testInterior spheres(centres, 0.2);
    const scalarField& f = spheres.factor().primitiveField();
    CHECK(gMin(f) > 0.1999);
    CHECK(gMax(f) < 1.0001);

    // In any order of the images
    Swap(centres[0], centres[1]);
    const testInterior swapped(centres, 0.2);
    CHECK(gMax(mag(f - swapped.factor().primitiveField())()) < 1e-12);
}


TEST_CASE("viscosity ratio: the force that cancels the slip has no sum and no torque",
    "[membrane][parallel]")
{
    // A torque on the surfaces and a force along x. The layers of two spheres overlap, and
    // end before the periodic patches
    const fvMesh& mesh = testMesh();
    List<point> centres(2, point(5.6e-6, 10e-6, 10e-6));
    centres[1].x() = 13.8e-6;
    const auto force = [](const vector& r)
    {
        return 1e-6*((vector(1, 2, 3) ^ r) + vector(3e-6, 0, 0));
    };
    testInterior same(centres, 1);
    testInterior other(centres, 20);
    same.push(force);
    other.push(force);
    const vectorField before(same.immersion->force().primitiveField()*mesh.V());
    const vectorField change
    (
        other.immersion->force().primitiveField()*mesh.V() - before
    );
    CHECK(gSum(mag(change)()) > 0.1*gSum(mag(before)()));
    CHECK(mag(gSum(change)) < 1e-12*gSum(mag(change)()));

    // The latter in the second order of the mesh: the radius is four mesh cells
    const vectorField r(mesh.cellCentres() - 0.5*(centres[0] + centres[1]));
    const vector torque(gSum((r ^ before)()));
    CHECK(mag(gSum((r ^ change)()))/mag(torque) < 0.02);
}


namespace
{

//- A sphere in the middle of the box that forces on its surface turn
struct turnedSphere
{
    //- Angular velocities of the inside and of the surface [1/s]
    vector ofInside;
    vector ofSurface;

    //- Mean shear stress of both sides over half of the force
    scalar stress;

    turnedSphere(const scalar ratio, const scalar radius);
};


turnedSphere::turnedSphere(const scalar ratio, const scalar radius)
:
    ofInside(Zero),
    ofSurface(Zero),
    stress(0)
{
    const fvMesh& mesh = testMesh();
    testInterior sphere(List<point>(1, point(10e-6, 10e-6, 10e-6)), ratio, radius);
    const scalar mu = 1e-3;
    sphere.push([](const vector& r) { return vector(1, -2, 3) ^ r; });

    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero), "fixedValue"
    );
    const volScalarField nu
    (
        dimensionedScalar("nu", dimViscosity, mu)*sphere.factor()
    );
    const volVectorField acceleration
    (
        sphere.immersion->force()/dimensionedScalar("rho", dimDensity, 1)
    );
    variableViscosity viscosity(U, *sphere.immersion);
    for (label pass = 0; pass < 5; ++pass)
    {
        fvVectorMatrix UEqn(viscosity.stress(nu) - acceleration);
        UEqn.lower();       // as in rbcIbFoam
        viscosity.solve(UEqn, 0*acceleration);
    }

    // Of the inside, in mesh cells away from the layer
    const point middle(1e-5*vector::one + testInterior::shift());
    vector angularMomentum(Zero);
    symmTensor inertia(Zero);
    forAll(U, celli)
    {
        const vector r(mesh.cellCentres()[celli] - middle);
        if (mag(r) < radius - 1.6e-6)
        {
            angularMomentum += r ^ U[celli];
            inertia += magSqr(r)*symmTensor::I - sqr(r);
        }
    }
    reduce(angularMomentum, sumOp<vector>());
    reduce(inertia, sumOp<symmTensor>());
    ofInside = inv(inertia) & angularMomentum;

    sphere.immersion->sample(U, sphere.ghosts);
    const vectorField u(sphere.sampled());
    sphere.immersion->sampleShear(U, sphere.ghosts, mu);
    const vectorField t(mu*sphere.sampled());
    if (Pstream::master())
    {
        const clumpImage& image = sphere.ghosts.images()[0];
        const vectorField S(sphere.types[0].surface().areaVectors(image.x));
        const scalarField h(sphere.immersion->widths(image, S));
        const surfaceKernel& K = sphere.immersion->kernel(0);
        scalar exact = 0;
        scalar second = 0;
        forAll(S, i)
        {
            const vector r(image.x[i] - middle);
            const vector f(image.force[i]/mag(S[i]));
            const vector n(normalised(r));
            const vector v
            (
                u[i] + 0.25*K.meanDistance(n)*h[i]*(1 + 1/ratio)/mu*f
              - K.correlation(n)*h[i]*(1 - 1/ratio)/mu*t[i]
            );
            stress += mag(S[i])*(t[i] & f);
            exact -= 0.5*mag(S[i])*magSqr(f);
            ofSurface += mag(S[i])*(r ^ v);
            second += 2.0/3.0*mag(S[i])*magSqr(r);
        }
        ofSurface /= second;
        stress /= exact;
    }
    masterToAll(ofSurface);
    masterToAll(stress);
}

}


TEST_CASE("viscosity ratio: what turns a sphere turns its inside with its surface",
    "[membrane][parallel]")
{
    // The inside turns as a rigid body, without stress: the mean shear stress on the
    // surface is half of the force on it, its velocity is the same for all ratios. With
    // twice the mesh cells in a radius, errors of the second order are divided by four
    const scalar ratio = GENERATE(0.2, 5.0, 20.0);
    INFO("ratio " << ratio);
    const turnedSphere small(ratio, 3e-6);
    const turnedSphere large(ratio, 6e-6);
    const scalar faster = mag(small.ofSurface)/mag(turnedSphere(1.01, 3e-6).ofSurface) - 1;
    const scalar fasterFine =
        mag(large.ofSurface)/mag(turnedSphere(1.01, 6e-6).ofSurface) - 1;
    const scalar apart = mag(small.ofInside)/mag(small.ofSurface) - 1;
    const scalar apartFine = mag(large.ofInside)/mag(large.ofSurface) - 1;

    CHECK(mag(fasterFine) < 0.02);
    CHECK(mag(faster) > 3.5*mag(fasterFine));
    CHECK(mag(apartFine) < 0.05*max(1.0, 1/ratio));
    CHECK(mag(apart) > 3*mag(apartFine));

    // Stresses in the first order
    CHECK(large.stress == Approx(1).margin(0.3));
    CHECK(mag(1 - small.stress) > 1.7*mag(1 - large.stress));
}


TEST_CASE("viscosity ratio: off where it is one", "[membrane][serial]")
{
    const testInterior sphere(List<point>(1, point(10e-6, 10e-6, 10e-6)), 1);
    CHECK(!sphere.immersion->interior());
    CHECK_THROWS
    (
        testInterior(List<point>(1, point(10e-6, 10e-6, 10e-6)), -1)
    );
}
