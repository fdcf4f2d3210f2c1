/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "biconcave.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(biconcave, 0);
    addToRunTimeSelectionTable(shape, biconcave, dictionary);
}
}


Foam::clumpShapes::biconcave::biconcave(const dictionary& dict)
{
    checkEntries(dict, {"type", "diameter", "subdivisions"});

    const scalar R = 0.5*getPositive(dict, "diameter");
    setIcosphere(getNumberOrDefault(dict, "subdivisions", 3, 1, maxSubdivisions));

    for (point& x : centres_)
    {
        const scalar r2 = sqr(x.x()) + sqr(x.y());
        x.z() *= 0.5*(0.207161 + 2.002558*r2 - 1.122762*sqr(r2));
        x *= R;
    }
    setRadii(dict);
}
