/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "functionObjectTypes.H"
#include "FlatOutput.H"
#include "functionObject.H"
#include "Time.H"
#include "unreadEntries.H"

namespace
{

using namespace Foam;

//- The function object loads another library than this one
bool hasOtherLibrary(const dictionary& dict)
{
    for (const word key : {"libs", "functionObjectLibs"})
    {
        fileNameList libs;
        if (dict.readIfPresent(key, libs))
        {
            for (const fileName& lib : libs)
            {
                if (lib.find("deformableParticles") == std::string::npos)
                {
                    return true;
                }
            }
        }
    }
    return false;
}

}


void Foam::functionObjectTypes::check(const Time& runTime)
{
    // Those of the libraries that are loaded already: of this one, and of OpenFOAM's
    // that it uses
    const wordList known
    (
        functionObject::dictionaryConstructorTablePtr_->sortedToc()
    );
    const dictionary functions(runTime.controlDict().subOrEmptyDict("functions"));
    for (const entry& e : functions)
    {
        word type;
        if
        (
            !e.isDict() || !e.dict().readIfPresent("type", type)
         || known.found(type)
        )
        {
            continue;
        }
        const word meant(nearestName(type, known));
        const bool almost =
            !meant.empty()
         && spellingDistance(type, meant) < 2 + meant.size()/8;

        if (almost || !hasOtherLibrary(e.dict()))
        {
            FatalIOErrorInFunction(e.dict())
                << "Unknown type '" << type << "' of the function object "
                << e.keyword() << '.';
            if (!meant.empty())
            {
                FatalIOError << " Did you mean '" << meant << "'?";
            }
            FatalIOError
                << nl << "Valid types: " << flatOutput(known) << nl
                << "A function object of another library needs that library in its"
                << " entry libs." << exit(FatalIOError);
        }
    }
}
