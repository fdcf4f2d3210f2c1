/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hertz.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace contactModels
{
    defineTypeNameAndDebug(hertz, 0);
    addToRunTimeSelectionTable(contactModel, hertz, dictionary);
}
}


Foam::scalar Foam::contactModels::hertz::readModulus(const dictionary& dict)
{
    const bool byOverlap = dict.found("allowedOverlap");
    if (byOverlap && dict.found("reducedModulus"))
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'reducedModulus' and 'allowedOverlap' both give the"
            << " stiffness. Valid: one of them" << exit(FatalIOError);
    }
    if (!byOverlap)
    {
        if (dict.found("stress"))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'stress' needs the entry 'allowedOverlap', the overlap"
                << " under this stress." << exit(FatalIOError);
        }
        return getPositive(dict, "reducedModulus");
    }
    const scalar overlap = getBetween(dict, "allowedOverlap", 1e-4, 0.5);
    return
        3*constant::mathematical::pi*getPositive(dict, "stress")
       /Foam::pow(2*overlap, 1.5);
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
    modulus_(readModulus(dict)),
    friction_(getBetweenOrDefault(dict, "friction", 0, 0, 10)),
    rollingFriction_(getBetweenOrDefault(dict, "rollingFriction", 0, 0, 10)),
    damping_(0)
{
    checkEntries
    (
        dict,
        {
            "type", "reducedModulus", "allowedOverlap", "stress", "restitution",
            "friction", "rollingFriction"
        }
    );

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


Foam::contactModel::increment Foam::contactModels::hertz::step
(
    const scalar overlap,
    const scalar start,
    const scalar dt,
    const scalar R,
    const scalar mass
) const
{
    // F = d^(1/4) h(d) with h = k d^(5/4) + c (d - start)
    const scalar k = 4.0/3.0*modulus_*Foam::sqrt(R);
    const scalar c =
        2*Foam::sqrt(5.0/6.0)*damping_
       *Foam::sqrt(2*modulus_*Foam::sqrt(R)*mass)/dt;

    const auto potential = [&](const scalar d)
    {
        const scalar q = Foam::sqrt(Foam::sqrt(d));
        return d*q*(0.4*k*d*q + c*(d/2.25 - start/1.25));
    };

    // While the bodies part, the force ends at an overlap above zero, where the
    // damping would begin to attract. Newton's method: h is convex
    scalar free = 0;
    if (c > 0 && start > 0)
    {
        free = start;
        for (label n = 0; n < 30; ++n)
        {
            const scalar q = Foam::sqrt(Foam::sqrt(free));
            const scalar change =
                (k*free*q + c*(free - start))/(1.25*k*q + c);
            free = max(free - change, scalar(0));
            if (change <= 1e-15*start)
            {
                break;
            }
        }
    }
    if (overlap <= free)
    {
        return {0, 0, 0};
    }

    const scalar q = Foam::sqrt(Foam::sqrt(overlap));
    const scalar h = k*overlap*q + c*(overlap - start);
    return
    {
        potential(overlap) - potential(free),
        q*h,
        max(0.25*q/overlap*h + q*(1.25*k*q + c), scalar(0))
    };
}
