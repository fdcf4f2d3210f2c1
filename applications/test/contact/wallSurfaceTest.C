/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "wallSurface.H"
#include "contactModel.H"
#include "mathematicalConstants.H"
#include <algorithm>

using namespace Foam;
using constant::mathematical::pi;

namespace
{

const scalar r = 2e-6;

void append(DynamicList<point>& corners, const point& a, const point& b, const point& c)
{
    corners.append(a);
    corners.append(b);
    corners.append(c);
}

//- A rectangle as n x m quadrilaterals of two triangles, normal side1 x side2
void appendPlane
(
    DynamicList<point>& corners,
    const point& origin,
    const vector& side1,
    const vector& side2,
    const label n = 1,
    const label m = 1
)
{
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < m; ++j)
        {
            const point a(origin + side1*i/n + side2*j/m);
            const vector s1(side1/n), s2(side2/m);
            append(corners, a, a + s1, a + s1 + s2);
            append(corners, a, a + s1 + s2, a + s2);
        }
    }
}

//- The force of the Hertz law, of unit modulus
vector force(const wallSurface& walls, const point& x)
{
    static const auto model
    (
        selectModel<contactModel>
        (
            dictOf("type hertz; reducedModulus 1; restitution 1;")
        )
    );
    vector result(Zero);
    for (const wallSurface::contact& c : walls.contacts(x, r))
    {
        result += c.weight*c.normal*model->force(c.overlap, 0, r, 1e-14);
    }
    return result;
}

scalar hertz(const scalar overlap)
{
    return 4.0/3.0*Foam::sqrt(r*overlap)*overlap;
}

//- Largest change of the force between neighbouring points of a path, over the
//  largest force
template<class Path>
scalar largestJump(const wallSurface& walls, const Path& path, const label n)
{
    scalar jump = 0, largest = 0;
    vector before(force(walls, path(0)));
    for (label k = 1; k <= n; ++k)
    {
        const vector now(force(walls, path(scalar(k)/n)));
        jump = max(jump, mag(now - before));
        largest = max(largest, mag(now));
        before = now;
    }
    return jump/largest;
}

//- A tube of n facets about z, normals outwards, the middle of a facet at x = R
wallSurface tube(const label n, const scalar R, const label along = 3)
{
    DynamicList<point> corners;
    const scalar half = R*Foam::tan(pi/n);
    for (label k = 0; k < n; ++k)
    {
        const scalar angle = 2*pi*k/n;
        const vector out(Foam::cos(angle), Foam::sin(angle), 0);
        const vector side(-out.y(), out.x(), 0);
        appendPlane
        (
            corners, R*out - half*side - vector(0, 0, 10e-6), 2*half*side,
            vector(0, 0, 20e-6), 1, along
        );
    }
    return wallSurface(corners);
}

}


TEST_CASE("walls: a plane gives the law however it is divided", "[walls][serial]")
{
    Random random(21);
    const vector up(0, 0, 1);

    // From two triangles to facets a fiftieth of the contact
    for (const label n : {1, 3, 10, 97, 400})
    {
        DynamicList<point> corners;
        appendPlane
        (
            corners, point(-10e-6, 10e-6, 0), vector(20e-6, 0, 0),
            vector(0, -20e-6, 0), n, n > 100 ? 200 : n + 1
        );
        const wallSurface walls(corners);

        for (label k = 0; k < 20; ++k)
        {
            const scalar overlap = r*Foam::pow(10, -2.5 + 0.14*k);
            const point x(3e-6*randomVector(random).x(), 1e-6, r - overlap);
            const vector f(force(walls, x));
            CHECK(mag(f - hertz(overlap)*up) < 1e-6*hertz(overlap));
            CHECK(walls.contacts(x, r).size() == 1);
        }

        // Behind the wall, until it is a radius away; not beyond
        CHECK
        (
            mag(force(walls, point(1e-6, 0, -0.5*r)) - hertz(1.5*r)*up)
          < 1e-6*hertz(1.5*r)
        );
        CHECK(walls.contacts(point(0, 0, -1.01*r), r).empty());
        CHECK(walls.contacts(point(0, 0, 1.01*r), r).empty());
    }
}


