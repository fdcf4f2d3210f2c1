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
    const auto& triangles = surface().triangles();
    scalarField factors(triangles.size());
    forAll(factors, n)
    {
        const triFace& t = triangles[n];
        const scalar sum = start.layer[t[0]] + start.layer[t[1]] + start.layer[t[2]];
        factors[n] = sum/(3*start.duration);
    }
    return addRelative(start.from, factors, x, gradient, tangent);
}
