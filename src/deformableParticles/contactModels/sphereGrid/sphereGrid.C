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

namespace
{

using namespace Foam;

typedef std::tuple<long, long, long> cube;

cube cubeOf(const point& p, const scalar width)
{
    return cube
    (
        std::lround(std::floor(p.x()/width)),
        std::lround(std::floor(p.y()/width)),
        std::lround(std::floor(p.z()/width))
    );
}

//- The entries of a cube and its 26 neighbours
template<class Grid, class Action>
void forEachAround(const Grid& grid, const cube& c, const Action& action)
{
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
        if (found != grid.end())
        {
            for (const auto& entry : found->second)
            {
                action(entry);
            }
        }
    }
}

}


void Foam::sphereGrid::forEachNear
(
    const UList<clumpImage>& images,
    const label nOwn,
    const UList<scalar>& margins,
    const std::function<void(label, label)>& visit
)
{
    // Boxes that meet have centres no farther apart than the widest box
    scalar width = SMALL;
    for (const clumpImage& image : images)
    {
        width = max(width, cmptMax(image.box.span()));
    }
    width += nOwn ? max(margins) : scalar(0);

    std::map<cube, DynamicList<label>> grid;
    forAll(images, b)
    {
        grid[cubeOf(images[b].box.midpoint(), width)].append(b);
    }

    for (label a = 0; a < nOwn; ++a)
    {
        boundBox box(images[a].box);
        box.min() -= margins[a]*vector::one;
        box.max() += margins[a]*vector::one;

        forEachAround
        (
            grid, cubeOf(images[a].box.midpoint(), width),
            [&](const label b)
            {
                if (a != b && box.overlaps(images[b].box))
                {
                    visit(a, b);
                }
            }
        );
    }
}


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
    forEachNear
    (
        images, nOwn, scalarField(nOwn, Zero),
        [&](const label a, const label b)
        {
            enters[a] = enters[b] = true;
            any = true;
        }
    );
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

    std::map<cube, DynamicList<labelPair>> grid;
    forAll(images, a)
    {
        if (enters[a])
        {
            forAll(images[a].x, i)
            {
                grid[cubeOf(images[a].x[i], width)].append(labelPair(a, i));
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

            forEachAround
            (
                grid, cubeOf(x, width),
                [&](const labelPair& other)
                {
                    const label b = other.first();
                    const label j = other.second();
                    const scalar touch = r + types[images[b].typeId].radii()[j];

                    if (b != a && magSqr(x - images[b].x[j]) < sqr(touch))
                    {
                        visit(a, i, b, j);
                    }
                }
            );
        }
    }
}
