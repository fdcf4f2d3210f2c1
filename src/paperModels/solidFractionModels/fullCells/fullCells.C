/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fullCells.H"
#include "sphereUnion.H"

namespace Foam
{
namespace solidFractionModels
{
    defineTypeNameAndDebug(fullCells, 0);
    addToRunTimeSelectionTable(solidFractionModel, fullCells, dictionary);
}
}


Foam::solidFractionModels::fullCells::fullCells(const dictionary& dict)
{
    checkEntries(dict, {"type"});
}


Foam::scalar Foam::solidFractionModels::fullCells::fraction
(
    const cellGeometry& geometry,
    const label celli,
    const scalar,
    const UList<point>& centres,
    const UList<scalar>& radii
) const
{
    const fvMesh& mesh = geometry.mesh();
    for (const label pointi : mesh.cellPoints()[celli])
    {
        if (sphereUnion::distance(mesh.points()[pointi], centres, radii) > 0)
        {
            return 0;
        }
    }
    return 1;
}
