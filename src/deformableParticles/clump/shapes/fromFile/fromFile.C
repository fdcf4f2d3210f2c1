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
    dict.readEntry("centres", centres_);
    dict.readEntry("radii", radii_);
    dict.readEntry("bonds", bonds_);
}
