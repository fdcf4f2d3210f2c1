/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fromFile.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(fromFile, 0);
    addToRunTimeSelectionTable(shape, fromFile, dictionary);
}
}


Foam::clumpShapes::fromFile::fromFile(const dictionary& dict)
{
    checkEntries(dict, {"type", "centres", "radii", "bonds"});

    centres_ = getFiniteList<point>(dict, "centres");
    radii_ = getFiniteList<scalar>(dict, "radii");
    dict.readEntry("bonds", bonds_);
}
