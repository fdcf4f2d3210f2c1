/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "clumpMotion.H"
#include "fluidCoupling.H"
#include "testCloud.H"
#include "mathematicalConstants.H"

using namespace Foam;

TEST_CASE("boundary: the solid volume is that of the union", "[boundary]")
{
    // In the middle, and across the corner of all periodic directions
    const point centre = GENERATE
    (
        point(10e-6, 10e-6, 10e-6), point(0.3e-6, 7.1e-6, 19.6e-6)
    );
    const testCloud t(centre);
    const scalar V =
        gSum(t.boundary().solidFraction().primitiveField()*testMesh().V());

    CHECK(V == Approx(t.type().volume()).epsilon(0.002));
}


TEST_CASE("boundary: a rigid motion is imposed to round-off", "[boundary]")
{
    const vector omega = GENERATE(vector(0, 0, 70), vector(70, 40, -20));
    const point centre(0.3e-6, 7.1e-6, 19.6e-6);
    const vector u(1e-3, 2e-3, -1e-3);
    testCloud t(centre, u, omega);

    const fvMesh& mesh = testMesh();
    const vector span(20e-6, GREAT, 20e-6);
    scalar worst = 0, dilation = 0;
    label solid = 0;

    forAll(mesh.C(), celli)
    {
        if (t.boundary().strength()[celli] > 0)
        {
            vector r(mesh.C()[celli] - centre);
            r.x() -= span.x()*std::round(r.x()/span.x());
            r.z() -= span.z()*std::round(r.z()/span.z());

            const vector exact(u + (omega ^ r));
            worst = max
            (
                worst, mag(t.boundary().solidVelocity()[celli] - exact)
            );
            dilation = max(dilation, mag(t.boundary().dilation()[celli]));
            ++solid;
        }
    }
    CHECK(returnReduce(worst, maxOp<scalar>()) < 1e-12*mag(u));

    // A rigid motion does not dilate
    CHECK(returnReduce(dilation, maxOp<scalar>()) < 1e-10*mag(omega));
    CHECK(returnReduce(solid, sumOp<label>()) > 100);
}


TEST_CASE("boundary: third law, and forces the transpose of velocities", "[boundary][adjoint]")
{
    const word rotation = GENERATE(word("perSphere"), word("wholeClump"));
    const word forcing = GENERATE(word("sharp"), word("continuous"));
    testCloud t
    (
        point(0.3e-6, 7.1e-6, 19.6e-6), vector(1e-3, 0, 0), vector(30, 20, 10),
        rotation, true, forcing
    );
    t.deform(0.1);

    const fvMesh& mesh = testMesh();
    const scalar rho = 1025;

    // Any flow and pressure
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
        U[celli] = 1e-3*vector
        (
            Foam::sin(x.y() + x.z()), Foam::cos(x.x()), Foam::sin(x.x()*x.y())
        );
        p[celli] = 1e-3*Foam::cos(x.x() + 2*x.y() - x.z());
    }

    t.immerse();
    const volVectorField us(t.boundary().solidVelocity());
    const scalarField S(t.boundary().strength());
    t.cloud().gather(U, p);

    const vector onFluid(t.boundary().forceOnFluid(U, rho));
    const vector onClump(t.sumForces());
    CHECK(mag(onFluid) > 0);
    CHECK(mag(onFluid + onClump) < 1e-12*mag(onFluid));

    // Power for other velocities, particle side and fluid side
    const scalar size = t.sumMagForces()*1e-3;
    t.changeVelocities();
    const scalar particleSide = t.power();
    t.immerse();

    const scalarField V(mesh.V());
    const scalar fluidSide = gSum
    (
        rho*V
       *(
            S*
            (
                (U.primitiveField() - us.primitiveField())
              & t.boundary().solidVelocity().primitiveField()
            )
          - p.primitiveField()*t.boundary().dilation().primitiveField()
        )
    );
    CHECK(mag(particleSide - fluidSide) < 1e-11*size);
}


