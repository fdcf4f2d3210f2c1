/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "layerViscosity.H"

Foam::triangleElasticity::response Foam::layerViscosity::law
(
    const scalar I1,
    const scalar I2
) const
{
    return
    {
        0.5*sqr(I1) + 0.5*(I1 - I2), I1 + 0.5, -0.5, 1, 0, 0
    };
}


Foam::scalar Foam::layerViscosity::addRate
(
    const pointField& x,
    const motion& start,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    scalar potential = 0;
    for (const triFace& t : surface().triangles())
    {
        const scalar viscosity =
            (start.layer[t[0]] + start.layer[t[1]] + start.layer[t[2]])/3;
        potential += addTriangle
        (
            t, rest(t, start.from), viscosity/start.span, x, gradient, tangent
        );
    }
    return potential;
}
