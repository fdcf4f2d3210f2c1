/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "layerViscosity.H"
#include "mathematicalConstants.H"
#include "triangleElasticity.H"

using namespace Foam;

namespace
{

const scalar pi = constant::mathematical::pi;

using membrane = testMembrane;

//- Strained to (1 + e) along x and l2 along y
triangleElasticity::response stretched
(
    const triangleElasticity& law, const scalar l1, const scalar l2
)
{
    return law.law(sqr(l1) + sqr(l2) - 2, sqr(l1*l2) - 1);
}

//- Principal tensions [N/m]: dW/dl1 over l2
scalar tension
(
    const triangleElasticity& law, const scalar l1, const scalar l2
)
{
    const auto w = stretched(law, l1, l2);
    return (2*l1*w.W1 + 2*l1*sqr(l2)*w.W2)/l2;
}

}


TEST_CASE("membrane: forces are the gradient of the energy", "[membrane][serial]")
{
    const string models = GENERATE
    (
        "a { type neoHookean; shearModulus 2; }",
        "a { type skalak; shearModulus 2; areaRatio 3; }",
        "a { type surfaceArea; areaModulus 5; }",
        "a { type surfaceTension; tension 2; }",
        "a { type hookeSheet; shearModulus 2; poissonRatio 0.3; }",
        "a { type triangleArea; areaModulus 5; }",
        "a { type springNetwork; shearModulus 2; }",
        "a { type springNetwork; shearModulus 2; largestStretch 1.1; }",
        "a { type helfrich; bendingStiffness 0.3; }",
        "a { type helfrich; bendingStiffness 0.3; spontaneousCurvature -1.3; }",
        "a { type neoHookean; shearModulus 2; }"
        " b { type helfrich; bendingStiffness 0.3; }"
    );
    INFO(models);
    const membrane m(models);
    Random random(7);
    const pointField x(deformed(m.type, 0.1, random));
    checkForces(m.mechanics, x, random);
}


TEST_CASE("membrane: a rigid motion changes nothing", "[membrane][serial]")
{
    const membrane m
    (
        "a { type skalak; shearModulus 2; areaRatio 10; }"
        "b { type helfrich; bendingStiffness 1; }"
        "c { type surfaceArea; areaModulus 5; }",
        "type biconcave; diameter 2; subdivisions 2;"
    );
    Random random(3);
    const pointField x(deformed(m.type, 0.05, random));
    const tensor R(randomRotation(random).R());
    const pointField moved((R & x) + vector(3, 2, 1));

    CHECK(energy(m.mechanics, moved) == Approx(energy(m.mechanics, x)).epsilon(1e-12));
    const vectorField f(m.mechanics.forces(x));
    CHECK(max(mag(m.mechanics.forces(moved) - (R & f))) < 1e-11*max(mag(f)));
}


TEST_CASE("membrane: at rest without stress", "[membrane][serial]")
{
    const membrane m
    (
        "a { type skalak; shearModulus 2; areaRatio 10; }"
        "b { type neoHookean; shearModulus 1; }"
        "c { type surfaceArea; areaModulus 5; }",
        "type biconcave; diameter 2; subdivisions 2;"
    );
    CHECK(max(mag(m.mechanics.forces(m.type.centres()))) < 1e-13);
}


TEST_CASE("membrane: exact second derivatives", "[membrane][serial]")
{
    const string models = GENERATE
    (
        "a { type neoHookean; shearModulus 2; }",
        "a { type skalak; shearModulus 2; areaRatio 3; }",
        "a { type surfaceArea; areaModulus 5; }",
        "a { type surfaceTension; tension 2; }",
        "a { type hookeSheet; shearModulus 2; poissonRatio 0.3; }",
        "a { type triangleArea; areaModulus 5; }",
        "a { type springNetwork; shearModulus 2; }"
    );
    INFO(models);
    const membrane m(models);
    Random random(11);
    const pointField x(deformed(m.type, 0.1, random));
    const scalar p = 1.7;

    membraneTangent tangent(m.type.surface(), m.mechanics.neighbourOrder());
    vectorField unused(x.size(), Zero);
    tangent.clear(true);
    m.mechanics.add(x, unused, &tangent);
    tangent.addPressure(m.type.surface(), x, p);
    const auto forces = [&](const pointField& y)
    {
        return m.mechanics.forces(y) + p*m.type.surface().areaVectors(y);
    };

    const scalar h = 1e-6;
    for (label n = 0; n < 5; ++n)
    {
        vectorField v(x.size());
        for (vector& e : v)
        {
            e = randomVector(random);
        }
        const vectorField expected
        (
            (forces(x - h*v) - forces(x + h*v))/(2*h)
        );
        const Eigen::VectorXd Hv(tangent.times(membraneTangent::asVector(v)));
        const auto reference = membraneTangent::asVector(expected);
        CHECK((Hv - reference).norm() < 1e-6*reference.norm());
    }
}


