/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "enclosedVolume.H"

namespace Foam
{
namespace conservationModels
{
    defineTypeNameAndDebug(enclosedVolume, 0);
    addToRunTimeSelectionTable(conservationModel, enclosedVolume, dictionary);
}
}


Foam::conservationModels::enclosedVolume::enclosedVolume
(
    const dictionary& dict,
    const pointField& centres,
    const scalarField&
)
:
    volumeModulus_(getPositive(dict, "volumeModulus")),
    volume0_(0)
{
    checkEntries(dict, {"type", "volumeModulus"});

    findTriangles(dict, centres);
    vectorField grad(centres.size());
    volume0_ = deviation(centres, grad);
}


void Foam::conservationModels::enclosedVolume::findTriangles
(
    const dictionary& dict,
    const pointField& x
)
{
    const label n = x.size();
    const point centre(average(x));
    scalar size = 0;
    for (const point& p : x)
    {
        size = max(size, mag(p - centre));
    }

    // Three corners make a face when all others lie on one side of their plane
    for (label i = 0; i < n; ++i)
    {
        for (label j = i + 1; j < n; ++j)
        {
            for (label k = j + 1; k < n; ++k)
            {
                vector normal((x[j] - x[i]) ^ (x[k] - x[i]));
                const scalar area = mag(normal);
                if (area < 1e-9*sqr(size))
                {
                    continue;
                }
                normal /= area;
                const bool outwards = ((x[i] - centre) & normal) > 0;
                normal *= outwards ? 1 : -1;

                bool face = true;
                for (label l = 0; l < n && face; ++l)
                {
                    face =
                        l == i || l == j || l == k
                     || ((x[l] - x[i]) & normal) < -1e-9*size;
                }
                if (face)
                {
                    triangles_.append
                    (
                        outwards
                      ? FixedList<label, 3>({i, j, k})
                      : FixedList<label, 3>({i, k, j})
                    );
                }
            }
        }
    }

    // Euler: a closed surface of triangles through all corners
    if (n < 4 || triangles_.size() != 2*n - 4)
    {
        FatalIOErrorInFunction(dict)
            << "conservationModel enclosedVolume: the " << n << " sphere "
            << "centres are not the corners of a convex surface of triangles ("
            << triangles_.size() << " found)" << exit(FatalIOError);
    }
}


Foam::scalar Foam::conservationModels::enclosedVolume::deviation
(
    const pointField& x,
    vectorField& grad
) const
{
    // Relative to the first point: no cancellation far from the origin
    grad = Zero;
    scalar volume = 0;

    for (const FixedList<label, 3>& t : triangles_)
    {
        const vector a(x[t[0]] - x[0]);
        const vector b(x[t[1]] - x[0]);
        const vector c(x[t[2]] - x[0]);

        volume += (a & (b ^ c))/6;
        grad[t[0]] += (b ^ c)/6;
        grad[t[1]] += (c ^ a)/6;
        grad[t[2]] += (a ^ b)/6;
    }

    // The first point itself: the volume depends on relative positions alone
    grad[0] -= sum(grad);

    return volume - volume0_;
}
