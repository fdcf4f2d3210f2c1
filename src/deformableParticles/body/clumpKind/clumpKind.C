/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpKind.H"
#include "checkedEntries.H"

namespace Foam
{
    defineTypeNameAndDebug(clumpKind, 0);
    defineRunTimeSelectionTable(clumpKind, cloud);
}


Foam::autoPtr<Foam::clumpKind> Foam::clumpKind::New(const word& kind, const site& s)
{
    const auto construct =
        cloudConstructorTablePtr_
      ? cloudConstructorTablePtr_->lookup(kind, nullptr) : nullptr;
    if (!construct)
    {
        FatalIOErrorInFunction(getDict(s.clumpProperties, "types"))
            << "No library that is loaded has clumps of the kind '" << kind << "'."
            << exit(FatalIOError);
    }
    return construct(s);
}


Foam::wordList& Foam::clumpKind::entries()
{
    static wordList all;
    return all;
}
