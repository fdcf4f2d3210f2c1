/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gapModel.H"

namespace Foam
{
    defineTypeNameAndDebug(gapModel, 0);
    defineRunTimeSelectionTable(gapModel, dictionary);
}


Foam::gapModel::radii::radii
(
    const scalar radius,
    const symmTensor& curvature
)
{
    // The principal curvatures from their sum and the sum of their squares
    const scalar sum = tr(curvature);
    const scalar difference =
        Foam::sqrt(max(2*magSqr(curvature) - sqr(sum), scalar(0)));
    const auto ofGap = [&](const scalar k)
    {
        return 1/max(1/radius + k, 0.1/radius);
    };
    first = ofGap(0.5*(sum + difference));
    second = ofGap(0.5*(sum - difference));
}
