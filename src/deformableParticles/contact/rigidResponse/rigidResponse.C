/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rigidResponse.H"
#include "clumpType.H"

Foam::rigidResponse::rigidResponse
(
    const clumpType& type,
    const pointField& x
)
:
    oneByMass_(0),
    centre_(Zero),
    oneByInertia_(Zero)
{
    if (!type.fixed())
    {
        clumpState s;
        s.x = x;
        oneByMass_ = 1/type.mass();
        centre_ = s.centre(type);

        // Scaled to order one: the inverse's determinant would underflow
        const tensor I(s.inertia(type));
        const scalar scale = tr(I);
        oneByInertia_ = inv(I/scale)/scale;
    }
}
