/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCloud.H"
#include "contactWeights.H"
#include "contactModel.H"
#include "mathematicalConstants.H"

using namespace Foam;

namespace
{

const scalar r = 2e-6;

//- Centres of a ring of n spheres about z
pointField ringOf(const label n, const scalar R)
{
    pointField x(n);
    forAll(x, i)
    {
        const scalar angle = constant::mathematical::twoPi*i/n;
        x[i] = R*vector(Foam::cos(angle), Foam::sin(angle), 0);
    }
    return x;
}

struct pressed
{
    vector force;       // on A
    vector reaction;    // on B
    vector torque;      // of both about the origin
    scalar largest;     // of one pair
};

//- Two clumps of spheres of one radius under the Hertz law
pressed press
(
    const pointField& xA, const pointField& xB, const bool shared = true
)
{
    static const auto model
    (
        selectModel<contactModel>
        (
            dictOf("type hertz; reducedModulus 1000; restitution 1;")
        )
    );
    const auto touching = [](const pointField& x, const pointField& y)
    {
        DynamicList<contactWeights::pair> pairs;
        forAll(x, i)
        {
            forAll(y, j)
            {
                const vector d(x[i] - y[j]);
                if (mag(d) < 2*r)
                {
                    pairs.append({0, i, 1, j, d/mag(d), 2*r - mag(d), 1, 0});
                }
            }
        }
        return pairs;
    };

    // As the owner of each of them sees it
    pressed result{Zero, Zero, Zero, 0};
    const scalarField radiiA(xA.size(), r), radiiB(xB.size(), r);
    for (const bool first : {true, false})
    {
        const pointField& x = first ? xA : xB;
        auto pairs(first ? touching(xA, xB) : touching(xB, xA));
        if (shared && first)
        {
            contactWeights::set(pairs, xA, radiiA, xB, radiiB);
        }
        else if (shared)
        {
            contactWeights::set(pairs, xB, radiiB, xA, radiiA);
        }
        for (const contactWeights::pair& p : pairs)
        {
            const scalar depth = shared ? p.depth : p.overlap;
            const vector f
            (
                p.weight*model->force(depth, 0, r, r, 1, 1)*p.normal
            );
            (first ? result.force : result.reaction) += f;

            // Along the line of centres it has the same arm on both
            result.torque += x[p.i] ^ f;
            result.largest = max(result.largest, mag(f));
        }
    }
    return result;
}

//- Rings side by side on one axis, or in one plane, crown to crown
pressed faceToFace(const label n, const scalar R, const scalar d, const bool shared = true)
{
    const pointField x(ringOf(n, R));
    return press(x, x - vector(0, 0, 2*r - d), shared);
}

pressed edgeToEdge(const label n, const scalar R, const scalar d, const bool shared = true)
{
    const pointField x(ringOf(n, R));
    return press(x, x - vector(2*(R + r) - d, 0, 0), shared);
}

}


TEST_CASE("contact weights: a lone pair has the law to itself", "[contact][serial]")
{
    const pointField one(1, point::zero);
    const scalar d = 0.05*r;
    const vector f(press(one, pointField(1, point(2*r - d, 0, 0))).force);
    CHECK(mag(f) == Approx(4.0/3.0*1000*Foam::sqrt(0.5*r*d)*d));

    // Spheres that touch their neighbours in the clump, but for exp(-8)
    const pointField row({point(0, 0, 0), point(2*r, 0, 0), point(4*r, 0, 0)});
    const pointField other(row + vector(0, 0, 2*r - d));
    CHECK(mag(press(row, other).force) == Approx(3*mag(f)).epsilon(1e-3));
}


