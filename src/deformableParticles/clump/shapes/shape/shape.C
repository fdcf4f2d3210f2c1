/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "shape.H"
#include "HashSet.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(shape, 0);
    defineRunTimeSelectionTable(shape, dictionary);
}
}


Foam::autoPtr<Foam::clumpShapes::shape> Foam::clumpShapes::shape::New
(
    const dictionary& dict
)
{
    autoPtr<shape> result(selectModel<shape>(dict));
    result->check(dict);
    return result;
}


void Foam::clumpShapes::shape::check(const dictionary& dict) const
{
    const label n = centres_.size();

    if (!n || radii_.size() != n)
    {
        FatalIOErrorInFunction(dict)
            << "A shape needs at least one sphere and one radius for every"
            << " centre, but it has " << n << " centres and " << radii_.size()
            << " radii."
            << exit(FatalIOError);
    }

    forAll(radii_, i)
    {
        if (radii_[i] < smallestEntry)
        {
            FatalIOErrorInFunction(dict)
                << "The radius of sphere " << i << " is " << radii_[i]
                << "; it must be positive." << exit(FatalIOError);
        }
    }

    HashSet<labelPair, Hash<labelPair>> seen;

    forAll(bonds_, b)
    {
        const labelPair& pair = bonds_[b];

        if (min(pair.first(), pair.second()) < 0
         || max(pair.first(), pair.second()) >= n
         || pair.first() == pair.second())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'bonds': bond " << b << " joins spheres " << pair
                << "; a bond must join two different spheres of 0 to " << n - 1
                << '.' << exit(FatalIOError);
        }
        const bool forwards = pair.first() < pair.second();
        if (!seen.insert(forwards ? pair : reverse(pair)))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'bonds': spheres " << pair << " are bonded twice."
                << exit(FatalIOError);
        }
    }
}
