/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "filled.H"
#include "closedSurface.H"
#include "filledSurface.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(filled, 0);
    addToRunTimeSelectionTable(shape, filled, dictionary);
}
}


Foam::clumpShapes::filled::filled(const dictionary& dict)
{
    checkEntries(dict, {"type", "surface"});

    const dictionary& outer = getDict(dict, "surface");
    const auto shell(shape::New(outer));
    if (shell->kind() != kind())
    {
        FatalIOErrorInFunction(outer)
            << "Entry 'type' is " << getEntry<word>(outer, "type")
            << ", which has no closed surface. Valid here: icosphere, surfaceFile"
            << exit(FatalIOError);
    }
    const closedSurface surface(shell->centres(), shell->triangles(), outer);
    const filledSurface inside(surface.triangles(), surface.nNodes(), outer);
    if (inside.nNodes() > maxSpheres)
    {
        FatalIOErrorInFunction(outer)
            << "A surface of " << surface.nNodes() << " nodes needs "
            << inside.nNodes() - surface.nNodes() << " nodes inside; at most "
            << maxSpheres << " in all are possible. Give it fewer subdivisions."
            << exit(FatalIOError);
    }
    triangles_ = surface.triangles();
    centres_ = inside.nodes(shell->centres());
    for (const auto& t : inside.tetrahedra())
    {
        if (!(filledSurface::quality(t, centres_) > 0))
        {
            FatalIOErrorInFunction(outer)
                << "A tetrahedron inside the surface is turned over: the surface is too"
                << " far from a sphere to be filled." << exit(FatalIOError);
        }
    }
    radii_ = scalarField(centres_.size(), 0.5*surface.edgeLength(centres_));
}
