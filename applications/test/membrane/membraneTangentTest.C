/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testMembrane.H"
#include "membraneFactors.H"

using namespace Foam;

TEST_CASE("membrane: the tangent is positive and solved for", "[membrane][serial]")
{
    const string models = GENERATE
    (
        "a { type neoHookean; shearModulus 2; }",
        "a { type skalak; shearModulus 2; areaRatio 3; }"
        " b { type helfrich; bendingStiffness 0.3; }"
        " c { type surfaceArea; areaModulus 500; }"
    );
    INFO(models);
    const testMembrane m(models);
    Random random(5);
    const pointField x(0.8*deformed(m.type, 0.2, random));
    membraneTangent tangent(m.type.surface(), m.mechanics.neighbourOrder());
    vectorField unused(x.size(), Zero);
    m.mechanics.add(x, unused, &tangent);

    Eigen::VectorXd r(Eigen::VectorXd::Random(tangent.size()));
    CHECK(r.dot(tangent.times(r)) > 0);
    forAll(x, i)
    {
        tangent.add(i, i, 0.1*Eigen::Matrix3d::Identity());
    }
    membraneFactors factors(tangent);
    REQUIRE(factors.factorise(tangent));
    Eigen::VectorXd v;
    REQUIRE(tangent.solve(r, factors, v));
    CHECK((tangent.times(v) - r).norm() < 1e-9*r.norm());
    CHECK(v.dot(r) > 0);

    // With factors of another tangent, from the solution for another force
    vectorField ofNodes(x.size(), Zero);
    tangent.clear();
    m.mechanics.add(1.02*x, ofNodes, &tangent);
    forAll(x, i)
    {
        tangent.add(i, i, 0.1*Eigen::Matrix3d::Identity());
    }
    const Eigen::VectorXd other(1.1*r + 0.2*Eigen::VectorXd::Random(r.size()));
    Eigen::VectorXd near(v), far;
    REQUIRE(tangent.solve(other, factors, near));
    REQUIRE(tangent.solve(other, factors, far));
    const scalar size = far.dot(tangent.times(far));
    CHECK((near - far).dot(tangent.times(near - far)) < sqr(0.03)*size);

    // One that is not positive has no solution, and leaves nothing to begin with
    forAll(x, i)
    {
        tangent.add(i, i, -1e6*Eigen::Matrix3d::Identity());
    }
    CHECK(!tangent.solve(other, factors, near));
    CHECK(near.size() == 0);
}
