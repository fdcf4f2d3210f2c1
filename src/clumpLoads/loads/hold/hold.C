/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hold.H"

namespace Foam
{
namespace loads
{
    defineTypeNameAndDebug(hold, 0);
    addToRunTimeSelectionTable(load, hold, dictionary);
}
}


Foam::loads::hold::hold(const dictionary& dict)
:
    load(dict, {"directions"}),
    along_(projector(dict))
{}


Foam::symmTensor Foam::loads::hold::projector(const dictionary& dict)
{
    symmTensor result(Zero);
    const List<vector> directions(getFiniteList<vector>(dict, "directions"));
    if (directions.empty() || directions.size() > 3)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'directions' needs one to three vectors; it has "
            << directions.size() << '.' << exit(FatalIOError);
    }
    for (const vector& direction : directions)
    {
        const vector n(direction/max(mag(direction), VSMALL));
        if (mag(n) < 0.5 || mag(result & n) > 1e-6)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'directions' is " << directions
                << "; they must not be zero and must be at right angles."
                << exit(FatalIOError);
        }
        result += sqr(n);
    }
    return result;
}
