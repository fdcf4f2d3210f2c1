/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactModel.H"
#include "mathematicalConstants.H"

namespace Foam
{
    defineTypeNameAndDebug(contactModel, 0);
    defineRunTimeSelectionTable(contactModel, dictionary);
}


Foam::contactModel::pressure Foam::contactModel::surfacePressure
(
    const scalar overlap,
    const scalar R
) const
{
    if (overlap <= 0)
    {
        return {0, 0, 0};
    }

    // Nothing is damped in a step without end
    const auto elastic = [&](const scalar d)
    {
        return step(d, d, GREAT, R, 0);
    };
    const increment at(elastic(overlap));
    const scalar h = 1e-3*overlap;
    const scalar slope =
        0.5*(elastic(overlap + h).stiffness - elastic(overlap - h).stiffness)/h;
    const scalar perArea = 1/(2*constant::mathematical::pi*R);
    return
    {
        perArea*at.force, perArea*at.stiffness, perArea*max(slope, scalar(0))
    };
}
