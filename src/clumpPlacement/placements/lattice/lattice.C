/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "lattice.H"
#include <cmath>

namespace Foam
{
namespace clumpPlacements
{
    defineTypeNameAndDebug(lattice, 0);
    addToRunTimeSelectionTable(placement, lattice, dictionary);
}
}


Foam::clumpPlacements::lattice::lattice
(
    const dictionary& dict,
    const PtrList<clumpType>& types,
    const HashTable<label>& typeIds
)
:
    givenPlaces(dict, types, typeIds),
    fractions_(fractions(dict, types, typeIds)),
    origin_(getFinite<point>(dict, "origin")),
    spacing_(getFinite<vector>(dict, "spacing")),
    number_(getEntry<labelVector>(dict, "number"))
{
    checkEntries
    (
        dict, {"type", "clumpType", "fractions", "origin", "spacing", "number"}
    );

    if (cmptMin(number_) < 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'number' is " << number_ << "; every component must be"
            << " above 0." << exit(FatalIOError);
    }
    checkNumber
    (
        dict, "number", scalar(number_.x())*number_.y()*number_.z()
    );
}


Foam::newClump Foam::clumpPlacements::lattice::clump(const label k) const
{
    const label typei =
        typeAt(fractions_, std::fmod(0.5 + 0.5*(std::sqrt(5.0) - 1)*k, 1.0));
    return newClump(types_[typei], typei, position(k));
}


Foam::point Foam::clumpPlacements::lattice::position(const label k) const
{
    const vector i
    (
        k % number_.x(),
        (k/number_.x()) % number_.y(),
        k/(number_.x()*number_.y())
    );
    return origin_ + cmptMultiply(i, spacing_);
}