TEST_CASE("boundary: the pressure's level does no work on a clump", "[boundary][adjoint]")
{
    // Deformed, across the corner of all periodic directions
    testCloud t(point(0.3e-6, 7.1e-6, 19.6e-6));
    t.deform(0.1);
    t.changeVelocities();
    t.immerse();

    const fvMesh& mesh = testMesh();
    const scalarField V(mesh.V());
    const scalarField& Q = t.boundary().dilation().primitiveField();
    CHECK(mag(gSum(V*Q)) < 1e-13*gSum(V*mag(Q)));

    // Forces of a uniform pressure of 1 kPa, over those of the same gradients
    const volVectorField U
    (
        IOobject("U", testTime().timeName(), mesh),
        mesh, dimensionedVector(dimVelocity, Zero)
    );
    volScalarField p
    (
        IOobject("p", testTime().timeName(), mesh),
        mesh, dimensionedScalar(sqr(dimVelocity), Zero)
    );
    t.cloud().gather(U, p);
    const scalar without = t.sumMagForces();
    const scalar power = t.power();

    p = dimensionedScalar("p", sqr(dimVelocity), 1);
    t.cloud().gather(U, p);
    const scalar area = 4*constant::mathematical::pi*sqr(t.type().reach());
    CHECK(mag(t.sumMagForces() - without) < 1e-13*1025*area);
    CHECK(mag(t.power() - power) < 1e-13*1025*area*1e-3);
}


TEST_CASE("boundary: the fluid is coupled with a clump in the middle of its step",
    "[boundary]")
{
    // The centre of the solid volume, before and with the motion; half a mesh cell
    const scalar dt = testTime().deltaTValue();
    const vector way(0.4e-6, 0.3e-6, -0.2e-6);
    testCloud t(point(9e-6, 10e-6, 11e-6), 2/dt*way, Zero);
    const auto centre = [&]
    {
        const scalarField V
        (
            t.boundary().solidFraction().primitiveField()*testMesh().V()
        );
        return vector(gSum(V*testMesh().C().primitiveField())/gSum(V));
    };
    const vector before(centre());
    t.immerse(true);
    CHECK(mag(centre() - before - way) < 0.01*mag(way));

    // In a mesh that slides with it, it stays
    t.cloud().slideMesh(2/dt*way);
    t.immerse(true);
    CHECK(mag(centre() - before) < 1e-6*mag(way));
}


TEST_CASE("boundary: two clumps in a cell share it", "[boundary]")
{
    // The second one overlaps the first by half a radius
    testCloud t(point(10e-6, 10e-6, 10e-6));
    t.add(point(10e-6, 10e-6, 13e-6));
    t.immerse();

    CHECK
    (
        gMax(t.boundary().solidFraction().primitiveField())
     == Approx(1).epsilon(1e-12)
    );
}


TEST_CASE("boundary: the order of the clumps does not matter", "[boundary]")
{
    const word forcing = GENERATE(word("sharp"), word("continuous"));

    // Two overlapping spheres of different radii
    PtrList<clumpType> types(2);
    clumpImage images[2];
    forAll(types, a)
    {
        const scalar r = a ? 1.5e-6 : 2.5e-6;
        dictionary dict(cellDict());
        dict.set
        (
            "shape",
            dictOf
            (
                "type chain; nSpheres 1; sphereRadius " + Foam::name(r) + ";"
            )
        );
        types.set(a, new clumpType("sphere" + Foam::name(a), dict));

        clumpImage& image = images[a];
        image.typeId = a;
        image.x = pointField(1, point(10e-6 + a*3.3e-6, 10e-6, 9.7e-6));
        image.u = vectorField(1, vector(1e-3, a*1e-3, 0));
        image.omega = vectorField(1, vector(0, 0, a*100));
        image.box = boundBox
        (
            image.x[0] - r*vector::one, image.x[0] + r*vector::one
        );
        image.clearForces();
    }

    immersedBoundary boundary
    (
        testMesh(), types,
        dictOf
        (
            "solidFraction { type tetClipping; }"
            "forcing { type " + forcing + "; }"
            "hydrodynamicForce { type momentumExchange; }"
            "interiorDilation no;"
        )
    );
    const volScalarField nu(uniformViscosity());

    List<clumpImage> order({images[0], images[1]});
    boundary.update(order, nu);
    boundary.impose(order);
    const scalarField S(boundary.strength());
    const vectorField us(boundary.solidVelocity());

    order = {images[1], images[0]};
    boundary.update(order, nu);
    boundary.impose(order);
    const scalarField dS(boundary.strength().primitiveField() - S);
    const vectorField du(boundary.solidVelocity().primitiveField() - us);

    CHECK(gMax(mag(dS)) < 1e-12*gMax(S));
    CHECK(gMax(mag(du)) < 1e-12*gMax(mag(us)));
}


