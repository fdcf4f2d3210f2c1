/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "ring.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(ring, 0);
    addToRunTimeSelectionTable(shape, ring, dictionary);
}
}


Foam::clumpShapes::ring::ring
(
    const dictionary& dict,
    const wordList& derived
)
{
    checkEntries
    (
        dict,
        {"type", "nSpheres", "ringRadius", "diameter", "sphereRadius"},
        derived
    );

    const label n = getNumber(dict, "nSpheres", 3, maxSpheres);
    const scalar r = getPositive(dict, "sphereRadius");
    const scalar R = radius(dict, r);

    centres_.setSize(n);
    radii_ = scalarField(n, r);
    bonds_.setSize(n);

    forAll(centres_, i)
    {
        const scalar angle = constant::mathematical::twoPi*i/n;
        centres_[i] = R*vector(Foam::cos(angle), Foam::sin(angle), 0);
        bonds_[i] = labelPair(i, (i + 1) % n);
    }
}


Foam::scalar Foam::clumpShapes::ring::radius
(
    const dictionary& dict,
    const scalar sphereRadius
)
{
    if (!dict.found("diameter"))
    {
        return getPositive(dict, "ringRadius");
    }
    if (dict.found("ringRadius"))
    {
        FatalIOErrorInFunction(dict)
            << "Give either ringRadius or diameter" << exit(FatalIOError);
    }

    return
        0.5*getBetween(dict, "diameter", 2*sphereRadius, largestEntry)
      - sphereRadius;
}