TEST_CASE("membrane: the tangent leaves out what is negative", "[membrane][serial]")
{
    const string models = GENERATE
    (
        "a { type neoHookean; shearModulus 2; }",
        "a { type skalak; shearModulus 2; areaRatio 3; }",
        "a { type surfaceArea; areaModulus 5; }",
        "a { type surfaceTension; tension 2; }",
        "a { type hookeSheet; shearModulus 2; poissonRatio 0.3; }",
        "a { type triangleArea; areaModulus 5; }",
        "a { type springNetwork; shearModulus 2; }"
    );
    INFO(models);
    const membrane m(models);
    Random random(13);
    for (const scalar stretch : {0.7, 1.3})
    {
        const pointField x(stretch*deformed(m.type, 0.1, random));
        membraneTangent tangent(m.type.surface(), m.mechanics.neighbourOrder());
        vectorField unused(x.size(), Zero);
        m.mechanics.add(x, unused, &tangent);

        const scalar h = 1e-6;
        for (label n = 0; n < 10; ++n)
        {
            vectorField v(x.size());
            for (vector& e : v)
            {
                e = randomVector(random);
            }
            const vectorField exact
            (
                (m.mechanics.forces(x - h*v) - m.mechanics.forces(x + h*v))/(2*h)
            );
            const auto direction = membraneTangent::asVector(v);
            const scalar stiffness = direction.dot(tangent.times(direction));
            CHECK(stiffness > 0);
            CHECK(stiffness > direction.dot(membraneTangent::asVector(exact)) - 1e-5);
        }
    }
}


TEST_CASE("membrane: the bending tangent at the spontaneous curvature", "[membrane][serial]")
{
    // A sphere with the curvature that it wants: nothing is squared that is not small
    const membrane m
    (
        "a { type helfrich; bendingStiffness 0.3; spontaneousCurvature 2; }",
        "type icosphere; radius 1; subdivisions 3;"
    );
    const pointField& x = m.type.centres();
    membraneTangent tangent(m.type.surface(), m.mechanics.neighbourOrder());
    vectorField unused(x.size(), Zero);
    m.mechanics.add(x, unused, &tangent);

    // Of a smooth deformation
    vectorField v(x.size());
    forAll(v, i)
    {
        v[i] = x[i]*(sqr(x[i].z()) - sqr(x[i].x()));
    }
    const scalar h = 1e-5;
    const vectorField expected
    (
        (m.mechanics.forces(x - h*v) - m.mechanics.forces(x + h*v))/(2*h)
    );
    const auto direction = membraneTangent::asVector(v);
    const scalar work = direction.dot(membraneTangent::asVector(expected));
    CHECK(direction.dot(tangent.times(direction)) == Approx(work).epsilon(0.05));
}


TEST_CASE("membrane: uniaxial and biaxial stretching", "[membrane][serial]")
{
    const membrane any("a { type neoHookean; shearModulus 1; }");
    const closedSurface& surface = any.type.surface();
    const pointField& x0 = any.type.centres();

    // Small strains: surface Young's moduli 3 Gs and Gs (2 + 4 C)/(1 + C)
    const auto neoHookean = selectModel<membraneModel>
    (
        dictOf("type neoHookean; shearModulus 2;"), surface, x0
    );
    const auto skalak = selectModel<membraneModel>
    (
        dictOf("type skalak; shearModulus 2; areaRatio 3;"), surface, x0
    );
    for (const auto* model : {&neoHookean, &skalak})
    {
        const auto& law = dynamic_cast<const triangleElasticity&>(**model);
        const scalar C = 3;
        const scalar Y = model == &neoHookean ? 6 : 2*(2 + 4*C)/(1 + C);
        const scalar e = 1e-5;

        // The width at which there is no tension across
        scalar l1 = 1 + e, l2 = 1;
        for (label n = 0; n < 50; ++n)
        {
            const scalar h = 1e-7;
            const scalar slope =
                (tension(law, l2 + h, l1) - tension(law, l2 - h, l1))/(2*h);
            l2 -= tension(law, l2, l1)/slope;
        }
        CHECK(tension(law, l1, l2)/e == Approx(Y).epsilon(1e-4));

        // Equal stretches: the modulus of area, Gs (1 + 2 C) or 3 Gs, of 2 e
        const scalar K = model == &neoHookean ? 6 : 2*(1 + 2*C);
        CHECK(tension(law, 1 + e, 1 + e)/(2*e) == Approx(K).epsilon(1e-4));
    }

    // Uniaxial at any stretch: the incompressible sheet has l2 = 1/sqrt(l1)
    const auto& law = dynamic_cast<const triangleElasticity&>(*neoHookean);
    for (const scalar l1 : {0.7, 1.2, 1.6, 2.5})
    {
        const scalar l2 = 1/Foam::sqrt(l1);
        CHECK(mag(tension(law, l2, l1)) < 1e-12);
        CHECK
        (
            tension(law, l1, l2)
         == Approx(2*(pow3(l1) - 1)/Foam::pow(l1, 1.5)).epsilon(1e-12)
        );
    }
}


