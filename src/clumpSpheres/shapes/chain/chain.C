/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "chain.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(chain, 0);
    addToRunTimeSelectionTable(shape, chain, dictionary);
}
}


Foam::clumpShapes::chain::chain(const dictionary& dict)
{
    checkEntries(dict, {"type", "nSpheres", "spacing", "sphereRadius"});

    const label n = getNumber(dict, "nSpheres", 1, maxSpheres);
    const scalar r = getPositive(dict, "sphereRadius");
    const scalar spacing = n > 1 ? getPositive(dict, "spacing") : 0;

    centres_.setSize(n);
    radii_ = scalarField(n, r);
    bonds_.setSize(n - 1);

    forAll(centres_, i)
    {
        centres_[i] = vector((i - 0.5*(n - 1))*spacing, 0, 0);
        if (i)
        {
            bonds_[i - 1] = labelPair(i - 1, i);
        }
    }
}