TEST_CASE
(
    "boundary: flux of the sharp forcing to a wall between two centres",
    "[boundary][serial]"
)
{
    const scalar part = GENERATE(0.03, 0.4, 0.97);
    const scalar radius = 3e-6;
    const scalar nu = 1.171e-6;
    const fvMesh& mesh = testMesh();

    // A sphere whose surface cuts the line along x at a part of it
    const label celli = mesh.findCell(point(10.1e-6, 10.1e-6, 10.1e-6));
    const scalar dx = Foam::cbrt(mesh.V()[celli]);
    const point& x = mesh.C()[celli];

    dictionary dict(cellDict());
    dict.set("shape", dictOf("type chain; nSpheres 1; sphereRadius 3e-6;"));
    PtrList<clumpType> types(1);
    types.set(0, new clumpType("sphere", dict));

    clumpImage image;
    image.typeId = 0;
    image.x = pointField(1, x - vector(radius + part*dx, 0, 0));
    image.u = vectorField(1, Zero);
    image.omega = vectorField(1, Zero);
    image.box = boundBox
    (
        image.x[0] - radius*vector::one, image.x[0] + radius*vector::one
    );
    image.clearForces();

    immersedBoundary boundary
    (
        mesh, types,
        dictOf
        (
            "solidFraction { type tetClipping; }"
            "forcing { type sharp; displacement 0; }"
            "hydrodynamicForce { type momentumExchange; }"
            "interiorDilation no;"
        )
    );
    const volScalarField viscosity(uniformViscosity(mesh, nu));
    List<clumpImage> images(1, image);
    boundary.update(images, viscosity);

    // With the flux the mesh has already: nu/(part dx) over the cell's width
    CHECK
    (
        boundary.strength()[celli] + nu/sqr(dx)
     == Approx(nu/(part*sqr(dx))).epsilon(1e-9)
    );
}


TEST_CASE("boundary: a clump of many spheres is as one of few", "[boundary][serial]")
{
    // Many are found in a grid, and have no weight far away: beside a chain of 32 a
    // sphere more, far from it, changes nothing there
    const word fraction = GENERATE(word("signedDistance"), word("tetClipping"));
    const fvMesh& mesh = testMesh();
    const scalar radius = 1.1e-6;
    List<scalarField> fractions(2), strengths(2);
    List<vectorField> velocities(2);
    pointField x(33);
    vectorField u(33), omega(33);
    Random random(9);
    forAll(x, i)
    {
        x[i] = point(2.1e-6 + 0.5e-6*i, 6e-6 + 2e-6*Foam::sin(0.3*i), 5.3e-6);
        u[i] = 1e-3*randomVector(random);
        omega[i] = 100*randomVector(random);
    }
    x[32] = point(9.7e-6, 16e-6, 17e-6);

    for (const label more : {0, 1})
    {
        const label n = 32 + more;
        dictionary dict(cellDict());
        dict.set
        (
            "shape",
            dictOf
            (
                "type chain; nSpheres " + Foam::name(n)
              + "; sphereRadius 1.1e-6; spacing 0.5e-6;"
            )
        );
        PtrList<clumpType> types(1);
        types.set(0, new clumpType("chain", dict));

        clumpImage image;
        image.typeId = 0;
        image.x = SubList<point>(x, n);
        image.u = SubList<vector>(u, n);
        image.omega = SubList<vector>(omega, n);
        image.box = boundBox(image.x, false);
        image.box.min() -= radius*vector::one;
        image.box.max() += radius*vector::one;
        image.clearForces();

        immersedBoundary boundary
        (
            mesh, types,
            dictOf
            (
                "solidFraction { type " + fraction + "; }"
                "forcing { type sharp; }"
                "hydrodynamicForce { type momentumExchange; }"
                "interiorDilation no;"
            )
        );
        const volScalarField viscosity(uniformViscosity(mesh));
        List<clumpImage> images(1, image);
        boundary.update(images, viscosity);
        boundary.impose(images);
        fractions[more] = boundary.solidFraction().primitiveField();
        strengths[more] = boundary.strength().primitiveField();
        velocities[more] = boundary.solidVelocity().primitiveField();
    }

    label nForced = 0, nOfTheOther = 0;
    scalar worst = 0;
    forAll(fractions[0], celli)
    {
        if (mag(mesh.C()[celli] - x[32]) < 4e-6)
        {
            nOfTheOther += strengths[1][celli] > 0;
            continue;
        }
        nForced += strengths[0][celli] > 0;
        worst = max(worst, mag(fractions[1][celli] - fractions[0][celli]));
        worst = max
        (
            worst,
            mag(strengths[1][celli] - strengths[0][celli])/max(strengths[0])
        );
        worst = max
        (
            worst,
            mag(velocities[1][celli] - velocities[0][celli])/max(mag(u))
        );
    }
    CHECK(nForced > 50);
    CHECK(nOfTheOther > 5);
    CHECK(worst < 1e-12);
}


