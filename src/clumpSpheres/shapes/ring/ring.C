/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "ring.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(ring, 0);
    addToRunTimeSelectionTable(shape, ring, dictionary);
}
}


Foam::clumpShapes::ring::ring
(
    const dictionary& dict,
    const wordList& derived
)
{
    checkEntries
    (
        dict,
        {
            "type", "nSpheres", "ringRadius", "diameter", "sphereRadius",
            "volume", "hullVolume"
        },
        derived
    );

    const label n = getNumber(dict, "nSpheres", 3, maxSpheres);
    const scalar r = sphereRadius(dict, n, derived.size());
    const scalar R = radius(dict, r);

    centres_.setSize(n);
    radii_ = scalarField(n, r);
    bonds_.setSize(n);

    forAll(centres_, i)
    {
        const scalar angle = constant::mathematical::twoPi*i/n;
        centres_[i] = R*vector(Foam::cos(angle), Foam::sin(angle), 0);
        bonds_[i] = labelPair(i, (i + 1) % n);
    }
}


Foam::scalar Foam::clumpShapes::ring::radius
(
    const dictionary& dict,
    const scalar sphereRadius
)
{
    if (!dict.found("diameter"))
    {
        return getPositive(dict, "ringRadius");
    }
    if (dict.found("ringRadius"))
    {
        FatalIOErrorInFunction(dict)
            << "Give exactly one of 'ringRadius' and 'diameter'."
            << exit(FatalIOError);
    }

    return
        0.5*getBetween(dict, "diameter", 2*sphereRadius, largestEntry)
      - sphereRadius;
}


Foam::scalar Foam::clumpShapes::ring::volume
(
    const label n,
    const scalar R,
    const scalar r
)
{
    using constant::mathematical::pi;
    const scalar half = pi/n;

    if (r <= R)
    {
        const scalar h = max(r - R*Foam::sin(half), scalar(0));
        return n*pi*(4*pow3(r) - 2*sqr(h)*(3*r - h))/3;
    }

    // int_{-c}^{a} 2 sqrt(a^2 - u^2) (u + c) du with u = rho - c, in [0, half]
    const auto slice = [&](const scalar phi)
    {
        const scalar c = R*Foam::cos(phi);
        const scalar a = Foam::sqrt(sqr(r) - sqr(R*Foam::sin(phi)));
        const scalar b = Foam::sqrt(sqr(a) - sqr(c));
        return
            2.0/3.0*pow3(b)
          + c*(sqr(a)*(0.5*pi + Foam::asin(c/a)) + c*b);
    };

    const label nIntervals = 64;
    const scalar step = half/nIntervals;
    scalar sum = slice(0) + slice(half);
    for (label k = 1; k < nIntervals; ++k)
    {
        sum += (k % 2 ? 4 : 2)*slice(k*step);
    }
    return 2*n*sum*step/3;
}


Foam::scalar Foam::clumpShapes::ring::hullVolume
(
    const scalar R,
    const scalar r
)
{
    using constant::mathematical::pi;
    return pi*r*(2*sqr(R) + pi*R*r + 4*sqr(r)/3);
}


Foam::scalar Foam::clumpShapes::ring::sphereRadius
(
    const dictionary& dict,
    const label n,
    const bool disc
)
{
    using constant::mathematical::pi;

    const wordList ways({"sphereRadius", "volume", "hullVolume"});
    word given;
    for (const word& way : ways)
    {
        if (dict.found(way) && !given.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Give exactly one of " << flatOutput(ways) << '.'
                << exit(FatalIOError);
        }
        if (dict.found(way))
        {
            given = way;
        }
    }
    if (given.empty() || given == "sphereRadius")
    {
        return getPositive(dict, "sphereRadius");
    }
    if (disc)
    {
        FatalIOErrorInFunction(dict)
            << "Only a ring has the entry '" << given
            << "'; give 'sphereRadius'." << exit(FatalIOError);
    }

    const scalar V = getPositive(dict, given);
    const auto volumeOf = [&](const scalar r)
    {
        const scalar R = radius(dict, r);
        return given == "volume" ? volume(n, R, r) : hullVolume(R, r);
    };

    // Upper limit: the radius of a single sphere with this volume
    scalar high = Foam::cbrt(0.75*V/pi);
    if (dict.found("diameter"))
    {
        const scalar largest = 0.5*getPositive(dict, "diameter");
        if (high >= largest)
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << given << "' is " << V << "; it must be below "
                << 4*pi/3*pow3(largest) << ", the volume of a sphere with the"
                << " diameter of the ring." << exit(FatalIOError);
        }
    }

    scalar low = 0;
    for (label k = 0; k < 100 && high - low > 1e-15*high; ++k)
    {
        const scalar r = 0.5*(low + high);
        (volumeOf(r) < V ? low : high) = r;
    }
    return 0.5*(low + high);
}
