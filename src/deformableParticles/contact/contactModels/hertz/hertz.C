/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hertz.H"

namespace Foam
{
namespace contactModels
{
    defineTypeNameAndDebug(hertz, 0);
    addToRunTimeSelectionTable(contactModel, hertz, dictionary);
}
}


Foam::scalar Foam::contactModels::hertz::restitution(const scalar b)
{
    // Time step a thousandth of the duration of the elastic contact (3.2) and
    // shorter than the damping's own time
    const scalar dt = 3e-3/(1 + b);
    scalar x = 0, v = 1;

    do
    {
        // Semi-implicit in the damping: stable for any b
        const scalar c = 2*Foam::sqrt(5.0/6.0)*b*Foam::pow(max(x, VSMALL), 0.25);
        const scalar f = 2.0/3.0*Foam::pow(x, 1.5);
        const scalar next = (v - dt*f)/(1 + dt*c);

        // Only while it pushes
        v = f + c*next > 0 ? next : v;
        x += dt*v;
    } while (x > 0);

    return -v;
}


Foam::contactModels::hertz::hertz(const dictionary& dict)
:
    modulus_(getPositive(dict, "reducedModulus")),
    damping_(0)
{
    checkEntries(dict, {"type", "reducedModulus", "restitution"});

    const scalar e = getBetween(dict, "restitution", 0.01, 1);

    if (e < 1)
    {
        scalar low = 0, high = 1;
        while (restitution(high) > e)
        {
            high *= 2;
        }
        for (label i = 0; i < 40; ++i)
        {
            const scalar middle = 0.5*(low + high);
            (restitution(middle) > e ? low : high) = middle;
        }
        damping_ = 0.5*(low + high);
    }
}
