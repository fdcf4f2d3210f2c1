/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "planeInBox.H"

Foam::planeInBox::part Foam::planeInBox::behind
(
    const scalar distance,
    const vector& widths
)
{
    const scalar least = 1e-3*cmptSum(widths);
    const scalar a = max(widths.x(), least);
    const scalar b = max(widths.y(), least);
    const scalar c = max(widths.z(), least);
    const scalar w = a + b + c;
    const scalar t = 0.5*w - distance;
    if (t <= 0 || t >= w)
    {
        return part{scalar(t <= 0 ? 0 : 1), 0};
    }
    scalar cubes = 0;
    scalar squares = 0;
    const auto add = [&](const scalar sign, const scalar rest)
    {
        if (rest > 0)
        {
            cubes += sign*pow3(rest);
            squares += sign*sqr(rest);
        }
    };
    add(1, t);
    for (const scalar m : {a, b, c})
    {
        add(-1, t - m);
        add(1, t - (w - m));
    }
    const scalar product = 6*a*b*c;
    return part
    {
        min(max(cubes/product, scalar(0)), scalar(1)),
        max(3*squares/product, scalar(0))
    };
}
