/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sharp.H"
#include "coveredCells.H"
#include "sphereUnion.H"

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
    displacement_(getNonNegativeOrDefault(dict, "displacement", 1.0/6)),
    full_(getPositiveOrDefault(dict, "fullCoefficient", 600))
{
    checkEntries(dict, {"type", "displacement", "fullCoefficient"});
}


Foam::forcingModel::surfaceInCell Foam::forcingModels::sharp::surface
(
    const cellGeometry& geometry,
    const label celli,
    const pointField& centres,
    const scalarField& radii
) const
{
    const scalar dx = geometry.width(celli);
    scalarField seenRadii(radii);
    for (scalar& r : seenRadii)
    {
        r += displacement_*sqr(dx)/r;
    }
    const auto distance = [&](const point& y)
    {
        return sphereUnion::distance(y, centres, seenRadii);
    };

    const scalar d = distance(geometry.mesh().cellCentres()[celli]);
    return
    {
        d < 0,
        d > 0 ? geometry.wallConductance(celli, d, distance) : 0
    };
}


void Foam::forcingModels::sharp::setStrength
(
    const cellGeometry& geometry,
    const scalarField& radii,
    const scalarField&,
    const scalarField& nu,
    const scalar dt,
    coveredCells& covered,
    scalarField& strength
) const
{
    const label n = radii.size();

    forAll(covered.cells, k)
    {
        const label celli = covered.cells[k];
        scalar S = nu[celli]*covered.wallConductance[k];

        if (covered.centreInside[k])
        {
            scalar radius = 0;
            for (label i = 0; i < n; ++i)
            {
                radius += covered.weights[n*k + i]*radii[i];
            }
            S = max
            (
                1/dt, full_*nu[celli]/(geometry.width(celli)*radius)
            );
        }
        covered.share[k] = S;
        strength[celli] += S;
    }
}
