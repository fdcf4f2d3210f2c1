/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "centreInside.H"

namespace Foam
{
namespace solidFractionModels
{
    defineTypeNameAndDebug(centreInside, 0);
    addToRunTimeSelectionTable(solidFractionModel, centreInside, dictionary);
}
}


Foam::solidFractionModels::centreInside::centreInside(const dictionary& dict)
{
    checkEntries(dict, {"type"});
}


Foam::scalar Foam::solidFractionModels::centreInside::fraction
(
    const cellGeometry&,
    const label,
    const scalar distance,
    const UList<point>&,
    const UList<scalar>&
) const
{
    return distance < 0 ? 1 : 0;
}
