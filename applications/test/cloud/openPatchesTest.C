/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "fluidCoupling.H"
#include "testCloud.H"
#include "openPatches.H"

using namespace Foam;

namespace
{

//- A clump with a fade factor on the test mesh, and what it does to the fluid
class fadedClump
{
    PtrList<clumpType> types_;
    ghostExchange ghosts_;
    autoPtr<immersedBoundary> boundary_;
    const scalar fadeFactor_;


public:

    const scalar nu = 1.171e-6;

    fadedClump(const scalar fadeFactor, const word& forcing)
    :
        types_(1),
        ghosts_(testMesh()),
        fadeFactor_(fadeFactor)
    {
        types_.set(0, new clumpType("cell", cellDict()));
        boundary_.reset
        (
            new immersedBoundary
            (
                testMesh(), types_, dictOf
                (
                    "solidFraction { type tetClipping; } forcing { type "
                  + forcing + "; } hydrodynamicForce { type momentumExchange; }"
                    " interiorDilation yes;"
                )
            )
        );
    }

    //- Impose velocities that depend on a seed
    void impose(const label seed)
    {
        Random random(seed);
        clumpState s(types_[0], rotation(vector(0.3, 0.2, 0.1)));
        disturb(types_[0], s, 0.1, random);

        // On the processor that has the middle
        const point centre(10e-6, 9e-6, 8e-6);
        const label celli = testCell(centre);
        const bool mine = celli >= 0;
        UList<clumpImage>& own = ghosts_.own(mine ? 1 : 0);
        if (mine)
        {
            const clumpParcel p(testMesh(), centre, celli, 0, s);
            own[0].set(p, types_[0], s, 0);
            own[0].fadeFactor = fadeFactor_;
            forAll(own[0].u, i)
            {
                own[0].u[i] = 1e-3*randomVector(random);
                own[0].omega[i] = 100*randomVector(random);
            }
        }
        ghosts_.update();
        const volScalarField viscosity(uniformViscosity(testMesh(), nu));
        boundary_->update(ghosts_.images(), viscosity);
        ghosts_.returnConstraints();
        for (label i = 0; i < ghosts_.nOwn(); ++i)
        {
            clumpImage& image = ghosts_.images()[i];
            image.contraction = image.constraint.contraction(image.u, image.omega);
        }
        ghosts_.updateVelocities();
        boundary_->impose(ghosts_.images());
    }

    //- Sum and power of the forces of a flow on the clump, whole ones divided
    //  by nothing
    void integrate
    (
        const volVectorField& U,
        const volScalarField& p,
        vector& force,
        scalar& power
    )
    {
        const volScalarField viscosity(uniformViscosity(testMesh(), nu));
        boundary_->integrate(U, p, viscosity, 1025, ghosts_.images());
        ghosts_.returnForces();
        force = Zero;
        power = 0;
        for (label i = 0; i < ghosts_.nOwn(); ++i)
        {
            clumpImage& image = ghosts_.images()[i];
            image.fluid.constrain(image.constraint);
            force += sum(image.fluid.f);
            power += image.fluid.power(image.u, image.omega);
        }
        reduce(force, sumOp<vector>());
        reduce(power, sumOp<scalar>());
    }

    const immersedBoundary& boundary() const { return *boundary_; }
    const clumpType& type() const { return types_[0]; }

    //- Integral of the strength [m3/s]
    scalar strength() const
    {
        return gSum(testMesh().V()*boundary_->strength().primitiveField());
    }
};

}


TEST_CASE("open patches: gap and fade factor of a sphere", "[openPatches]")
{
    const scalar r = 2e-6;
    const scalar L = 8e-6;

    // In front of the patch, behind it, beside it
    CHECK(openPatches::gap(5e-6, 1, r) == Approx(3e-6));
    CHECK(openPatches::gap(-1e-6, 1, r) == Approx(-3e-6));
    CHECK(openPatches::gap(5e-6, 0, r) > 1);

    // At a height h over the plane of a patch whose rim is s away, a clump that passes
    // in a branch beside it never feels it where s is half its length and radius
    const scalar s = 0.5*(L + r);
    for (scalar h = 0.1e-6; h < 20e-6; h += 0.1e-6)
    {
        const scalar d = Foam::sqrt(sqr(h) + sqr(s));
        CHECK(openPatches::gap(d, h/d, r) > L);
    }

    // Nothing at the patch, all beyond the length, and smooth in between
    CHECK(openPatches::fadeFactor(-1e-6, L) == Approx(1e-3));
    CHECK(openPatches::fadeFactor(0, L) == Approx(1e-3));
    CHECK(openPatches::fadeFactor(L, L) == 1);
    CHECK(openPatches::fadeFactor(2*L, L) == 1);
    scalar before = 1e-3;
    for (scalar gap = 0; gap <= L; gap += 0.01*L)
    {
        const scalar phi = openPatches::fadeFactor(gap, L);
        CHECK(phi >= before);
        CHECK(phi - before < 0.0151);
        before = phi;
    }
}


