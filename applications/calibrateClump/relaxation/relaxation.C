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
    return
        clumpExtent::along(vector(1, 0, 0), s.x, type.radii(), reading_)
       /clumpExtent::along(vector(0, 1, 0), s.x, type.radii(), reading_);
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
        solver.find
        (
            bonds, equilibrium::stretch(type, vector(force, 0, 0)), s
        );
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


Foam::List<Foam::scalarField> Foam::mechanicalTests::relaxation::predict
(
    const clumpBonds& bonds,
    const UList<scalar>& times,
    label* unstable
) const
{
    const clumpType& type = bonds.type();
    List<scalarField> result(1, scalarField(times.size(), GREAT));
    if (unstable)
    {
        *unstable = 0;
    }

    clumpState s(type);
    if (stretch(bonds, s) < 0)
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
        const scalar span = times[k] - now;
        const label n = label(std::ceil(span/timeStep_ - 1e-9));
        for (label step = 0; step < n; ++step)
        {
            integrator.advance(bonds, free, span/n, s);
        }
        now = times[k];
        result[0][k] = ratio(type, s);
    }

    return result;
}


Foam::dictionary Foam::mechanicalTests::relaxation::loads
(
    const clumpBonds& bonds,
    const scalar
) const
{
    clumpState s(bonds.type());
    const scalar force = stretch(bonds, s);
    dictionary result;
    if (force > 0)
    {
        result.set("untilRelease", oppositeForces(bonds.type(), force));
    }
    return result;
}
