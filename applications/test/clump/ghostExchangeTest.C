/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "foamCompat.H"
#include "ghostExchange.H"
#include "Random.H"

using namespace Foam;

TEST_CASE("ghosts: the owners of two clumps of any size that may meet know both", "[cloud]")
{
    ghostExchange ghosts(testMesh());
    const boundBox& here = ghosts.localBox();
    Random random(7 + Pstream::myProcNo());

    // Sizes from a hundredth of the domain to a fifth, the largest on one processor
    const scalar largest = 0.2*testMesh().bounds().span().x();
    const label n = 30;
    UList<clumpImage>& own = ghosts.own(n);
    List<List<boundBox>> boxes(Pstream::nProcs(), List<boundBox>(n));
    for (label i = 0; i < n; ++i)
    {
        const point centre
        (
            here.min() + cmptMultiply(random.sample01<vector>(), here.span())
        );
        const bool large = Pstream::master() && i == 0;
        own[i].reach = large ? largest : 0.05*largest*(1 + random.sample01<scalar>());
        const vector half(own[i].reach*vector::one);
        own[i].box = boundBox(centre - half, centre + half);
        own[i].owner = Pstream::myProcNo();
        own[i].index = i;
        boxes[Pstream::myProcNo()][i] = own[i].box;
    }
    gatherToAll(boxes);
    ghosts.update();

    label nOverlapping = 0, nKnown = 0;
    for (label proci = 0; proci < Pstream::nProcs(); ++proci)
    {
        for (label j = 0; j < n; ++j)
        {
            for (const vector& shift : ghosts.shifts())
            {
                boundBox box(boxes[proci][j]);
                box.min() += shift;
                box.max() += shift;
                bool overlapping = false;
                for (const boundBox& mine : boxes[Pstream::myProcNo()])
                {
                    overlapping = overlapping || mine.overlaps(box);
                }
                bool known = false;
                for (const clumpImage& image : ghosts.images())
                {
                    known =
                        known
                     || (
                            image.owner == proci && image.index == j
                         && mag(image.transform.shift - shift) < 1e-9
                        );
                }
                nOverlapping += overlapping;
                nKnown += overlapping && known;
            }
        }
    }
    CHECK(nOverlapping >= n);
    CHECK(nKnown == nOverlapping);

    // Only the processor of the largest clump needs to know what is that far away
    for (label proci = 0; proci < Pstream::nProcs(); ++proci)
    {
        const bool far = ghosts.reach(proci) > largest;
        CHECK(far == (proci == Pstream::masterNo()));
    }
}
