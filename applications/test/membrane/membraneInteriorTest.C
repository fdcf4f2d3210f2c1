/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "fvcDiv.H"
#include "mathematicalConstants.H"
#include "membraneInterior.H"
#include "surfaceImmersion.H"
#include "variableViscosity.H"

using namespace Foam;

namespace
{

//- The factor of spheres of 4 um in the test box, on all processors
struct interior
{
    PtrList<clumpType> types;
    dictionary dicts;
    ghostExchange ghosts;
    autoPtr<surfaceImmersion> immersion;

    interior(const UList<point>& centres, const scalar ratio)
    :
        types(1),
        ghosts(testMesh())
    {
        dictionary& dict = dicts.subDictOrAdd("test");
        dict = dictOf
        (
            "density 1000; membrane {} kernel threePoint; viscosityRatio "
          + Foam::name(ratio) + "; shape"
            " { type icosphere; subdivisions 3; radius 4e-6; }"
        );
        types.set(0, new clumpType("test", dict));
        immersion.reset(new surfaceImmersion(testMesh(), types, dicts));

        UList<clumpImage>& own =
            ghosts.own(Pstream::master() ? centres.size() : 0);
        forAll(own, k)
        {
            clumpImage& image = own[k];
            image.owner = Pstream::myProcNo();
            image.index = k;
            image.original = true;
            image.typeId = 0;
            image.id = labelPair(0, k);
            image.x =
                types[0].centres() + centres[k] + vector(0.13e-6, 0.27e-6, 0.41e-6);
            image.u = vectorField(image.x.size(), Zero);
            image.omega = image.u;
            image.force = image.u;
            image.box = boundBox(image.x, false);
            image.reach = 4.4e-6;
            image.clearForces();
        }
        ghosts.update();
        immersion->update(ghosts);
    }

    const volScalarField& factor() const { return immersion->interior()->factor(); }
};

}


TEST_CASE("viscosity ratio: the inside has its volume", "[membrane][parallel]")
{
    // In the middle, and across periodic patches and processors
    const point centre = GENERATE
    (
        point(10e-6, 10e-6, 10e-6), point(0.5e-6, 9e-6, 19e-6)
    );
    const scalar ratio = GENERATE(0.2, 5.0);
    const interior sphere(List<point>(1, centre), ratio);
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
    const interior spheres(centres, 0.2);
    const scalarField& f = spheres.factor().primitiveField();
    CHECK(gMin(f) > 0.1999);
    CHECK(gMax(f) < 1.0001);

    // In any order of the images, the layers between them are those of the nearer surface
    Swap(centres[0], centres[1]);
    const interior swapped(centres, 0.2);
    volVectorField U
    (
        IOobject("UTest", testMesh().time().timeName(), testMesh()), testMesh(),
        dimensionedVector(dimVelocity, Zero)
    );
    U.primitiveFieldRef() = tensor(0, 10, 0, -4, 0, 2, 0, 6, 0) & testMesh().cellCentres();
    const vectorField sheared(spheres.immersion->interior()->shear(U, 1)());
    const vectorField other(swapped.immersion->interior()->shear(U, 1)());
    CHECK(gMax(mag(sheared)()) > 1);
    CHECK(gMax(mag(sheared - other)()) < 1e-9);
}


TEST_CASE("viscosity ratio: the force that cancels the slip has no sum and no torque",
    "[membrane][parallel]")
{
    const point centre(10e-6, 10e-6, 10e-6);
    const fvMesh& mesh = testMesh();
    const interior sphere(List<point>(1, centre), 20);
    membraneInterior inside(mesh, sphere.types);
    PtrList<surfaceKernel> kernels(1);
    kernels.set(0, new surfaceKernel(surfaceKernel::form::threePoint));
    cellGeometry geometry(mesh);
    inside.set
    (
        sphere.ghosts.images(), kernels, geometry,
        vectorField(mesh.nCells(), 1e-6*vector::one)
    );

    // A torque on the surface and a force along x, smeared over the layer
    volVectorField force
    (
        IOobject("forceTest", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimForce/dimVolume, Zero)
    );
    const vectorField r(mesh.cellCentres() - centre);
    forAll(force, celli)
    {
        const scalar place = (mag(r[celli]) - 4e-6)/1e-6;
        force[celli] =
            kernels[0](place)*((vector(1, 2, 3) ^ r[celli]) + vector(3e-6, 0, 0));
    }
    const vectorField before(force);
    inside.addSlip(force);
    const vectorField change(mesh.V()*(force.primitiveField() - before));
    CHECK(gSum(mag(change)()) > 0.1*gSum(mesh.V()*mag(before)));
    CHECK(mag(gSum(change)) < 1e-12*gSum(mag(change)()));

    // The latter in the second order of the mesh: the radius is four mesh cells
    const vector torque(gSum((mesh.V()*(r ^ before))()));
    CHECK(mag(gSum((r ^ change)()))/mag(torque) < 0.02);
}


TEST_CASE("viscosity ratio: off where it is one", "[membrane][serial]")
{
    const interior sphere(List<point>(1, point(10e-6, 10e-6, 10e-6)), 1);
    CHECK(!sphere.immersion->interior());
    CHECK_THROWS
    (
        interior(List<point>(1, point(10e-6, 10e-6, 10e-6)), -1)
    );
}