TEST_CASE("contact weights: as stiff for any number of spheres", "[contact][serial]")
{
    for (const scalar d : {0.02*r, 0.05*r, 0.1*r, 0.2*r})
    {
        for (const scalar R : {r, 1.5*r})
        {
            const scalar face = mag(faceToFace(64, R, d).force);
            const scalar edge = mag(edgeToEdge(64, R, d).force);
            const scalar alone = 4.0/3.0*1000*Foam::sqrt(0.5*r*d)*d;
            const scalar line =
                constant::mathematical::twoPi*R
               /(r*Foam::sqrt(constant::mathematical::piByTwo));

            // The patch of a deep contact is no longer small beside the kernel
            const scalar within = d > 0.15*r ? 0.12 : 0.08;

            INFO("overlap " << d/r << " radii, ring " << R/r << " radii");
            CHECK(face == Approx(line*alone).epsilon(within));
            CHECK(edge == Approx(alone).epsilon(within));

            for (const label n : {8, 10, 16, 32})
            {
                INFO
                (
                    n << " spheres: face to face "
                      << mag(faceToFace(n, R, d).force)/face
                      << " (unshared "
                      << mag(faceToFace(n, R, d, false).force)/face
                      << "), edge to edge "
                      << mag(edgeToEdge(n, R, d).force)/edge
                      << " (unshared "
                      << mag(edgeToEdge(n, R, d, false).force)/edge << ')'
                );
                CHECK(mag(faceToFace(n, R, d).force) == Approx(face).epsilon(within));
                CHECK(mag(edgeToEdge(n, R, d).force) == Approx(edge).epsilon(within));
            }
        }
    }
}


TEST_CASE("contact weights: action and reaction", "[contact][serial]")
{
    Random random(31);
    label met = 0;
    for (label k = 0; k < 50; ++k)
    {
        const label n = 6 + k % 20;
        pointField xA(ringOf(n, 1.2*r)), xB(ringOf(30 - n, 1.4*r));
        const tensor turn(randomRotation(random).R());
        const vector away(2.5*r*randomVector(random));
        forAll(xA, i)
        {
            xA[i] = (turn & xA[i]) + away + 0.2*r*randomVector(random);
        }
        const pressed p(press(xA, xB));
        CHECK(mag(p.force + p.reaction) <= 1e-12*p.largest);
        CHECK(mag(p.torque) <= 1e-12*p.largest*10*r);
        met += p.largest > 0 ? 1 : 0;
    }
    CHECK(met > 20);
}


TEST_CASE("contact weights: the force changes continuously", "[contact][serial]")
{
    // A ring slides over another, tilted one, so that pairs come and go
    const label n = GENERATE(8, 10, 16, 32);
    pointField xA(ringOf(n, 1.2*r)), xB(ringOf(n, 1.2*r));
    const tensor turn(rotation(vector(0.3, 0.2, 0.5)).R());
    forAll(xA, i)
    {
        xA[i] = (turn & xA[i]) + vector(0, 0, 1.95*r);
    }

    vector before(Zero);
    scalar jump = 0, largest = 0;
    const label nSteps = 4000;
    for (label k = 0; k <= nSteps; ++k)
    {
        const vector displacement(3*r*(2*scalar(k)/nSteps - 1), 0.1*r, 0);
        const vector f(press(xA + displacement, xB).force);
        jump = k ? max(jump, mag(f - before)) : 0;
        largest = max(largest, mag(f));
        before = f;
    }
    CHECK(largest > 0);
    CHECK(jump < 0.01*largest);
}


