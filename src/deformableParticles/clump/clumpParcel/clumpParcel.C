/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"

namespace Foam
{
    defineTypeNameAndDebug(clumpParcel, 0);
    defineTemplateTypeNameAndDebug(Cloud<clumpParcel>, 0);
}


Foam::clumpParcel::clumpParcel
(
    const polyMesh& mesh,
    const point& position,
    const label celli,
    const label typeId,
    const clumpState& state
)
:
    particle(mesh, position, celli),
    typeId_(typeId),
    state_(state),
    fluidForces_(state.x.size(), Zero),
    fluidTorques_(state.x.size(), Zero),
    displacement_(Zero),
    target_(position)
{}


void Foam::clumpParcel::recentre(const clumpType& type)
{
    displacement_ = state_.centre(type);
    target_ = position() + displacement_;
    state_.x -= displacement_;
}


bool Foam::clumpParcel::move
(
    deformableCloud& cloud,
    trackingData& td,
    const scalar
)
{
    td.switchProcessor = false;
    td.keepParticle = true;

    while (td.keepParticle && !td.switchProcessor && stepFraction() < 1)
    {
        const scalar f = 1 - stepFraction();
        trackToAndHitFace(f*displacement_, f, cloud, td);
    }

    if (td.keepParticle && !td.switchProcessor)
    {
        state_.x += target_ - position();
    }

    return td.keepParticle;
}


void Foam::clumpParcel::hitWallPatch(deformableCloud&, trackingData&)
{
    const vector n(normal());
    displacement_ -= max(displacement_ & n, scalar(0))*n;
}