TEST_CASE("surface kernels: the integral of the kernel", "[membrane][serial]")
{
    for (const word name : {"hat", "threePoint", "fourPoint"})
    {
        INFO(name);
        const surfaceKernel K(dictOf("kernel " + name + ";"));
        CHECK(K.beyond(0) == Approx(0.5));
        CHECK(K.beyond(-3) == 1);
        CHECK(K.beyond(3) == 0);
        const scalar h = 0.02;
        for (scalar r = -1.9; r < 1.9; r += 0.13)
        {
            CHECK(K.beyond(r) + K.beyond(-r) == Approx(1));
            CHECK
            (
                (K.beyond(r - h) - K.beyond(r + h))/(2*h)
             == Approx(K(r)).margin(0.02)
            );
        }
    }
}


TEST_CASE("surface kernels: what a layer lacks beside a sharp surface", "[membrane][serial]")
{
    for (const word name : {"hat", "threePoint", "fourPoint"})
    {
        INFO(name);
        const surfaceKernel K(dictOf("kernel " + name + ";"));
        CHECK(mag(K.deficit(1)) < 1e-12);
        CHECK(K.deficit(20) > K.deficit(5));

        // The same layer from either side, and of nearly equal fluids
        CHECK(K.deficit(5) == Approx(5*K.deficit(0.2)));
        scalar both = 0;
        for (scalar r = -2; r < 2; r += 0.01)
        {
            both += 0.01*K.beyond(r)*(1 - K.beyond(r));
        }
        CHECK(K.deficit(1.01) == Approx(1e-4*both).epsilon(0.02));
    }

    // Of hat 7/24, of threePoint from another program
    CHECK(surfaceKernel(dictOf("kernel hat;")).overlap() == Approx(7.0/24).epsilon(1e-4));
    CHECK
    (
        surfaceKernel(dictOf("kernel threePoint;")).overlap()
     == Approx(0.354386).epsilon(1e-4)
    );
}


TEST_CASE("variable viscosity: a rotation has no stress", "[membrane][parallel]")
{
    // Neither has any linear velocity where the viscosity is uniform; one that is
    // sheared has that of the gradient of the viscosity
    const fvMesh& mesh = testMesh();
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero), "fixedValue"
    );
    volScalarField nu
    (
        IOobject("nuTest", mesh.time().timeName(), mesh), mesh,
        dimensionedScalar("nu", dimViscosity, 1e-6)
    );
    const tensor shear(0, 10, 0, -4, 0, 2, 0, 6, 0);
    const vector slope(2e10, 6e9, -4e9);
    const point centre(1e-5*vector::one);
    const auto nuAt = [&](const point& x)
    {
        return 1/(6e5 + (slope & (x - centre)));
    };
    forAll(U, celli)
    {
        const point& x = mesh.cellCentres()[celli];
        U[celli] = shear & (x - centre);
        nu[celli] = nuAt(x);
    }
    U.correctBoundaryConditions();
    nu.correctBoundaryConditions();
    variableViscosity viscosity(U);
    const tmp<fvVectorMatrix> tstress(viscosity.stress(nu));
    const volVectorField force(tstress() & U);

    // div(nu (G + G^T)) = (G + G^T) . grad nu, of the mesh cell with these viscosities on
    // its faces; the box is periodic, the fields are not
    vectorField gradNu(mesh.nCells(), Zero);
    forAll(mesh.faces(), facei)
    {
        const vector part(nuAt(mesh.faceCentres()[facei])*mesh.faceAreas()[facei]);
        gradNu[mesh.faceOwner()[facei]] += part/mesh.V()[mesh.faceOwner()[facei]];
        if (mesh.isInternalFace(facei))
        {
            const label celli = mesh.faceNeighbour()[facei];
            gradNu[celli] -= part/mesh.V()[celli];
        }
    }
    forAll(U, celli)
    {
        const vector x(mesh.cellCentres()[celli]);
        if (mag(cmptMax(cmptMag(x - centre))) < 7.6e-6)
        {
            const vector expected((shear + shear.T()) & gradNu[celli]);
            CHECK(mag(force[celli] + expected) < 1e-6*mag(expected));
        }
    }
}


TEST_CASE("variable viscosity: the momentum equation is solved with all of it",
    "[membrane][parallel]")
{
    const fvMesh& mesh = testMesh();
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero), "fixedValue"
    );
    const interior sphere(List<point>(1, point(10e-6, 10e-6, 10e-6)), 5);
    const volScalarField nu
    (
        dimensionedScalar("nu", dimViscosity, 1e-6)*sphere.factor()
    );

    // A force that turns the inside
    volVectorField force
    (
        IOobject("forceTest", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimAcceleration, Zero)
    );
    const vector omega(10, 20, -30);
    forAll(force, celli)
    {
        const vector x(mesh.cellCentres()[celli] - point(10e-6, 10e-6, 10e-6));
        force[celli] = mag(x) < 4e-6 ? 1e8*(omega ^ x) : vector::zero;
    }
    variableViscosity viscosity(U);
    fvVectorMatrix UEqn(viscosity.stress(nu) - force);
    UEqn.lower();       // as in rbcIbFoam
    viscosity.solve(UEqn, 0*force);
    CHECK(viscosity.nPasses() < 20);

    // What is left, with the stress of the solution
    const tmp<fvVectorMatrix> tstress(viscosity.stress(nu));
    const volVectorField left((tstress() & U) - force);
    const scalar residual =
        Foam::sqrt(gSumMag(left.primitiveField())/gSumMag(force.primitiveField()));
    CHECK(residual < 0.15);
}
