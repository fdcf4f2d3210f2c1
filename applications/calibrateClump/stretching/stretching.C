/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stretching.H"
#include "equilibrium.H"

namespace Foam
{
namespace mechanicalTests
{
    defineTypeNameAndDebug(stretching, 0);
    addToRunTimeSelectionTable(mechanicalTest, stretching, dictionary);
}
}


Foam::List<Foam::scalarField> Foam::mechanicalTests::stretching::predict
(
    const clumpBonds& bonds,
    const UList<scalar>& forces,
    label* unstable
) const
{
    const clumpType& type = bonds.type();
    List<scalarField> result(2, scalarField(forces.size(), GREAT));
    const equilibrium solver;
    clumpState s(type);
    if (unstable)
    {
        *unstable = 0;
    }

    forAll(forces, k)
    {
        const auto ext
        (
            equilibrium::stretch(type, vector(forces[k], 0, 0))
        );
        if (!solver.find(bonds, ext, s))
        {
            s = clumpState(type);
            continue;
        }

        const vector directions[2] = {vector(1, 0, 0), vector(0, 1, 0)};
        for (label q = 0; q < 2; ++q)
        {
            result[q][k] =
                clumpExtent::along(directions[q], s.x, type.radii(), reading_);
        }

        if (unstable)
        {
            // Zero within the error of the differences: the rigid motions
            const scalarField k(equilibrium::spectrum(bonds, ext, s));
            *unstable += k[0] < -1e-7*k.last();
        }
    }

    return result;
}


Foam::dictionary Foam::mechanicalTests::stretching::loads
(
    const clumpBonds& bonds,
    const scalar force
) const
{
    dictionary result;
    result.set("stretch", oppositeForces(bonds.type(), force));
    return result;
}
