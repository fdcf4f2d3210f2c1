/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "flowAxes.H"
#include "checkedEntries.H"

namespace
{

using namespace Foam;

vector unit(const dictionary& dict, const word& key, const vector& value)
{
    const vector v(getFiniteOrDefault<vector>(dict, key, value));
    if (mag(v) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' must not be zero" << exit(FatalIOError);
    }
    return normalised(v);
}

}


Foam::functionObjects::flowAxes::flowAxes(const dictionary& dict)
:
    flow(unit(dict, "flow", vector(1, 0, 0))),
    gradient(unit(dict, "gradient", vector(0, 1, 0))),
    vorticity(flow ^ gradient)
{
    if (mag(flow & gradient) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'flow' " << flow << " and 'gradient' " << gradient
            << " are not at right angles." << exit(FatalIOError);
    }
}
