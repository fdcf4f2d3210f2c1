/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "boundModel.H"

namespace Foam
{
    defineTypeNameAndDebug(boundModel, 0);
    defineRunTimeSelectionTable(boundModel, dictionary);
}


Foam::scalar Foam::boundModel::chord(const scalar from, const scalar to) const
{
    const scalar c0 = max(from, scalar(0));
    const scalar c1 = max(to, scalar(0));

    // The difference of close values has too few digits
    return
        mag(c1 - c0) <= 1e-4*max(c0, c1)
      ? capacity(0.5*(c0 + c1))
      : (bound(c1) - bound(c0))/(c1 - c0);
}


Foam::scalar Foam::boundModel::free(const scalar a, const scalar h) const
{
    scalar low = 0;
    scalar high = max(h/a, scalar(0));
    if (h <= 0 || a*high + bound(high) <= h)
    {
        return h/a;
    }

    // Newton, with halved intervals where it leaves them: b(c) may have an inflection
    scalar c = 0.5*high;
    for (label n = 0; n < 200 && high - low > 1e-15*high; ++n)
    {
        const scalar rest = a*c + bound(c) - h;
        (rest > 0 ? high : low) = c;
        const scalar next = c - rest/(a + capacity(c));
        if (mag(next - c) <= 1e-15*c)
        {
            break;
        }
        c = next > low && next < high ? next : 0.5*(low + high);
    }
    return c;
}
