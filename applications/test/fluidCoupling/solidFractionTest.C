/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "solidFractionModel.H"
#include "halfSpaces.H"
#include "sphereUnion.H"
#include "barycentric.H"
#include "volFields.H"
#include "modelSelection.H"

using namespace Foam;

TEST_CASE("solid fraction: half spaces against random points", "[fraction]")
{
    Random random(5);
    const label nPoints = 200000;

    for (label n = 1; n <= 3; ++n)
    {
        halfSpaces::set spaces;
        while (spaces.size < n)
        {
            halfSpaces::heights space;
            for (scalar& h : space.h)
            {
                h = random.sample01<scalar>() - 0.4;
            }
            spaces.add(space);
        }

        label outside = 0;
        for (label k = 0; k < nPoints; ++k)
        {
            const barycentric x(barycentric01(random));
            bool out = true;
            for (label j = 0; j < n; ++j)
            {
                const scalar* h = spaces.spaces[j].h;
                out = out && (x & barycentric(h[0], h[1], h[2], h[3])) > 0;
            }
            outside += out;
        }

        CHECK
        (
            halfSpaces::outsideFraction(spaces)
         == Approx(scalar(outside)/nPoints).margin(4e-3)
        );
    }
}


TEST_CASE("solid fraction: one inside of another changes nothing", "[fraction]")
{
    halfSpaces::set spaces;
    spaces.add({{-1, 1, 2, 3}});
    const scalar alone = halfSpaces::outsideFraction(spaces);

    spaces.add({{-0.5, 1, 2.5, 3}});
    CHECK(spaces.size == 1);
    spaces.add({{-1.5, 0.5, 2, 3}});
    CHECK(spaces.size == 1);
    CHECK(halfSpaces::outsideFraction(spaces) < alone);
}


TEST_CASE("solid fraction: a cut cell against random points", "[fraction]")
{
    // D/dx = 4: a sphere alone, and two that meet in the cell
    const bool two = GENERATE(false, true);
    const word model = GENERATE(word("tetClipping"), word("signedDistance"));
    const autoPtr<solidFractionModel> fraction
    (
        selectModel<solidFractionModel>(dictOf("type " + model + ";"))
    );

    const fvMesh& mesh = testMesh();
    const cellGeometry geometry(mesh);
    const label celli = mesh.nCells()/2;
    const point C(mesh.C()[celli]);
    const scalar dx = Foam::cbrt(mesh.V()[celli]);
    const scalar r = 2*dx;
    const boundBox box
    (
        mesh.cells()[celli].points(mesh.faces(), mesh.points()), false
    );

    Random random(3);
    scalar sumSqr = 0;
    const label nCases = 20;
    for (label k = 0; k < nCases; ++k)
    {
        const vector n(normalised(randomVector(random)));
        const vector t(normalised(n ^ randomVector(random)));
        const scalar depth = 0.5*dx*randomVector(random).x();
        List<point> centres(1, C + (r + depth)*n);
        if (two)
        {
            centres[0] += 0.3*r*t;
            centres.append(C + (0.95*r + depth)*n - 0.3*r*t);
        }
        const scalarList radii(centres.size(), r);

        label inside = 0;
        const label nPoints = 20000;
        for (label i = 0; i < nPoints; ++i)
        {
            const point x
            (
                random.position<vector>(box.min(), box.max())
            );
            inside += sphereUnion::distance(x, centres, radii) < 0;
        }

        sumSqr += sqr
        (
            fraction->fraction
            (
                geometry, celli, sphereUnion::distance(C, centres, radii),
                centres, radii
            )
          - scalar(inside)/nPoints
        );
    }

    // The points themselves scatter by 0.0035 at most
    CHECK
    (
        Foam::sqrt(sumSqr/nCases) < (model == "tetClipping" ? 0.008 : 0.12)
    );
}
