/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereGrid.H"
#include "pointGrid.H"

void Foam::sphereGrid::forEachNear
(
    const UList<clumpImage>& images,
    const label nOwn,
    const UList<scalar>& margins,
    const std::function<void(label, label)>& visit
)
{
    // Boxes that meet have centres no farther apart than half of both
    pointField centres(images.size());
    scalar widest = 0;
    forAll(images, b)
    {
        centres[b] = images[b].box.midpoint();
        widest = max(widest, cmptMax(images[b].box.span()));
    }
    pointGrid grid;
    grid.update(centres);

    DynamicList<label> found;
    for (label a = 0; a < nOwn; ++a)
    {
        boundBox box(images[a].box);
        box.min() -= margins[a]*vector::one;
        box.max() += margins[a]*vector::one;

        const vector half(0.51*widest*vector::one);
        grid.find(boundBox(box.min() - half, box.max() + half), found);
        for (const label b : found)
        {
            if (a != b && box.overlaps(images[b].box))
            {
                visit(a, b);
            }
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