TEST_CASE("membrane: viscous forces are the gradient of their potential", "[membrane][serial]")
{
    const membrane m("a { type surfaceViscosity; viscosity 2; }");
    Random random(17);
    const pointField x(deformed(m.type, 0.1, random));
    vectorField u(x.size());
    for (vector& v : u)
    {
        v = randomVector(random);
    }
    const membraneModel::motion start{x - 0.05*u, 0.05, {}};
    const auto potential = [&](const pointField& y, membraneTangent* tangent = nullptr)
    {
        vectorField unused(y.size(), Zero);
        return m.mechanics.add(y, unused, tangent, &start);
    };
    const vectorField f(m.mechanics.forces(x, &start));
    membraneTangent tangent(m.type.surface(), m.mechanics.neighbourOrder());
    tangent.clear(true);
    potential(x, &tangent);
    const scalar h = 1e-6;
    for (label n = 0; n < 5; ++n)
    {
        vectorField v(x.size());
        for (vector& e : v)
        {
            e = randomVector(random);
        }
        const scalar slope = (potential(x + h*v) - potential(x - h*v))/(2*h);
        CHECK(-sum(f & v) == Approx(slope).epsilon(1e-6));

        const vectorField change
        (
            (m.mechanics.forces(x - h*v, &start) - m.mechanics.forces(x + h*v, &start))
           /(2*h)
        );
        const Eigen::VectorXd Hv(tangent.times(membraneTangent::asVector(v)));
        const auto reference = membraneTangent::asVector(change);
        CHECK((Hv - reference).norm() < 1e-6*reference.norm());
    }

    // Without force and torque on the whole, against the motion, and of the first order
    // in its speed; none at rest or in a rigid motion
    vector torque(Zero);
    forAll(x, i)
    {
        torque += x[i] ^ f[i];
    }
    CHECK(mag(sum(f)) < 1e-12*sum(mag(f)));
    CHECK(mag(torque) < 1e-12*sum(mag(f)));
    const membraneModel::motion slow{x - 1e-6*u, 1e-6, {}};
    const membraneModel::motion slower{x - 0.5e-6*u, 1e-6, {}};
    const vectorField ofSlow(m.mechanics.forces(x, &slow));
    CHECK(sum(ofSlow & u) < 0);
    CHECK
    (
        max(mag(ofSlow - 2*m.mechanics.forces(x, &slower))) < 1e-4*max(mag(ofSlow))
    );
    CHECK(max(mag(m.mechanics.forces(x))) == 0);
    const tensor R(randomRotation(random).R());
    const membraneModel::motion rigid{(R & x) + vector(1, 2, 3), 0.1, {}};
    CHECK(max(mag(m.mechanics.forces(x, &rigid))) < 1e-12*max(mag(f)));
}


TEST_CASE("membrane: viscosity resists shear in the plane, not a change of area",
    "[membrane][serial]")
{
    const membrane any("a { type neoHookean; shearModulus 1; }");
    const auto model = selectModel<membraneModel>
    (
        dictOf("type surfaceViscosity; viscosity 3;"),
        any.type.surface(), any.type.centres()
    );
    const auto& law = dynamic_cast<const triangleElasticity&>(*model);

    // The potential is half of the power times the duration: eta (d:d - tr(d)^2/2)
    const scalar e = 1e-4;
    CHECK(stretched(law, 1 + e, 1 - e).W == Approx(3*2*sqr(e)).epsilon(1e-3));
    CHECK(stretched(law, 1 + e, 1).W == Approx(3*0.5*sqr(e)).epsilon(1e-3));
    CHECK(mag(stretched(law, 1 + e, 1 + e).W) < 1e-3*3*sqr(e));
}


