/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereGrid.H"
#include "DynamicList.H"
#include <map>
#include <vector>
#include <tuple>
#include <cmath>

void Foam::sphereGrid::forEachContact
(
    const UList<clumpImage>& images,
    const label nOwn,
    const PtrList<clumpType>& types,
    const std::function<void(label, label, label, label)>& visit
)
{
    // Clumps whose boxes meet that of an own clump
    std::vector<bool> enters(images.size(), false);
    bool any = false;
    for (label a = 0; a < nOwn; ++a)
    {
        forAll(images, b)
        {
            if (a != b && images[a].box.overlaps(images[b].box))
            {
                enters[a] = enters[b] = true;
                any = true;
            }
        }
    }
    if (!any)
    {
        return;
    }

    scalar width = 0;
    forAll(images, a)
    {
        if (enters[a])
        {
            width = max(width, 2*max(types[images[a].typeId].radii()));
        }
    }

    typedef std::tuple<long, long, long> cube;
    const auto cubeOf = [&](const point& p)
    {
        return cube
        (
            std::lround(p.x()/width),
            std::lround(p.y()/width),
            std::lround(p.z()/width)
        );
    };

    std::map<cube, DynamicList<labelPair>> grid;
    forAll(images, a)
    {
        if (enters[a])
        {
            forAll(images[a].x, i)
            {
                grid[cubeOf(images[a].x[i])].append(labelPair(a, i));
            }
        }
    }

    for (label a = 0; a < nOwn; ++a)
    {
        if (!enters[a])
        {
            continue;
        }
        forAll(images[a].x, i)
        {
            const point& x = images[a].x[i];
            const scalar r = types[images[a].typeId].radii()[i];
            const cube c(cubeOf(x));

            for (label n = 0; n < 27; ++n)
            {
                const auto found = grid.find
                (
                    cube
                    (
                        std::get<0>(c) + n % 3 - 1,
                        std::get<1>(c) + (n/3) % 3 - 1,
                        std::get<2>(c) + n/9 - 1
                    )
                );
                if (found == grid.end())
                {
                    continue;
                }
                for (const labelPair& other : found->second)
                {
                    const label b = other.first();
                    const label j = other.second();
                    const scalar touch = r + types[images[b].typeId].radii()[j];

                    if (b != a && magSqr(x - images[b].x[j]) < sqr(touch))
                    {
                        visit(a, i, b, j);
                    }
                }
            }
        }
    }
}
