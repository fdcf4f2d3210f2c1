/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tetClipping.H"
#include "halfSpaces.H"

namespace Foam
{
namespace solidFractionModels
{
    defineTypeNameAndDebug(tetClipping, 0);
    addToRunTimeSelectionTable(solidFractionModel, tetClipping, dictionary);
}
}


namespace
{

using namespace Foam;

//- Corner of a tetrahedron with its distances to the spheres
struct corner
{
    point x;
    const scalar* d;
};

//- Volume fraction of a tetrahedron inside of the spheres
scalar insideFraction(const corner* const c[4], const UList<scalar>& radii)
{
    const point mean(0.25*(c[0]->x + c[1]->x + c[2]->x + c[3]->x));
    const scalar ySqr =
        magSqr(c[0]->x - mean) + magSqr(c[1]->x - mean)
      + magSqr(c[2]->x - mean) + magSqr(c[3]->x - mean);

    halfSpaces::set cutting;
    forAll(radii, j)
    {
        halfSpaces::heights s
        {
            {c[0]->d[j], c[1]->d[j], c[2]->d[j], c[3]->d[j]}
        };
        scalar* h = s.h;
        const scalar d = 0.25*(h[0] + h[1] + h[2] + h[3]);

        // The tetrahedron reaches no farther than sqrt(ySqr) from its mean
        if (sqr(d) > ySqr)
        {
            if (d < 0)
            {
                return 1;
            }
            continue;
        }

        scalar across = 0;
        for (label i = 0; i < 4; ++i)
        {
            across += sqr(h[i] - d);
        }
        const scalar excess =
            0.1*max(ySqr - across, scalar(0))
           /max(radii[j] + d, 0.5*radii[j]);

        bool cuts = false, holds = true;
        for (label i = 0; i < 4; ++i)
        {
            h[i] -= excess;
            cuts = cuts || h[i] < 0;
            holds = holds && h[i] <= 0;
        }
        if (holds)
        {
            return 1;
        }
        if (cuts)
        {
            cutting.add(s);
        }
    }

    return 1 - halfSpaces::outsideFraction(cutting);
}

}


Foam::solidFractionModels::tetClipping::tetClipping(const dictionary& dict)
{
    checkEntries(dict, {"type"});
}


Foam::scalar Foam::solidFractionModels::tetClipping::fraction
(
    const cellGeometry& geometry,
    const label celli,
    const scalar,
    const UList<point>& centres,
    const UList<scalar>& radii
) const
{
    const fvMesh& mesh = geometry.mesh();
    const label n = centres.size();
    const labelList& vertices = mesh.cellPoints()[celli];

    // The vertices and, last, the centre, with their distances to the spheres
    scalarField d((vertices.size() + 1)*n);
    List<corner> corners(vertices.size() + 1);
    forAll(corners, k)
    {
        corner& c = corners[k];
        c.x =
            k < vertices.size()
          ? mesh.points()[vertices[k]] : mesh.cellCentres()[celli];
        c.d = &d[k*n];
        for (label j = 0; j < n; ++j)
        {
            d[k*n + j] = mag(c.x - centres[j]) - radii[j];
        }
    }
    const auto vertex = [&](const label pointi)
    {
        label k = 0;
        while (vertices[k] != pointi)
        {
            ++k;
        }
        return &corners[k];
    };

    scalar inside = 0;
    scalar volume = 0;

    for (const label facei : mesh.cells()[celli])
    {
        // A fan of triangles about the face's base point
        const face& f = mesh.faces()[facei];
        const label base = max(mesh.tetBasePtIs()[facei], label(0));
        const corner* tet[4] = {&corners.last(), vertex(f[base])};

        label pointi = f.fcIndex(base);
        tet[3] = vertex(f[pointi]);
        for (label k = 2; k < f.size(); ++k)
        {
            pointi = f.fcIndex(pointi);
            tet[2] = tet[3];
            tet[3] = vertex(f[pointi]);

            const vector toBase(tet[1]->x - tet[0]->x);
            const scalar V = mag
            (
                (toBase ^ (tet[2]->x - tet[0]->x)) & (tet[3]->x - tet[0]->x)
            )/6;

            inside += V*insideFraction(tet, radii);
            volume += V;
        }
    }

    return inside/volume;
}
