/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sharp.H"
#include "coveredCells.H"
#include "sphereDistance.H"

namespace Foam
{
namespace forcingModels
{
    defineTypeNameAndDebug(sharp, 0);
    addToRunTimeSelectionTable(forcingModel, sharp, dictionary);
}
}


Foam::forcingModels::sharp::sharp(const dictionary& dict)
:
    displacement_(getBetweenOrDefault(dict, "displacement", 1.0/6, 0, 1)),
    full_(getPositiveOrDefault(dict, "fullCoefficient", 600))
{
    checkEntries(dict, {"type", "displacement", "fullCoefficient"});
}


Foam::forcingModel::surfaceInCell Foam::forcingModels::sharp::surface
(
    const cellGeometry& geometry,
    const label celli,
    const scalar d,
    const sphereDistance& distance
) const
{
    // The surface the model sees is outside
    if (d < 0)
    {
        return {true, 0};
    }

    const scalar kdx2 = displacement_*sqr(geometry[celli].width);
    const auto seenRadius = [kdx2](const scalar r) { return r + kdx2/r; };
    const auto seen = [&](const point& y) { return distance(y, seenRadius); };

    const scalar a = seen(geometry[celli].x);
    return
    {
        a < 0, a > 0 ? geometry.wallConductance(celli, a, seen) : 0
    };
}


void Foam::forcingModels::sharp::setStrength
(
    const cellGeometry& geometry,
    const scalarField& radii,
    const scalarField&,
    const scalarField& nu,
    const scalar dt,
    const bool follows,
    coveredCells& covered,
    scalarField& strength
) const
{
    forAll(covered.cells(), k)
    {
        coveredCell& c = covered.cells()[k];
        scalar S = nu[c.celli]*c.wallConductance;

        if (c.centreInside)
        {
            scalar radius = 0;
            for (const sphereWeight& s : covered.weights(k))
            {
                radius += s.w*radii[s.i];
            }
            const scalar inertia = !follows ? 1/dt : c.moves() ? full_/dt : 0;
            S = max
            (
                inertia, full_*nu[c.celli]/(geometry[c.celli].width*radius)
            );
        }
        c.forcingWeight = S;
        strength[c.celli] += S;
    }
}