TEST_CASE("membrane: the layer between the fluids resists any strain in the plane",
    "[membrane][serial]")
{
    const membrane m("a { type neoHookean; shearModulus 1e-9; }");
    const layerViscosity layer(m.type.surface(), m.type.centres());

    // The potential is half of the power times the duration: eta (d:d + tr(d)^2)
    const scalar e = 1e-4;
    CHECK(stretched(layer, 1 + e, 1 - e).W == Approx(2*sqr(e)).epsilon(1e-3));
    CHECK(stretched(layer, 1 + e, 1).W == Approx(2*sqr(e)).epsilon(1e-3));
    CHECK(stretched(layer, 1 + e, 1 + e).W == Approx(6*sqr(e)).epsilon(1e-3));

    // The forces of the motion of a sphere that dilates at the rate q: with the tension
    // T = 6 eta q they are along the normal, 2 T/R per area
    const pointField x(m.type.centres());
    const scalar eta = 3;
    const scalar q = 2;
    const scalar duration = 1e-5;
    membraneModel::motion start
    {
        x*(1 - q*duration), duration, scalarField(x.size(), eta)
    };
    const vectorField f(m.mechanics.forces(x, &start));
    const scalar power = sum(f & x)*q;
    const scalar area = sum(m.type.surface().nodeAreas(x));
    CHECK(-power == Approx(6*eta*sqr(q)*2*area).epsilon(1e-3));

    // None where the viscosities are zero
    start.layer.clear();
    CHECK(max(mag(m.mechanics.forces(x, &start))) < 1e-6*max(mag(f)));
}


TEST_CASE("membrane: bending energy of spheres and cells", "[membrane][bending][serial]")
{
    // 8 pi kappa for every sphere; second order
    scalar last = 0;
    for (const label n : {1, 2, 3})
    {
        const membrane m
        (
            "a { type helfrich; bendingStiffness 1; }",
            "type icosphere; radius 3; subdivisions " + Foam::name(n) + ";"
        );
        const scalar error = energy(m.mechanics, m.type.centres())/(8*pi) - 1;
        CHECK(mag(error) < 0.035/pow(4.0, n - 1));
        if (last)
        {
            CHECK(error/last < 0.3);
        }
        last = error;
    }

    // The fold of a tetrahedron's edges as Steiner has it: 2 kappa sum M^2/A
    const scalar a = 1/Foam::sqrt(8.0);
    const pointField corners({{a, a, a}, {a, -a, -a}, {-a, a, -a}, {-a, -a, a}});
    List<triFace> triangles(4);
    triangles[0] = triFace(0, 1, 2);
    triangles[1] = triFace(0, 3, 1);
    triangles[2] = triFace(0, 2, 3);
    triangles[3] = triFace(1, 3, 2);
    const closedSurface surface(corners, triangles, dictionary::null);
    CHECK(surface.volume(corners) == Approx(Foam::sqrt(2.0)/12).epsilon(1e-12));
    const auto model = selectModel<membraneModel>
    (
        dictOf("type helfrich; bendingStiffness 1;"), surface, corners
    );
    vectorField unused(4, Zero);
    const scalar M = 0.75*(pi - Foam::acos(1.0/3.0));
    CHECK
    (
        model->add(corners, unused, nullptr)
     == Approx(2*4*sqr(M)/(Foam::sqrt(3.0)/4)).epsilon(1e-12)
    );
}


TEST_CASE("membrane: the tension at a pipette is that of the law", "[membrane][serial]")
{
    // A flat membrane of fixed area around a tongue of the length L: the stretch along the
    // radius r is lambda, lambda^2 = 1 + s/r^2 with s = 2 L - 1, lengths over the radius of
    // the pipette, and the tension at its mouth int_1^inf (T1 - T2) dr/r
    const scalar L = GENERATE(0.8, 1.5, 2.5);
    const scalar s = 2*L - 1;
    const bool hardening = GENERATE(false, true);
    const auto model = selectModel<membraneModel>
    (
        dictOf
        (
            hardening
          ? "type skalak; shearModulus 2; areaRatio 50;"
          : "type neoHookean; shearModulus 2;"
        ),
        membrane("a { type neoHookean; shearModulus 2; }").type.surface(),
        membrane("a { type neoHookean; shearModulus 2; }").type.centres()
    );
    const auto& law = dynamic_cast<const triangleElasticity&>(*model);

    // By v = 1/r^2, dr/r = -dv/(2 v)
    const label n = 2000;
    scalar T = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar v = (i + 0.5)/n;
        const scalar l = Foam::sqrt(1 + s*v);
        T += (tension(law, l, 1/l) - tension(law, 1/l, l))/(2*v*n);
    }
    const scalar expected =
        hardening
      ? 0.5*sqr(s) + s + s/(1 + s)
      : s + Foam::log(1 + s);
    CHECK(2*T/2 == Approx(expected).epsilon(1e-5));
}
