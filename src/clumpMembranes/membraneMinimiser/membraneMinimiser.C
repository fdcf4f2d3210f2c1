/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneMinimiser.H"
#include "membraneFactors.H"

namespace
{

Foam::vectorField toField(const Eigen::VectorXd& v)
{
    Foam::vectorField result(v.size()/3);
    forAll(result, i)
    {
        result[i] = Foam::vector(v[3*i], v[3*i + 1], v[3*i + 2]);
    }
    return result;
}

}


Foam::membraneMinimiser::membraneMinimiser
(
    const clumpType& type,
    const label neighbourOrder,
    const labelListList& more
)
:
    type_(type),
    tangent_(type_.surface(), neighbourOrder, more)
{}


Foam::scalar Foam::membraneMinimiser::linearise
(
    const potential& phi,
    const vectorField& y,
    const scalar p,
    const scalar concave,
    vectorField& gradient
) const
{
    tangent_.clear(concave);
    const scalar result = phi(y, gradient, &tangent_);
    if (concave > 0)
    {
        tangent_.addPressure(type_.surface(), y, concave*p);
    }
    return result;
}


bool Foam::membraneMinimiser::factorise
(
    const potential& phi,
    const vectorField& y,
    const scalar p,
    membraneFactors& factors
) const
{
    bool done = factors.factorise(tangent_);
    vectorField unused(y.size());
    for (const scalar concave : {0.8, 0.4, 0.0})
    {
        if (!done)
        {
            linearise(phi, y, p, concave, unused);
            done = factors.factorise(tangent_);
        }
    }
    return done;
}


bool Foam::membraneMinimiser::solve
(
    const vectorField& left,
    const vectorField& volumeGradient,
    membraneFactors& factors,
    Eigen::VectorXd& free
) const
{
    const auto asVector = membraneTangent::asVector;
    free.resize(0);
    return
        tangent_.solve(-asVector(left), factors, free)
     && tangent_.solve(asVector(volumeGradient), factors, factors.pressureResponse);
}


Foam::scalar Foam::membraneMinimiser::lineSearch
(
    const potential& phi,
    const vectorField& dy,
    const scalar merit,
    const scalar slope,
    const scalar penalty,
    vectorField& y
) const
{
    const scalar V0 = type_.volume();

    // Near the minimum the difference of two values is round-off
    const bool near = max(mag(dy)) < 1e-6*type_.halfWidth();
    for (scalar part = 1; part > 1e-6; part *= 0.5)
    {
        vectorField unused(y.size());
        const vectorField tried(y + part*dy);
        const scalar there =
            phi(tried, unused, nullptr)
          + penalty*mag(type_.surface().volume(tried) - V0);
        if (near || there <= merit + 1e-4*part*slope)
        {
            y = tried;
            return part;
        }
    }
    return 0;
}


bool Foam::membraneMinimiser::minimise
(
    const potential& phi,
    membraneFactors& factors,
    vectorField& y,
    const scalar reduction,
    const label most
) const
{
    constexpr scalar tolerance = 1e-6;
    scalar& p = factors.pressure;
    scalar change = GREAT;

    scalar allowed = tolerance;
    bool maySuffice = true;
    for (label n = 0; n < most && !(maySuffice && change <= allowed); ++n)
    {
        const vectorField volumeGradient(type_.surface().areaVectors(y));
        vectorField gradient(y.size());
        const scalar value0 = linearise(phi, y, p, 1, gradient);

        // What is left with the last pressure: of the whole gradient, even a small
        // error would hide what the volume leaves of it
        const vectorField left(gradient - p*volumeGradient);

        // The last factors do, unless the tangent has changed too much
        Eigen::VectorXd free;
        if (!(factors.usable() && solve(left, volumeGradient, factors, free)))
        {
            if
            (
                !factorise(phi, y, p, factors)
             || !solve(left, volumeGradient, factors, free)
            )
            {
                break;
            }
        }

        // With the pressure that brings the volume back
        const scalar excess = type_.surface().volume(y) - type_.volume();
        const auto g = membraneTangent::asVector(volumeGradient);
        const scalar dp = -(excess + g.dot(free))/g.dot(factors.pressureResponse);
        const vectorField dy(toField(free + dp*factors.pressureResponse));
        p += dp;

        const scalar penalty = 2*mag(p);
        const scalar part = lineSearch
        (
            phi, dy,
            value0 + penalty*mag(excess),
            sum(gradient & dy) - penalty*mag(excess),
            penalty, y
        );
        change = max(mag(dy))/type_.halfWidth();
        allowed = max(allowed, reduction*part*change);
        const scalar off = mag(type_.surface().volume(y) - type_.volume());
        maySuffice = part == 0 || (part == 1 && off <= 1e-10*type_.volume());
        if (part == 0)
        {
            break;
        }
    }
    return maySuffice && change <= allowed;
}
