/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "disc.H"
#include "ring.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(disc, 0);
    addToRunTimeSelectionTable(shape, disc, dictionary);
}
}


Foam::clumpShapes::disc::disc(const dictionary& dict)
{
    const ring rim(dict, {"centreRadius"});
    const label n = rim.centres().size();

    centres_ = rim.centres();
    centres_.append(point::zero);
    radii_ = rim.radii();
    radii_.append(getPositive(dict, "centreRadius"));
    bonds_ = rim.bonds();

    for (label i = 0; i < n; ++i)
    {
        bonds_.append(labelPair(i, n));
    }
}
