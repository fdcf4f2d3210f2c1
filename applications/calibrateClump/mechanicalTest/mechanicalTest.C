/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "mechanicalTest.H"
#include "equilibrium.H"

namespace Foam
{
    defineTypeNameAndDebug(mechanicalTest, 0);
    defineRunTimeSelectionTable(mechanicalTest, dictionary);
}


Foam::dictionary Foam::mechanicalTest::oppositeForces
(
    const clumpType& type,
    const scalar F
)
{
    const auto ext(equilibrium::stretch(type, vector(F, 0, 0)));
    labelList plus;
    labelList minus;
    forAll(ext.f, i)
    {
        if (ext.f[i].x() > 0)
        {
            plus.append(i);
        }
        else if (ext.f[i].x() < 0)
        {
            minus.append(i);
        }
    }
    dictionary result;
    result.set("type", "oppositeForces");
    result.set("clumpType", "fitted");
    result.set("direction", vector(1, 0, 0));
    result.set("plus", plus);
    result.set("minus", minus);
    result.set("force", F);
    return result;
}