TEST_CASE("walls: independent of the order of the triangles", "[walls][serial]")
{
    Random random(22);
    DynamicList<point> corners;

    // A rough floor: normals within 26 degrees and beyond
    const label n = 12;
    List<point> nodes((n + 1)*(n + 1));
    forAll(nodes, k)
    {
        nodes[k] = 1e-6*
            vector(k % (n + 1) - 6, k/(n + 1) - 6, 0.6*random.sample01<scalar>());
    }
    for (label k = 0; k < n*(n + 1); ++k)
    {
        if (k % (n + 1) < n)
        {
            append(corners, nodes[k], nodes[k + n + 1], nodes[k + 1]);
            append(corners, nodes[k + 1], nodes[k + n + 1], nodes[k + n + 2]);
        }
    }
    const wallSurface walls(corners);

    labelList order(identity(corners.size()/3));
    for (label i = order.size() - 1; i > 0; --i)
    {
        std::swap(order[i], order[random.position<label>(0, i)]);
    }
    List<point> shuffled(corners.size());
    forAll(order, t)
    {
        for (label k = 0; k < 3; ++k)
        {
            shuffled[3*t + k] = corners[3*order[t] + k];
        }
    }
    const wallSurface others(shuffled);

    scalar least = GREAT;
    for (label k = 0; k < 200; ++k)
    {
        const point x(3e-6*randomVector(random) + vector(0, 0, 4e-6));
        const vector f(force(walls, x));
        CHECK(mag(f - force(others, x)) <= 1e-5*mag(f));
        least = mag(f) > 0 ? min(least, mag(f)) : least;
    }
    CHECK(least < GREAT);
}


TEST_CASE("walls: a corner gives the force of both its walls", "[walls][serial]")
{
    // Floor z = 0 and wall x = 0
    DynamicList<point> corners;
    appendPlane
    (
        corners, point(0, 10e-6, 0), vector(20e-6, 0, 0),
        vector(0, -20e-6, 0), 7, 7
    );
    appendPlane
    (
        corners, point(0, -10e-6, 0), vector(0, 0, 20e-6), vector(0, 20e-6, 0),
        9, 5
    );
    const wallSurface walls(corners);

    const vector f(force(walls, point(0.9*r, 0, 0.8*r)));
    const vector both(hertz(0.1*r), 0, hertz(0.2*r));
    CHECK(mag(f - both) < 0.01*mag(both));

    // Along the floor into the corner, and from wall to wall
    const auto slide = [&](const scalar s)
    {
        return point((3 - 2.2*s)*r, 0.1*r, 0.9*r);
    };
    const auto turn = [&](const scalar s)
    {
        return point(r + 0.2*r*(1 - s) - 0.1*r, 0, r - 0.2*r*(1 - s) + 0.05*r);
    };
    CHECK(largestJump(walls, slide, 4000) < 0.005);
    CHECK(largestJump(walls, turn, 400) < 0.02);
}


