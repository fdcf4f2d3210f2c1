/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rate.H"

namespace Foam
{
namespace clumpInjections
{
    defineTypeNameAndDebug(rate, 0);
    addToRunTimeSelectionTable(injection, rate, dictionary);
}
}


Foam::clumpInjections::rate::rate(const dictionary& dict, const site& s)
:
    patchInjection(dict, s),
    rate_(getPositive(dict, "rate"))
{
    checkEntries(dict, entries({"rate"}));
}