TEST_CASE("boundary: every solid fraction with every forcing", "[boundary][serial]")
{
    // NOTE: new models of both kinds need a word here
    const word fraction = GENERATE
    (
        word("fullCells"), word("signedDistance"), word("tetClipping"),
        word("smoothFraction")
    );
    const word forcing = GENERATE
    (
        word("continuous"), word("sharp")
    );
    testCloud t
    (
        point(0.3e-6, 7.1e-6, 19.6e-6), vector(1e-3, 0, 0), Zero, "wholeClump", true,
        forcing, fraction
    );

    // Solid in the middle of a sphere, whose velocity is the cell's
    const scalarField& S = t.boundary().strength();
    const label deepest = findMax(S);
    CHECK(gMin(S) >= 0);
    CHECK(gMax(t.boundary().solidFraction().primitiveField()) == Approx(1));
    CHECK
    (
        mag(t.boundary().solidVelocity()[deepest] - vector(1e-3, 0, 0)) < 1e-15
    );
}


TEST_CASE
(
    "immersedBoundary: what stands still is not found anew, what moves is",
    "[immersedBoundary]"
)
{
    testCloud t(point(10e-6, 9e-6, 8e-6), vector(1e-3, 2e-3, 0));
    const scalarField first(t.boundary().strength().primitiveField());

    t.immerse();
    CHECK(gMax(mag(t.boundary().strength().primitiveField() - first)) == 0);

    const auto shift = [&](const vector& d)
    {
        for (clumpParcel& p : t.cloud())
        {
            p.state().x += d;
        }
        t.immerse();
    };
    shift(vector(0.4e-6, 0, 0));
    CHECK(gMax(mag(t.boundary().strength().primitiveField() - first)) > 0);

    testCloud there(point(10.4e-6, 9e-6, 8e-6), vector(1e-3, 2e-3, 0));
    const scalarField difference
    (
        t.boundary().strength().primitiveField()
      - there.boundary().strength().primitiveField()
    );
    CHECK(gMax(mag(difference)) < 1e-6*gMax(first));
}


TEST_CASE("boundary: a clump leaves nothing where it was", "[boundary]")
{
    testCloud t(point(10e-6, 9e-6, 8e-6), vector(1e-3, 2e-3, 0));
    t.deform(0.1);
    t.changeVelocities();
    t.immerse();
    CHECK(gMax(mag(t.boundary().dilation().primitiveField())) > 0);

    for (clumpParcel& p : t.cloud())
    {
        p.state().x += vector(2e-6, 0, 0);
    }
    t.immerse();

    const scalarField& S = t.boundary().strength();
    const scalarField& fraction = t.boundary().solidFraction();
    label nLeft = 0;
    forAll(S, celli)
    {
        const bool touched =
            mag(t.boundary().solidVelocity()[celli]) > 0
         || mag(t.boundary().dilation()[celli]) > 0;
        nLeft += touched && S[celli] == 0 && fraction[celli] == 0;
    }
    CHECK(returnReduce(nLeft, sumOp<label>()) == 0);
}


