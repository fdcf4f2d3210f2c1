/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceFile.H"
#include "surfaceFileName.H"
#include "triSurface.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(surfaceFile, 0);
    addToRunTimeSelectionTable(shape, surfaceFile, dictionary);
}
}


Foam::clumpShapes::surfaceFile::surfaceFile(const dictionary& dict)
{
    checkEntries(dict, {"type", "file", "scale"});

    const fileName file(surfaceFileName(dict));
    if (!isFile(file))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file': there is no file " << file << '.'
            << exit(FatalIOError);
    }
    const triSurface surface(file);
    if (surface.nPoints() > maxSpheres || surface.nPoints() < 4)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file': the surface " << file << " has "
            << surface.nPoints() << " points; it must have 4 to " << maxSpheres
            << '.' << exit(FatalIOError);
    }

    centres_ =
        getPositiveOrDefault(dict, "scale", 1)*surface.localPoints();
    for (const point& x : centres_)
    {
        checkSize(dict, "file", x);
    }
    for (const labelledTri& t : surface.localFaces())
    {
        triangles_.append(triFace(t[0], t[1], t[2]));
    }
    setRadii(dict);
}
