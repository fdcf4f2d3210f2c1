/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "convectionCriterion.H"
#include "StringStream.H"
#include "clumpTotals.H"
#include "incompressibleFlow.H"

Foam::convectionCriterion::convectionCriterion
(
    const deformableCloud& cloud
)
:
    effects_(cloud.effects()),
    timing_(cloud.timing()),
    size_
    (
        max
        (
            Foam::cbrt(gSum(refCast<const fvMesh>(cloud.pMesh()).V())),
            largestDiameter(cloud)
        )
    )
{}


void Foam::convectionCriterion::decide(incompressibleFlow& flow) const
{
    const timeBreakdown::timer t(timing_, "checks");
    if (effects_.automatic("convection"))
    {
        const scalar Re =
            gMax(mag(flow.U().primitiveField()))*size_/flow.leastNu();
        const bool convects = Re > 0.05;

        OStringStream reason;
        reason.precision(3);
        reason << "Re " << Re << (convects ? " above" : " below") << " 0.05";
        effects_.decide("convection", convects, reason.str());
    }
}
