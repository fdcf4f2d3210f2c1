/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpContour.H"
#include "addToRunTimeSelectionTable.H"
#include "outline.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpContour, 0);
    addToRunTimeSelectionTable(functionObject, clumpContour, dictionary);
}
}


Foam::functionObjects::clumpContour::clumpContour
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    clumpTable(name, runTime, dict, typeName)
{
    read(dict);
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpContour::header() const
{
    return
        tableHeader("Outline of each clump in the plane of flow and gradient")
       .add("area", "m2").add("perimeter", "m").add("circularity")
       .add("hullArea", "m2").add("hullPerimeter", "m").add("hullCircularity")
       .add("deformation").add("inertiaRatio")
       .explain("area perimeter circularity", "of the outline, without holes; circularity"
            " is 2 sqrt(pi area)/perimeter")
       .explain("hullArea hullPerimeter hullCircularity", "of its convex hull")
       .explain("deformation", "1 - hullCircularity")
       .explain("inertiaRatio", "of the outline: root of the second moment of its area"
            " along the flow over that along the gradient");
}


Foam::string Foam::functionObjects::clumpContour::row
(
    const clumpParcel& p,
    const clumpType& type
) const
{
    const clumpState& s = p.state();
    List<vector2D> places(s.x.size());
    forAll(places, i)
    {
        const vector d(s.x[i] - s.x[0]);
        places[i] = vector2D(d & flow(), d & gradient());
    }
    const bool surface = type.hasTriangles();
    const scalarField radii(surface ? scalarField(places.size(), Zero) : type.radii());
    const outline hull(outline::hull(places, radii));
    const outline whole
    (
        surface
      ? outline::ofSurface(type.surface(), s.x, flow(), gradient())
      : outline::ofDiscs(places, radii)
    );
    return columns
    (
        {
            whole.area(),
            whole.perimeter(),
            whole.circularity(),
            hull.area(),
            hull.perimeter(),
            hull.circularity(),
            1 - hull.circularity(),
            whole.inertiaRatio()
        }
    );
}
