/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "icosphere.H"
#include "closedSurface.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(icosphere, 0);
    addToRunTimeSelectionTable(shape, icosphere, dictionary);
}
}


Foam::clumpShapes::icosphere::icosphere(const dictionary& dict)
{
    checkEntries(dict, {"type", "radius", "subdivisions"});

    const scalar R = getPositive(dict, "radius");
    setIcosphere(getNumberOrDefault(dict, "subdivisions", 3, 1, maxSubdivisions));

    const closedSurface surface(centres_, triangles_, dict);
    const scalar sphere = constant::mathematical::pi*4.0/3.0;
    centres_ *= R*Foam::cbrt(sphere/surface.volume(centres_));
    setRadii(dict);
}
