/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bodyMoments.H"
#include "triSurface.H"

Foam::bodyMoments::bodyMoments(const triSurface& surface)
{
    // Of tetrahedra with a corner in the middle of the box around the surface: a
    // tetrahedron (0, a, b, d) has the moment v (a + b + d)/4 and the second moment
    // v (aa + bb + dd + ss)/20, s = a + b + d
    const pointField& x = surface.points();
    const point middle(boundBox(x, false).midpoint());
    vector first(Zero);
    for (const labelledTri& t : surface)
    {
        const vector a(x[t[0]] - middle);
        const vector b(x[t[1]] - middle);
        const vector d(x[t[2]] - middle);
        const scalar v = (a & (b ^ d))/6;
        volume += v;
        first += 0.25*v*(a + b + d);
        second += 0.05*v*(sqr(a) + sqr(b) + sqr(d) + sqr(a + b + d));
    }
    if (volume < 0)
    {
        volume *= -1;
        first *= -1;
        second *= -1;
    }
    const vector c(first/volume);
    second -= volume*sqr(c);
    centre = middle + c;
}


void Foam::bodyMoments::scale(const scalar factor)
{
    volume *= pow3(factor);
    centre *= factor;
    second *= pow5(factor);
}
