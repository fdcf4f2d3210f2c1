/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpExtent.H"
#include "mathematicalConstants.H"

const Foam::Enum<Foam::clumpExtent::reading> Foam::clumpExtent::readingNames
({
    { reading::spheres, "spheres" },
    { reading::outline, "outline" }
});


namespace
{

using namespace Foam;

//- Largest value of the trigonometric polynomial through equidistant values
scalar trigonometricMax(const scalarField& values)
{
    const label n = values.size();
    const scalar step = constant::mathematical::twoPi/n;

    // Coefficients; for even n the highest cosine counts half
    const label order = n/2;
    scalarField a(order + 1, Zero), b(order + 1, Zero);
    for (label k = 0; k <= order; ++k)
    {
        const scalar weight = (k == 0 || 2*k == n ? 1.0 : 2.0)/n;
        forAll(values, i)
        {
            a[k] += weight*values[i]*Foam::cos(k*step*i);
            b[k] += weight*values[i]*Foam::sin(k*step*i);
        }
    }

    const auto at = [&](const scalar s, const label derivative)
    {
        scalar sum = derivative ? 0 : a[0];
        for (label k = 1; k <= order; ++k)
        {
            const scalar c = Foam::cos(k*s);
            const scalar d = Foam::sin(k*s);
            sum +=
                derivative == 0 ? a[k]*c + b[k]*d
              : derivative == 1 ? k*(b[k]*c - a[k]*d)
              : -k*k*(a[k]*c + b[k]*d);
        }
        return sum;
    };

    // The best of a fine scan, then Newton
    scalar best = 0;
    for (label i = 1; i < 16*n; ++i)
    {
        const scalar s = step*i/16;
        if (at(s, 0) > at(best, 0))
        {
            best = s;
        }
    }
    scalar s = best;
    for (label i = 0; i < 5; ++i)
    {
        const scalar curvature = at(s, 2);
        if (curvature < 0)
        {
            s -= max(min(at(s, 1)/curvature, step/16), -step/16);
        }
    }
    return max(at(s, 0), at(best, 0));
}

}


Foam::scalar Foam::clumpExtent::along
(
    const vector& direction,
    const pointField& centres,
    const scalarField& radii,
    const reading how
)
{
    const scalarField s(centres & direction);

    if (how == reading::spheres)
    {
        return max(s + radii) - min(s - radii);
    }
    return trigonometricMax(s) + trigonometricMax(-s) + 2*max(radii);
}
