/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallDisplacement.H"
#include "movingWallVelocityFvPatchVectorField.H"
#include "polyMesh.H"
#include "volFields.H"
#include "wallContacts.H"
#include "wallPolyPatch.H"

Foam::scalar Foam::wayOfPoints(const polyPatch& patch)
{
    const polyMesh& mesh = patch.boundaryMesh().mesh();
    scalar way = 0;
    if (mesh.moving())
    {
        for (const label pointi : patch.meshPoints())
        {
            way = max(way, mag(mesh.points()[pointi] - mesh.oldPoints()[pointi]));
        }
    }
    return returnReduce(way, maxOp<scalar>());
}


bool Foam::pointsMove(const polyPatch& patch)
{
    return wayOfPoints(patch) > 0;
}


bool Foam::pointsSlide(const polyPatch& patch)
{
    const polyMesh& mesh = patch.boundaryMesh().mesh();
    const auto* U = mesh.findObject<volVectorField>("U");
    const scalar way = wayOfPoints(patch);
    if
    (
        !U || way == 0
     || isA<movingWallVelocityFvPatchVectorField>(U->boundaryField()[patch.index()])
    )
    {
        return false;
    }
    scalar swept = 0;
    for (const face& f : patch)
    {
        const scalar volume = mag(f.sweptVol(mesh.oldPoints(), mesh.points()));
        swept = max(swept, volume/f.mag(mesh.points()));
    }
    return returnReduce(swept, maxOp<scalar>()) < 1e-6*way;
}


bool Foam::wallsMove(const polyMesh& mesh)
{
    bool move = false;
    if (mesh.moving())
    {
        for (label i = 0; i < mesh.boundaryMesh().nNonProcessor(); ++i)
        {
            const polyPatch& patch = mesh.boundaryMesh()[i];
            move = move || (isA<wallPolyPatch>(patch) && pointsMove(patch));
        }
    }
    return move;
}


Foam::vector Foam::wallDisplacement
(
    const wallContacts& walls,
    const polyPatch& patch,
    const point& x,
    const scalar dt
)
{
    const vector slides(dt*walls.velocity(patch.index(), x));
    if (!patch.boundaryMesh().mesh().moving())
    {
        return slides;
    }
    constexpr label nIterations = 3;
    vector moved(Zero);
    for (label n = 0; n < nIterations; ++n)
    {
        wallSurface::nearPlace place;
        const bool found =
            walls.surface().nearest(x + moved, walls.surface().known(), place);
        if (!found || place.patch != patch.index())
        {
            break;
        }
        moved = place.moved;
    }
    return slides + moved;
}
