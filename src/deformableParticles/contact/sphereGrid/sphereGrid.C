/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereGrid.H"
#include "foamCompat.H"
#include "pointGrid.H"
#include <algorithm>
#include <cmath>
#include <map>

namespace
{

using namespace Foam;

//- Images whose boxes are equally wide within a factor of two
struct level
{
    scalar widest = 0;
    DynamicList<label> images;
    DynamicList<point> centres;
    pointGrid grid;
};


//- All images, level by level
std::map<int, level> levels(const UList<clumpImage>& images)
{
    std::map<int, level> result;
    forAll(images, b)
    {
        const scalar width = cmptMax(images[b].box.span());
        int octave;
        std::frexp(width, &octave);
        level& l = result[octave];
        l.widest = max(l.widest, width);
        l.images.append(b);
        l.centres.append(images[b].box.midpoint());
    }
    for (auto& l : result)
    {
        l.second.grid.update(l.second.centres);
    }
    return result;
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
    const std::map<int, level> all(levels(images));
    DynamicList<label> found, near;
    for (label a = 0; a < nOwn; ++a)
    {
        const boundBox box(grown(images[a].box, margins[a]));

        near.clear();
        for (const auto& l : all)
        {
            // Boxes that meet have centres no farther apart than half of both
            const vector half(0.51*l.second.widest*vector::one);
            l.second.grid.find
            (
                boundBox(box.min() - half, box.max() + half), found
            );
            for (const label k : found)
            {
                const label b = l.second.images[k];
                if (a != b && box.overlaps(images[b].box))
                {
                    near.append(b);
                }
            }
        }
        std::sort(near.begin(), near.end());
        for (const label b : near)
        {
            visit(a, b);
        }
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

    DynamicList<label> spheresA, spheresB;
    forEachNear
    (
        images, nOwn, scalarField(nOwn, Zero),
        [&](const label a, const label b)
        {
            const clumpImage& A = images[a];
            const clumpImage& B = images[b];
            const scalarField& rA = types[A.typeId].radii();
            const scalarField& rB = types[B.typeId].radii();

            reaching(A, B.box, spheresA);
            reaching(B, A.box, spheresB);
            for (const label i : spheresA)
            {
                for (const label j : spheresB)
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