TEST_CASE("contact weights: as stiff on a wall", "[contact][walls][serial]")
{
    // Floor far larger than the ring
    const point a(-20e-6, -20e-6, 0), b(20e-6, -20e-6, 0);
    const point c(20e-6, 20e-6, 0), e(-20e-6, 20e-6, 0);
    const wallSurface floor(List<point>({a, c, b, a, e, c}));
    const auto model
    (
        selectModel<contactModel>
        (
            dictOf("type hertz; reducedModulus 1000; restitution 1;")
        )
    );
    const scalar d = 0.1*r, R = 1.2*r;
    const scalar alone = model->force(d, 0, r, 1);

    for (const label n : {8, 10, 16, 32, 64})
    {
        pointField flat(ringOf(n, R));
        pointField upright(n);
        forAll(flat, i)
        {
            upright[i] = point(flat[i].y(), 0, flat[i].x() + R + r - d);
            flat[i].z() = r - d;
        }

        const auto push = [&](const pointField& x)
        {
            vector f(Zero);
            boundBox around(x, false);
            around.min() -= r*vector::one;
            around.max() += r*vector::one;
            for
            (
                const auto& w : contactWeights::findWallContacts
                (
                    floor, floor.near(around), x, scalarField(n, r)
                )
            )
            {
                f += w.weight*w.wall.normal*model->force(w.depth, 0, r, 1);
            }
            return f;
        };
        // The lowest sphere of upright is at angle pi
        const vector lying(push(flat)), standing(push(upright));
        INFO(n << " spheres: lying " << lying.z()/alone << ", standing "
            << standing.z()/alone);
        CHECK
        (
            mag
            (
                lying
              - alone*vector(0, 0, 1)*constant::mathematical::twoPi*R
               /(r*Foam::sqrt(constant::mathematical::piByTwo))
            )
          < 0.06*mag(lying)
        );
        CHECK(mag(standing - alone*vector(0, 0, 1)) < 0.08*alone);
    }
}


TEST_CASE("contact weights: continuous where a second face begins",
    "[contact][walls][serial]")
{
    // The inside of a faceted tube: two faces that meet along y at an angle of 150 degrees
    const scalar L = 20e-6, z = L*Foam::tan(constant::mathematical::pi/6);
    const point a(0, -L, 0), b(0, L, 0);
    const point left(-L, -L, 0), farLeft(-L, L, 0), right(L, -L, z), farRight(L, L, z);
    const wallSurface edge
    (
        List<point>({left, b, a, left, farLeft, b, a, farRight, right, a, b, farRight})
    );

    // Three spheres of a clump roll towards the edge over the flat face
    const scalarField radii(3, r);
    const label nSteps = 4000;
    scalar before = 0, jump = 0, largest = 0;
    for (label k = 0; k <= nSteps; ++k)
    {
        const scalar x0 = (scalar(k)/nSteps - 1)*r;
        const pointField x
        ({
            point(x0, -r, 0.98*r), point(x0, 0, 0.97*r), point(x0, r, 0.98*r)
        });
        scalar force = 0;
        for
        (
            const auto& w
          : contactWeights::findWallContacts
            (
                edge, edge.near(boundBox(point(-L, -L, -L), point(L, L, L))), x, radii
            )
        )
        {
            force += w.weight*Foam::pow(w.depth/r, scalar(1.5));
        }
        jump = k ? max(jump, mag(force - before)) : 0;
        largest = max(largest, force);
        before = force;
    }
    INFO("largest change in a step over the largest force: " << jump/largest);
    CHECK(largest > 0);
    CHECK(jump < 0.003*largest);
}


