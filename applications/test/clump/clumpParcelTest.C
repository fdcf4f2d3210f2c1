/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "Cloud.H"
#include "clumpParcel.H"

using namespace Foam;

namespace
{

dictionary beadDict()
{
    return dictOf
    (
        "shape { type chain; nSpheres 1; sphereRadius 1e-6; }"
        "density 1098; massModel union; motion free;"
    );
}

//- The number of the clump is its origId
void add
(
    Cloud<clumpParcel>& cloud,
    const clumpType& type,
    const label number,
    const point& position
)
{
    const label celli = testCell(position);
    if (celli >= 0)
    {
        clumpParcel* p = new clumpParcel
        (
            testMesh(), position, celli, 0, clumpState(type)
        );
        p->origId() = number;
        cloud.addParticle(p);
    }
}

}

TEST_CASE("parcel: a centre beyond a wall stays where it is", "[parcel]")
{
    // In parallel, the cloud moves all parcels again when one has changed the processor
    const clumpType type("bead", beadDict());
    Cloud<clumpParcel> cloud(testMesh(), "parcels", IDLList<clumpParcel>());
    const point start(5e-6, 0.3e-6, 5e-6);
    const point beyond(5e-6, -0.6e-6, 5e-6);
    add(cloud, type, 0, start);
    add(cloud, type, 1, point(9.7e-6, 10e-6, 9.7e-6));

    for (clumpParcel& p : cloud)
    {
        p.state().x += p.origId() == 0 ? beyond - start : vector::zero;
    }
    for (label n = 0; n < 4; ++n)
    {
        for (clumpParcel& p : cloud)
        {
            if (p.origId() == 1)
            {
                p.state().x += (n % 2 ? -1e-6 : 1e-6)*vector(1, 0, 1);
            }
            p.recentre(type);
        }
        clumpParcel::trackingData td(cloud);
        cloud.move(cloud, td, 1);
        for (clumpParcel& p : cloud)
        {
            p.move(cloud, td, 1);
        }
    }

    scalar off = 0;
    for (const clumpParcel& p : cloud)
    {
        if (p.origId() == 0)
        {
            off = mag(p.position() + p.state().centre(type) - beyond);
        }
    }
    CHECK(returnReduce(off, maxOp<scalar>()) < 1e-12);
    CHECK(returnReduce(cloud.size(), sumOp<label>()) == 2);
}
