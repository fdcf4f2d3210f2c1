/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "relaxation.H"
#include "equilibrium.H"
#include "implicitEuler.H"
#include "StringStream.H"

namespace Foam
{
namespace mechanicalTests
{
    defineTypeNameAndDebug(relaxation, 0);
    addToRunTimeSelectionTable(mechanicalTest, relaxation, dictionary);
}
}


Foam::mechanicalTests::relaxation::relaxation(const dictionary& dict)
:
    mechanicalTest(dict),
    initialRatio_
    (
        dict.getCheck<scalar>("initialRatio", [](scalar x){ return x > 1; })
    ),
    timeStep_(getPositive(dict, "timeStep"))
{}


Foam::scalar Foam::mechanicalTests::relaxation::ratio
(
    const clumpType& type,
    const clumpState& s
) const
{
    const Pair<scalar> lengths(extents(type, s.x));
    return lengths.first()/lengths.second();
}


Foam::scalar Foam::mechanicalTests::relaxation::stretch
(
    const clumpBonds& bonds,
    clumpState& s
) const
{
    const clumpType& type = bonds.type();
    const equilibrium solver;
    const auto ratioAt = [&](const scalar force)
    {
        solver.find(bonds, pull(type, force), s);
        return ratio(type, s);
    };

    // The force doubles until the ratio is passed, then bisection. The first
    // one would shear a bond by 1e-3 of its length.
    const clumpBonds::bond& b = bonds.bonds()[0];
    scalar low = 0;
    scalar high = 1e-3*b.stiffness.normal*b.length;
    while (ratioAt(high) < initialRatio_)
    {
        low = high;
        high *= 2;
        if (high > 1e4*b.stiffness.normal*b.length)
        {
            return -1;
        }
    }
    while (high - low > 1e-9*high)
    {
        const scalar middle = 0.5*(low + high);
        (ratioAt(middle) < initialRatio_ ? low : high) = middle;
    }
    return high;
}


void Foam::mechanicalTests::relaxation::refuseMembrane
(
    const dictionary& type
) const
{
    if (clumpType("fit", type).hasTriangles())
    {
        FatalIOErrorInFunction(type)
            << "The test relaxation is without a fluid, which slows a membrane down by"
            << " a quarter: compare a case with a fluid instead, as in"
            << " validation/redCell." << exit(FatalIOError);
    }
}


Foam::List<Foam::scalarField> Foam::mechanicalTests::relaxation::predict
(
    const dictionary& dict,
    const UList<scalar>& times,
    label* unstable
) const
{
    refuseMembrane(dict);
    const bondedClump clump("fit", dict);
    const clumpType& type = clump.type;
    List<scalarField> result(1, scalarField(times.size(), GREAT));
    if (unstable)
    {
        *unstable = 0;
    }

    clumpState s(type);
    if (stretch(clump.bonds, s) < 0)
    {
        return result;
    }

    const dictionary numerics
    (
        IStringStream("tolerance 1e-9; maxIterations 100;")()
    );
    const integrators::implicitEuler integrator(numerics);
    const externalForces free(type.size());

    scalar now = 0;
    forAll(times, k)
    {
        const scalar interval = times[k] - now;
        const label n = label(std::ceil(interval/timeStep_ - 1e-9));
        for (label step = 0; step < n; ++step)
        {
            integrator.advance(clump.bonds, free, interval/n, s);
        }
        now = times[k];
        result[0][k] = ratio(type, s);
    }

    return result;
}


Foam::dictionary Foam::mechanicalTests::relaxation::loads
(
    const dictionary& dict,
    const scalar
) const
{
    const bondedClump clump("fit", dict);
    clumpState s(clump.type);
    const scalar force = stretch(clump.bonds, s);
    dictionary result;
    if (force > 0)
    {
        result.set("untilRelease", oppositeForces(clump.type, force));
    }
    return result;
}