TEST_CASE("walls: over a convex edge the force turns steadily", "[walls][serial]")
{
    // A step of several angles: a plane z = 0 for x < 0, then falling
    const scalar degrees = GENERATE(1.0, 2.0, 5.0, 20.0, 25.0, 27.0, 45.0, 90.0, 150.0);
    const scalar a = degrees*pi/180;
    const vector down(Foam::cos(a), 0, -Foam::sin(a));
    DynamicList<point> corners;
    appendPlane
    (
        corners, point(-20e-6, 10e-6, 0), vector(20e-6, 0, 0),
        vector(0, -20e-6, 0), 11, 8
    );
    appendPlane
    (
        corners, point(0, 10e-6, 0), 20e-6*down, vector(0, -20e-6, 0), 6, 13
    );
    const wallSurface walls(corners);

    // Around the edge at a constant distance
    const scalar d = 0.1*r;
    const auto path = [&](const scalar s)
    {
        const scalar displacement = (2*s - 1)*(2*r + 0.5*a*(r - d)) + 0.5*a*(r - d);
        const scalar turned = displacement/(r - d);
        return
            turned < 0 ? point(displacement, 0, r - d)
          : turned > a
          ? point
            (
                (displacement - a*(r - d))*down
              + (r - d)*vector(Foam::sin(a), 0, Foam::cos(a))
            )
          : point((r - d)*vector(Foam::sin(turned), 0, Foam::cos(turned)));
    };
    CHECK(largestJump(walls, path, 1000) < 0.03);

    // The direction goes from one normal to the other, no farther
    scalar angle = -1e-3;
    for (label k = 0; k <= 200; ++k)
    {
        const vector f(force(walls, path(k/200.0)));
        REQUIRE(mag(f) > 0);
        const scalar now = std::atan2(f.x(), f.z());
        CHECK(now > angle - 1e-3);
        CHECK(now < a + 1e-3);
        angle = now;
    }
    CHECK(angle == Approx(a).margin(1e-3));

    // At the middle of the edge both planes fall off at half the angle. Of the
    // force per area, ~ (depth)^(1/2) over the disc, a fall t |x| of the depth
    // takes 3/4 t sqrt(2 r/d)
    const scalar middle = mag(force(walls, path(0.5)))/hertz(d);
    INFO(degrees << " degrees: " << middle << " of a plane's force");
    CHECK(middle < 1);
    if (degrees < 10)
    {
        CHECK(middle > 1 - 0.75*Foam::tan(0.5*a)*Foam::sqrt(2*r/d));
        CHECK(middle > 1 - 0.05*degrees);
    }
}


TEST_CASE("walls: a tube of facets approaches the cylinder", "[walls][serial]")
{
    const scalar R = 10e-6, d = 0.2*r;
    const scalar smooth = mag(force(tube(1536, R), point(R - r + d, 0, 0)));

    // More wall within reach than of a plane
    CHECK(smooth/hertz(d) == Approx(1/Foam::sqrt(1 - r/R)).epsilon(0.03));

    scalar last = GREAT;
    for (const label n : {12, 24, 48, 96})
    {
        const wallSurface walls(tube(n, R));
        const auto path = [&](const scalar s)
        {
            const scalar angle = 4*pi/n*s;
            return
                (R - r + d)*point(Foam::cos(angle), Foam::sin(angle), 0)
              + point(0, 0, 1e-6*s);
        };
        CHECK(largestJump(walls, path, 1000) < 0.02);

        // The facets' distance differs by R(1/cos(pi/n) - 1) from that of the
        // cylinder they enclose, the force as its overlap to the power of 3/2
        const scalar sagitta = R*(1/Foam::cos(pi/n) - 1);
        const scalar least =
            Foam::pow(max(1 - sagitta/d, scalar(0)), 1.5) - 0.01;
        scalar worst = 0;
        for (label k = 0; k < 40; ++k)
        {
            const vector f(force(walls, path(k/40.0)));
            CHECK(mag(f) < 1.02*smooth);
            CHECK(mag(f) > least*smooth);
            worst = max(worst, mag(mag(f)/smooth - 1));
        }
        INFO(n << " facets: " << worst);
        CHECK(worst < 0.5*last);
        last = worst;
    }
    CHECK(last < 0.03);
}


TEST_CASE("walls: either side of a wall without thickness", "[walls][serial]")
{
    DynamicList<point> corners;
    appendPlane
    (
        corners, point(-10e-6, 10e-6, 0), vector(20e-6, 0, 0),
        vector(0, -20e-6, 0), 5, 5
    );
    appendPlane
    (
        corners, point(-10e-6, -10e-6, 0), vector(20e-6, 0, 0),
        vector(0, 20e-6, 0), 5, 5
    );
    const wallSurface walls(corners);

    for (const scalar side : {1, -1})
    {
        const vector f(force(walls, point(1e-6, 2e-6, side*0.9*r)));
        CHECK(mag(f - vector(0, 0, side*hertz(0.1*r))) < 1e-6*mag(f));
    }
}


