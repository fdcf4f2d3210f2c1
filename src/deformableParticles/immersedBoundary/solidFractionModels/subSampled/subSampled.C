/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "subSampled.H"
#include "sphereUnion.H"

namespace Foam
{
namespace solidFractionModels
{
    defineTypeNameAndDebug(subSampled, 0);
    addToRunTimeSelectionTable(solidFractionModel, subSampled, dictionary);
}
}


Foam::solidFractionModels::subSampled::subSampled(const dictionary&)
{}


Foam::scalar Foam::solidFractionModels::subSampled::fraction
(
    const fvMesh& mesh,
    const label celli,
    const scalar,
    const UList<point>& centres,
    const UList<scalar>& radii
) const
{
    // Second order points of a tetrahedron
    const scalar near = 0.58541020, far = 0.13819660;

    const point& C = mesh.cellCentres()[celli];
    scalar inside = 0;
    scalar volume = 0;

    for (const label facei : mesh.cells()[celli])
    {
        const face& f = mesh.faces()[facei];
        const point& F = mesh.faceCentres()[facei];

        forAll(f, k)
        {
            const point corners[4] =
            {
                C, F, mesh.points()[f[k]], mesh.points()[f.nextLabel(k)]
            };
            const scalar V = mag
            (
                (
                    (corners[1] - C) ^ (corners[2] - C)
                ) & (corners[3] - C)
            )/6;
            const scalar width = Foam::cbrt(0.25*V) + VSMALL;
            const point sum(corners[0] + corners[1] + corners[2] + corners[3]);

            for (const point& corner : corners)
            {
                const point p(far*sum + (near - far)*corner);
                const scalar d = sphereUnion::distance(p, centres, radii);
                inside +=
                    0.25*V*min(max(0.5 - d/width, scalar(0)), scalar(1));
            }
            volume += V;
        }
    }

    return inside/volume;
}
