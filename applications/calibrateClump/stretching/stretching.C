/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stretching.H"
#include "clumpBonds.H"
#include "equilibrium.H"
#include "membraneEquilibrium.H"

namespace Foam
{
namespace mechanicalTests
{
    defineTypeNameAndDebug(stretching, 0);
    addToRunTimeSelectionTable(mechanicalTest, stretching, dictionary);
}
}


Foam::List<Foam::scalarField> Foam::mechanicalTests::stretching::ofNodes
(
    const clumpType& type,
    const dictionary& dict,
    const UList<scalar>& forces
) const
{
    const membraneEquilibrium solver(type, dict);
    List<scalarField> result(2, scalarField(forces.size(), GREAT));
    pointField x(type.centres());
    forAll(forces, k)
    {
        if (!solver.find(pull(type, forces[k]).f, x))
        {
            x = type.centres();
            continue;
        }
        const Pair<scalar> lengths(extents(type, x));
        for (label q = 0; q < 2; ++q)
        {
            result[q][k] = lengths[q];
        }
    }
    return result;
}


Foam::List<Foam::scalarField> Foam::mechanicalTests::stretching::predict
(
    const dictionary& dict,
    const UList<scalar>& forces,
    label* unstable
) const
{
    const bondedClump clump("fit", dict);
    if (unstable)
    {
        *unstable = 0;
    }
    if (clump.type.hasTriangles())
    {
        return ofNodes(clump.type, dict, forces);
    }

    List<scalarField> result(2, scalarField(forces.size(), GREAT));
    const equilibrium solver;
    clumpState s(clump.type);
    forAll(forces, k)
    {
        const auto ext(pull(clump.type, forces[k]));
        if (!solver.find(clump.bonds, ext, s))
        {
            s = clumpState(clump.type);
            continue;
        }

        const Pair<scalar> lengths(extents(clump.type, s.x));
        for (label q = 0; q < 2; ++q)
        {
            result[q][k] = lengths[q];
        }

        if (unstable)
        {
            // Zero within the error of the differences: the rigid motions
            const scalarField k(equilibrium::spectrum(clump.bonds, ext, s));
            *unstable += k[0] < -1e-7*k.last();
        }
    }

    return result;
}


Foam::dictionary Foam::mechanicalTests::stretching::loads
(
    const dictionary& dict,
    const scalar force
) const
{
    dictionary result;
    result.set("stretch", oppositeForces(clumpType("fit", dict), force));
    return result;
}