namespace
{

//- A cylinder of radius R about z, n faces around it and m along it, of unequal widths;
//  normals out of a fluid around it, or in it
struct cylinder
{
    faceList faces;
    pointField points;

    cylinder
    (
        const label n, const scalar R, const bool outside, const label m = 20,
        const scalar uneven = 0.3
    )
    :
        faces(n*m),
        points(n*(m + 1))
    {
        for (label j = 0; j <= m; ++j)
        {
            for (label i = 0; i < n; ++i)
            {
                const scalar angle =
                    2*pi*(i + 0.5*uneven*Foam::sin(2*pi*i/n*5))/n + 0.01;
                points[j*n + i] =
                    R*vector(Foam::cos(angle), Foam::sin(angle), 0)
                  + vector(0, 0, 20e-6*j/m - 10e-6);
            }
        }
        for (label j = 0; j < m; ++j)
        {
            for (label i = 0; i < n; ++i)
            {
                const label a = j*n + i, b = j*n + (i + 1) % n;
                face& f = faces[j*n + i];
                f = face(labelList({a, b, b + n, a + n}));
                if (outside)
                {
                    f = f.reverseFace();
                }
            }
        }
    }

    //- Two triangles for each face
    wallSurface triangulated() const
    {
        DynamicList<point> corners;
        for (const face& f : faces)
        {
            append(corners, points[f[0]], points[f[1]], points[f[2]]);
            append(corners, points[f[0]], points[f[2]], points[f[3]]);
        }
        return wallSurface(corners);
    }
};

DynamicList<wallSurface::film> filmsAt
(
    const wallSurface& walls, const point& x, const scalar radius
)
{
    const vector width(1.5*radius*vector::one);
    return walls.films
    (
        x, radius, 0.1*radius, 0.2*radius, walls.near(boundBox(x - width, x + width))
    );
}

}


TEST_CASE("walls: curvature and gap at a cylinder", "[walls][serial]")
{
    const bool outside = GENERATE(true, false);
    const bool triangles = GENERATE(true, false);
    const ghostExchange ghosts(testMesh());
    const scalar R = 5e-6, gap = 0.05*r;

    scalar last = GREAT;
    for (const label n : {24, 48, 96})
    {
        const cylinder c(n, R, outside);
        const wallSurface walls
        (
            triangles ? c.triangulated() : wallSurface(c.faces, c.points, ghosts)
        );
        scalar worst = 0, worstWeight = 0, worstGap = 0;
        for (label k = 0; k < 50; ++k)
        {
            const scalar angle = 0.12*k;
            const vector out(Foam::cos(angle), Foam::sin(angle), 0);
            const point x
            (
                (outside ? R + gap + r : R - gap - r)*out
              + vector(0, 0, 1e-6*Foam::sin(scalar(k)))
            );
            const auto films(filmsAt(walls, x, r));
            REQUIRE(films.size() == 1);
            const wallSurface::film& f = films[0];
            const scalar side = outside ? 1 : -1;
            worst = max(worst, mag(R*tr(f.curvature) - side));
            worst = max(worst, R*mag(f.curvature & vector(0, 0, 1)));
            worstWeight = max(worstWeight, mag(f.nearest.weight - 1));
            const scalar found = 1.2*r - f.nearest.overlap - r;
            worstGap = max
            (
                worstGap, mag(found - (r + gap - r))/R
            );
            CHECK((f.nearest.normal & (side*out)) > Foam::cos(1.2*pi/n));
        }
        INFO
        (
            (outside ? "post" : "tube") << (triangles ? ", triangles, " : ", ") << n
            << ": curvature " << worst << " weight " << worstWeight << " gap "
            << worstGap
        );

        // The angle of a face is up to 1.2 times 2 pi/n. The fit reaches one and a half
        // faces to either side, and z = x^2/(2 R) lacks x^4/(8 R^3)
        CHECK(worst < (n == 24 ? 0.08 : 0.05));
        CHECK(worst < 1.01*last);
        CHECK(worstWeight < 1e-6);
        CHECK(worstGap < 1.02*(1 - Foam::cos(1.2*pi/n)));
        last = worst;
    }
}


