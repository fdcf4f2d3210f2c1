/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "buckledPart.H"
#include "surfaceFold.H"

namespace
{

//- Change of the angle over an edge that counts [rad]
constexpr Foam::scalar least = 0.1;

}


Foam::scalar Foam::buckledPart(const closedSurface& surface, const pointField& x)
{
    const scalarField A(surface.nodeAreas(x));
    scalarField H(A.size(), Zero);
    for (const closedSurface::hinge& h : surface.hinges())
    {
        const surfaceFold f(h, x);
        const scalar quarter = 0.25*f.length*f.angle;
        H[h.i] += quarter;
        H[h.j] += quarter;
    }
    H /= A;

    scalarField around(A.size(), Zero);
    labelList number(A.size(), 0);
    for (const closedSurface::hinge& h : surface.hinges())
    {
        around[h.i] += H[h.j];
        around[h.j] += H[h.i];
        ++number[h.i];
        ++number[h.j];
    }

    const scalar d = surface.edgeLength(x);
    scalar buckled = 0;
    forAll(A, i)
    {
        const scalar mean = around[i]/number[i];
        const scalar deviation = mag(H[i] - mean);
        if (deviation > mag(mean) && deviation*d > least)
        {
            buckled += A[i];
        }
    }
    return buckled/sum(A);
}