TEST_CASE("contact weights: the cost of a long contact is linear",
    "[contact][walls][serial]")
{
    // Two bent chains side by side, and one of them on walls
    labelList nPairKernels(2), nWallKernels(2);
    for (const label twice : {0, 1})
    {
        const label n = twice ? 400 : 200;
        const scalarField radii(n, r);
        pointField x(n), y(n);
        List<contactWeights::pair> pairs;
        List<contactWeights::wallContact> contacts(n);
        DynamicList<contactWeights::pair> touching;
        forAll(x, i)
        {
            x[i] = r*vector(i, 3*Foam::sin(0.05*i), 0);
            y[i] = x[i] + r*vector(0, 0, 1.9 + 0.05*Foam::sin(scalar(i)));
            const scalar overlap = 0.01*r*(1.2 + Foam::cos(0.3*i));
            contacts[i] =
            {
                i, {vector(0, 0, 1), overlap, 1, 0}, symmTensor::zero, 0, 0
            };
        }
        forAll(x, i)
        {
            for (label j = max(i - 1, 0); j < min(i + 2, n); ++j)
            {
                // Some do not touch yet
                const vector d(x[i] - y[j]);
                touching.append({0, i, 1, j, d/mag(d), 2*r - mag(d), 1, 0});
            }
        }
        pairs = touching;

        nPairKernels[twice] = contactWeights::set(pairs, x, radii, y, radii);
        nWallKernels[twice] = contactWeights::setWallWeights(contacts, x, radii);

        // As the class says, over all
        scalar worst = 0;
        for (const contactWeights::pair& p : pairs)
        {
            scalar sum = 0, depth = 0;
            for (const contactWeights::pair& q : pairs)
            {
                const scalar W = Foam::exp
                (
                   -(magSqr(x[p.i] - x[q.i]) + magSqr(y[p.j] - y[q.j]))/sqr(r)
                );
                if (q.overlap > 0)
                {
                    sum += sqr(q.overlap)*W;
                    depth = max(depth, q.overlap*Foam::sqrt(W));
                }
            }
            const scalar weight =
                p.overlap > 0
              ? sqr(p.overlap)/sum : sqr(depth)/(sqr(depth) + sum);
            worst = max(worst, mag(p.weight - weight));
            worst = max
            (
                worst, mag(p.depth - (p.overlap > 0 ? depth : p.overlap))/r
            );
        }
        CHECK(worst < 1e-14);

        worst = 0;
        for (const contactWeights::wallContact& c : contacts)
        {
            scalar sum = 0, deepest = 0;
            for (const contactWeights::wallContact& d : contacts)
            {
                const scalar G =
                    sqr(d.wall.overlap)
                   *Foam::exp(-2*magSqr(x[c.i] - x[d.i])/sqr(r));
                sum += G;
                deepest = max(deepest, G);
            }
            worst = max(worst, mag(c.weight - sqr(c.wall.overlap)/sum));
            worst = max(worst, mag(c.depth - Foam::sqrt(deepest))/r);
        }
        CHECK(worst < 1e-14);
    }
    INFO
    (
        "kernels: pairs " << nPairKernels[0] << " and " << nPairKernels[1]
     << ", walls " << nWallKernels[0] << " and " << nWallKernels[1]
    );
    CHECK(nPairKernels[1] < 2.2*nPairKernels[0]);
    CHECK(nWallKernels[1] < 2.2*nWallKernels[0]);
}


TEST_CASE("contact weights: two rings of a cloud", "[contact][serial]")
{
    // The momentum that a ring gains in a short step
    const scalar d = 0.1*1.955e-6, D = 2*1.955e-6 - d;
    const scalar dt0 = testTime().deltaTValue();
    const scalar dt = 1e-10;
    scalar first = 0;

    for (const label n : {8, 16, 32})
    {
        OStringStream os;
        os.precision(15);
        os  << "placement { type list; clumps ("
            << "{ type cell; position (10e-6 10e-6 5e-6); }"
            << "{ type cell; position (10e-6 10e-6 " << 5e-6 + D << "); }); }"
            << "integrator { type implicitEuler; tolerance 1e-9;"
            << " maxIterations 100; }"
            << "contactModel { type hertz; reducedModulus 100; restitution 1; }"
            << "wallContactModel { type none; }"
            << "effects { fluid off; }";
        dictionary dict(dictOf(os.str()));
        dictionary types;
        types.add
        (
            "cell",
            cellDict
            (
                "type dampingRatio; beta 1500;",
                "type strainStiffening; stiffening 0.3;", n
            )
        );
        dict.add("types", types);

        testTime().setDeltaT(dt, false);
        openCloud cloud(testMesh(), dict);
        cloud.evolve();
        cloud.accept();
        testTime().setDeltaT(dt0, false);

        scalar gained = 0;
        vector total(Zero);
        for (const clumpParcel& p : cloud)
        {
            const vector impulse
            (
                cloud.type(p).mass()*p.state().velocity(cloud.type(p))
            );
            total += impulse;
            gained = max(gained, mag(impulse));
        }
        first = n == 8 ? gained : first;
        INFO(n << " spheres: " << gained/dt << " N");
        CHECK(gained > 0);
        CHECK(mag(total) < 1e-10*gained);
        CHECK(gained == Approx(first).epsilon(0.08));
    }
}