TEST_CASE("boundary: what is given back accelerates the solid mesh cells", "[boundary]")
{
    // Their centre of volume is not that of the clump
    const point centre(10.3e-6, 9.1e-6, 10.6e-6);
    const vector a(1, 2, -3), alpha(4e5, -1e5, 2e5);
    testCloud t(centre);
    const scalar dt = testTime().deltaTValue();
    vector force(Zero), torque(Zero), at(Zero);
    for (clumpParcel& p : t.cloud())
    {
        const pointField& x = p.state().x;
        at += p.position();
        externalForces before(x.size()), after(x.size());
        t.cloud().coupling().addForces(p, dt, before);
        p.step().imposedU += dt*(a + (alpha ^ x));
        p.step().imposedW += dt*alpha;
        t.cloud().coupling().addForces(p, dt, after);
        const vectorField f(after.f - before.f);
        force += sum(f);
        torque += sum(x ^ f) + sum(after.t - before.t);
    }
    reduce(at, sumOp<vector>());
    reduce(force, sumOp<vector>());
    reduce(torque, sumOp<vector>());

    vector rate(Zero), angular(Zero), moment(Zero);
    const fvMesh& mesh = testMesh();
    forAll(mesh.C(), celli)
    {
        if (t.boundary().strength()[celli]*dt > 500)
        {
            const vector r(mesh.C()[celli] - at);
            const vector ofCell(1025*mesh.V()[celli]*(a + (alpha ^ r)));
            rate += ofCell;
            angular += r ^ ofCell;
            moment += 1025*mesh.V()[celli]*(r ^ a);
        }
    }
    reduce(rate, sumOp<vector>());
    reduce(angular, sumOp<vector>());
    reduce(moment, sumOp<vector>());
    CHECK(mag(force - rate)/mag(rate) < 1e-10);
    CHECK(mag(torque - angular)/mag(angular) < 1e-10);
    CHECK(mag(moment)/mag(angular) > 1e-3);
}


TEST_CASE("boundary: the factor on the coupling coefficient has a limit", "[boundary][coupling]")
{
    // A flow that turns round in every pass, and grows
    testCloud t(point(10e-6, 10e-6, 10e-6));
    scalar speed = 1e-6, largest = 0;
    for (label pass = 0; pass < 20; ++pass)
    {
        speed *= -3;
        t.correct(vector(speed, 0, 0));
        t.cloud().imposeEnd();
        largest = max(largest, t.couplingFactor());
    }
    CHECK(largest == 1024);

    // More damping does not help: only a shorter step may
    CHECK(t.cloud().motion().needsShorterStep());
}


TEST_CASE("boundary: a coefficient that is too small is raised", "[boundary][coupling]")
{
    // In a flow of (1 - a) u the force of the fluid on a clump with the velocity u is
    // -a C u: as if the resistance were 5 times the coefficient
    const point centre(10e-6, 10e-6, 10e-6);
    const vector start(1e-3, 0, 0);
    testCloud t(centre, start);
    t.correct(Zero);
    const scalar C = -t.sumForces().x()/start.x();
    const scalar dt = testTime().deltaTValue();
    const scalarField& r = t.type().radii();
    const scalar z =
        6*constant::mathematical::pi*1025*1.171e-6
       *sum(r*(1 + r/Foam::sqrt(1.171e-6*dt)));
    scalar inside = 0;
    for (const clumpParcel& p : t.cloud())
    {
        inside += sum(p.step().solidVolumes);
    }
    reduce(inside, sumOp<scalar>());
    const scalar inertia = 1025*t.type().volume()/dt;
    const scalar a = (5*z + inertia + 1025*inside/dt)/C;

    // So slowly that no corrector overshoots; resists: part of a in every corrector
    const auto factors = [&](const scalarList& resists)
    {
        testCloud s(centre, start);
        scalarList result;
        for (const scalar part : resists)
        {
            vector u(Zero);
            for (const clumpParcel& p : s.cloud())
            {
                u = average(p.step().imposedU);
            }
            reduce(u, sumOp<vector>());
            s.correct((1 - part*a)*u);
            result.append(s.couplingFactor());
            for (clumpParcel& p : s.cloud())
            {
                clumpStep& step = p.step();
                step.end.u = step.imposedU + 0.02*(step.end.u - step.imposedU);
            }
            s.cloud().imposeEnd();
        }
        return result;
    };
    // Raised before the clump is advanced; then the corrector takes back 2 %, because it
    // does not overshoot
    const scalarList raised(factors({1, 1, 1}));
    CHECK(raised[1] == 1);
    CHECK(raised[2] == Approx(0.98*5).epsilon(0.01));

    // What a neighbour does to the flow in one corrector is not resistance
    CHECK(factors({0, 0, 0.1, 0.1})[3] == 1);
}