TEST_CASE("open patches: a porous sphere has the drag that its fade factor says",
    "[openPatches]")
{
    // Brinkman's drag over Stokes' for the strength that immersedBoundary gives
    for (scalar phi = 0.01; phi < 1; phi += 0.01)
    {
        const scalar b2 = 4.5*phi/(1 - phi);
        const scalar t = 1 - Foam::tanh(Foam::sqrt(b2))/Foam::sqrt(b2);
        const scalar drag = 2*b2*t/(2*b2 + 3*t);
        CHECK(drag == Approx(phi).epsilon(0.11));
    }
}


TEST_CASE("open patches: what a clump loses the fluid gains, at any fade factor",
    "[openPatches]")
{
    const word forcing = GENERATE(word("sharp"), word("continuous"));
    const scalar fadeFactor = GENERATE(1.0, 0.4, 1e-3);

    const fvMesh& mesh = testMesh();
    volVectorField U
    (
        IOobject("U", testTime().timeName(), mesh),
        mesh, dimensionedVector(dimVelocity, Zero)
    );
    volScalarField p
    (
        IOobject("p", testTime().timeName(), mesh),
        mesh, dimensionedScalar(sqr(dimVelocity), Zero)
    );
    forAll(U, celli)
    {
        const vector x(3e5*mesh.C()[celli]);
        U[celli] = 1e-3*vector(Foam::sin(x.y()), Foam::cos(x.x()), Foam::sin(x.z()));
        p[celli] = 1e-3*Foam::cos(x.x() + 2*x.y() - x.z());
    }

    fadedClump clump(fadeFactor, forcing);
    clump.impose(3);
    vector force;
    scalar power;
    clump.integrate(U, p, force, power);

    const immersedBoundary& b = clump.boundary();
    const vector onFluid(b.forceOnFluid(U, 1025));
    CHECK(mag(onFluid) > 0);
    CHECK(mag(onFluid + force) < 1e-12*mag(onFluid));

    const scalarField V(mesh.V());
    const vectorField& us = b.solidVelocity().primitiveField();
    const scalarField& Q = b.dilation().primitiveField();
    const scalarField work
    (
        1025*V
       *(
            b.strength().primitiveField()*((U.primitiveField() - us) & us)
          - p.primitiveField()*Q
        )
    );
    CHECK(mag(power - gSum(work)) < 1e-11*gSum(mag(work)));
    CHECK(mag(gSum(V*Q)) < 1e-12*gSum(V*mag(Q)));

    // The solid that the fluid sees
    CHECK
    (
        gSum(V*b.solidFraction().primitiveField())
     == Approx(fadeFactor*clump.type().volume()).epsilon(0.02)
    );
}


TEST_CASE("open patches: the strength of a clump that fades", "[openPatches]")
{
    // From that of the forcing to that of a porous body, without a jump
    scalar before = GREAT;
    scalar jump = 0;
    for (const scalar phi : {1.0, 0.999, 0.99, 0.9, 0.5, 0.1, 0.01, 0.001})
    {
        fadedClump clump(phi, "sharp");
        clump.impose(3);
        const scalar strength = clump.strength();
        CHECK(strength < before);
        jump = before/strength;
        before = strength;

        // kappa is the resistance of a sphere of the same volume
        const scalar V = clump.type().volume();
        const scalar a = Foam::cbrt(0.75*V/constant::mathematical::pi);
        const scalar resistance = 6*constant::mathematical::pi*clump.nu*a;
        if (phi < 0.2)
        {
            CHECK(strength/resistance == Approx(phi).epsilon(0.02 + phi));
        }
    }
    CHECK(jump == Approx(10).epsilon(0.02));
}
