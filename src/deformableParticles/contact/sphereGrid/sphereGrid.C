/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereGrid.H"
#include "DynamicList.H"
#include <map>
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
    // Spheres of a clump that reach into the box of another one
    const auto reaching = [&]
    (
        const clumpImage& image, const boundBox& box, DynamicList<label>& found
    )
    {
        const scalarField& radii = types[image.typeId].radii();
        found.clear();
        forAll(image.x, i)
        {
            if (magSqr(image.x[i] - box.nearest(image.x[i])) < sqr(radii[i]))
            {
                found.append(i);
            }
        }
    };

    DynamicList<label> ofA, ofB;
    forEachNear
    (
        images, nOwn, scalarField(nOwn, Zero),
        [&](const label a, const label b)
        {
            const clumpImage& A = images[a];
            const clumpImage& B = images[b];
            const scalarField& rA = types[A.typeId].radii();
            const scalarField& rB = types[B.typeId].radii();

            reaching(A, B.box, ofA);
            reaching(B, A.box, ofB);
            for (const label i : ofA)
            {
                for (const label j : ofB)
                {
                    if (magSqr(A.x[i] - B.x[j]) < sqr(rA[i] + rB[j]))
                    {
                        visit(a, i, b, j);
                    }
                }
            }
        }
    );
}
