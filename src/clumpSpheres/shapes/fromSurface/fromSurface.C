/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fromSurface.H"
#include "mathematicalConstants.H"
#include "sphereFilling.H"
#include "surfaceFileName.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(fromSurface, 0);
    addToRunTimeSelectionTable(shape, fromSurface, dictionary);
}
}


namespace
{

using namespace Foam;

//- The closed surface of a file, in a box whose longest side is one; length: that of this
//  side in the units of the file
triSurface readClosed(const dictionary& dict, scalar& length)
{
    const fileName file(surfaceFileName(dict));
    if (!isFile(file) || !triSurface::canRead(file))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file': there is no surface that can be read in " << file
            << exit(FatalIOError);
    }
    triSurface result(file);
    label nOpen = 0;
    for (const labelList& faces : result.edgeFaces())
    {
        nOpen += faces.size() != 2;
    }
    if (result.empty() || nOpen)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file': the surface in " << file << " is not closed; of its "
            << result.nEdges() << " edges " << nOpen << " do not have two triangles."
            << exit(FatalIOError);
    }

    // Tolerances of OpenFOAM's search are those of a length of one
    const boundBox box(result.points(), false);
    if (cmptMin(box.span()) <= 0 || !physical(box.span()))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file': the surface in " << file << " has no volume; it lies in "
            << box << exit(FatalIOError);
    }
    length = cmptMax(box.span());
    result.movePoints(pointField((result.points() - box.midpoint())/length));
    return result;
}

}


Foam::clumpShapes::fromSurface::fromSurface(const dictionary& dict)
{
    checkEntries(dict, {"type", "file", "scale", "error", "maxSpheres"});
    const scalar scale = getPositiveOrDefault(dict, "scale", 1);
    const scalar error = getBetweenOrDefault(dict, "error", 0.1, 0.005, 0.5);
    const label most = getNumberOrDefault(dict, "maxSpheres", 200, 1, maxSpheres);

    scalar length = 1;
    const triSurface surface(readClosed(dict, length));
    const sphereFilling filling(surface, error, most);
    if (filling.uncovered() > error)
    {
        FatalIOErrorInFunction(dict)
            << "The " << filling.centres().size() << " spheres leave "
            << filling.uncovered() << " of the volume uncovered; 'error' is " << error
            << ". Allow a larger error or more than the " << most
            << " spheres of 'maxSpheres'." << exit(FatalIOError);
    }
    length *= scale;
    centres_ = length*pointField(filling.centres());
    radii_ = length*scalarField(filling.radii());
    bonds_ = filling.tree();

    moments_ = bodyMoments(surface);
    moments_.scale(length);

    const scalar V = mag(sphereFilling::volume(surface));
    const scalar R = Foam::cbrt(0.75*V/constant::mathematical::pi);
    Info<< "Surface " << dict.get<fileName>("file") << ": " << radii_.size()
        << " spheres, volume " << V*pow3(length) << " m3 with an error of "
        << filling.volumeError() << ", distance of the surfaces "
        << filling.meanDistance()/R << " (root mean square) and "
        << filling.largestDistance()/R << " (largest) of the radius of its volume"
        << endl;
}