TEST_CASE("walls: curvature at planes, edges, spheres and strips", "[walls][serial]")
{
    // An oblique plane of triangles, and one of a single face
    const vector e1(0.8, 0.36, 0.48), e2(-0.6, 0.48, 0.64);
    for (const label n : {1, 12})
    {
        DynamicList<point> corners;
        appendPlane(corners, -10e-6*(e1 + e2), 20e-6*e1, 20e-6*e2, n, n);
        const wallSurface walls(corners);
        const auto films(filmsAt(walls, -1.05*r*(e1 ^ e2), r));
        REQUIRE(films.size() == 1);
        CHECK(r*mag(films[0].curvature) < 1e-8);
        CHECK(films[0].nearest.weight == Approx(1));
        CHECK(films[0].nearest.overlap == Approx(0.15*r));
    }

    // Two walls of a channel: plane up to the edge between them, two films in it
    DynamicList<point> corners;
    appendPlane
    (
        corners, point(0, 10e-6, 0), vector(20e-6, 0, 0), vector(0, -20e-6, 0), 7, 7
    );
    appendPlane
    (
        corners, point(0, -10e-6, 0), vector(0, 0, 20e-6), vector(0, 20e-6, 0), 9, 5
    );
    const wallSurface corner(corners);
    const auto both(filmsAt(corner, point(1.02*r, 0, 1.05*r), r));
    REQUIRE(both.size() == 2);
    for (const wallSurface::film& f : both)
    {
        CHECK(r*mag(f.curvature) < 1e-8);
        CHECK(f.nearest.weight > 0.9);
    }

    // A strip one face wide: curved around, not along
    const ghostExchange ghosts(testMesh());
    const cylinder strip(48, 5e-6, true, 1);
    const auto alone
    (
        filmsAt
        (
            wallSurface(strip.faces, strip.points, ghosts), point(5e-6 + 1.05*r, 0, 0), r
        )
    );
    REQUIRE(alone.size() == 1);
    CHECK(5e-6*tr(alone[0].curvature) == Approx(1).epsilon(0.05));
    CHECK(5e-6*mag(alone[0].curvature & vector(0, 0, 1)) < 1e-6);

    // A sphere
    const scalar R = 4e-6;
    const label n = 40;
    faceList faces;
    DynamicList<point> points;
    for (label j = 0; j <= n/2; ++j)
    {
        for (label i = 0; i < n; ++i)
        {
            const scalar polar = pi*(0.1 + 0.8*j/(n/2)), angle = 2*pi*i/n;
            points.append
            (
                R*vector
                (
                    Foam::sin(polar)*Foam::cos(angle),
                    Foam::sin(polar)*Foam::sin(angle), Foam::cos(polar)
                )
            );
            if (j < n/2)
            {
                const label a = j*n + i, b = j*n + (i + 1) % n;
                faces.append(face(labelList({a, b, b + n, a + n})));
            }
        }
    }
    const wallSurface ball(faces, points, ghosts);
    const vector out(normalised(vector(0.7, 0.4, 0.3)));
    const auto films(filmsAt(ball, (R + 1.03*r)*out, r));
    REQUIRE(films.size() == 1);
    CHECK(R*mag(films[0].curvature - (symmTensor::I - sqr(out))/R) < 0.15);
    CHECK(R*tr(films[0].curvature) == Approx(2).epsilon(0.05));
}
