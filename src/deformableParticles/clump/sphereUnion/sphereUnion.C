/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereUnion.H"
#include "boundBox.H"
#include "DynamicList.H"
#include <algorithm>
#include <utility>

Foam::scalar Foam::sphereUnion::volume
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const label nColumns
)
{
    boundBox box;
    forAll(centres, i)
    {
        box.add(centres[i] - radii[i]*vector::one);
        box.add(centres[i] + radii[i]*vector::one);
    }

    const scalar dx = box.span().x()/nColumns;
    const scalar dy = box.span().y()/nColumns;

    DynamicList<std::pair<scalar, scalar>> chords;
    scalar length = 0;

    for (label ix = 0; ix < nColumns; ++ix)
    {
        for (label iy = 0; iy < nColumns; ++iy)
        {
            const scalar x = box.min().x() + (ix + 0.5)*dx;
            const scalar y = box.min().y() + (iy + 0.5)*dy;

            chords.clear();
            forAll(centres, i)
            {
                const scalar half2 =
                    sqr(radii[i]) - sqr(x - centres[i].x())
                  - sqr(y - centres[i].y());

                if (half2 > 0)
                {
                    const scalar half = Foam::sqrt(half2);
                    const scalar z = centres[i].z();
                    chords.append(std::make_pair(z - half, z + half));
                }
            }

            std::sort(chords.begin(), chords.end());

            scalar reached = -GREAT;
            for (const auto& chord : chords)
            {
                length += max(scalar(0), chord.second - max(chord.first, reached));
                reached = max(reached, chord.second);
            }
        }
    }

    return length*dx*dy;
}
