/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "signedDistance.H"

namespace Foam
{
namespace solidFractionModels
{
    defineTypeNameAndDebug(signedDistance, 0);
    addToRunTimeSelectionTable(solidFractionModel, signedDistance, dictionary);
}
}


Foam::solidFractionModels::signedDistance::signedDistance(const dictionary& dict)
{
    checkEntries(dict, {"type"});
}


Foam::scalar Foam::solidFractionModels::signedDistance::fraction
(
    const cellGeometry& geometry,
    const label celli,
    const scalar distance,
    const UList<point>&,
    const UList<scalar>&
) const
{
    const scalar h = geometry[celli].width;
    return min(max(0.5 - distance/h, scalar(0)), scalar(1));
}
