/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "move.H"
#include "hold.H"

namespace Foam
{
namespace loads
{
    defineTypeNameAndDebug(move, 0);
    addToRunTimeSelectionTable(load, move, dictionary);
}
}


template<class Type>
Foam::loads::move::path<Type>::path
(
    const dictionary& dict,
    const word& valueName,
    const word& rateName
)
{
    if (dict.found(valueName) && dict.found(rateName))
    {
        FatalIOErrorInFunction(dict)
            << "There are entries '" << valueName << "' and '" << rateName
            << "': give one of them." << exit(FatalIOError);
    }
    if (dict.found(valueName))
    {
        value = Function1<Type>::New(valueName, dict);
    }
    if (dict.found(rateName))
    {
        rate = Function1<Type>::New(rateName, dict);
    }
}


template<class Type>
Type Foam::loads::move::path<Type>::change
(
    const scalar from,
    const scalar to
) const
{
    if (value.valid())
    {
        return value->value(to) - value->value(from);
    }
    const scalar half = 0.5*(to - from);
    const scalar middle = from + half;
    const scalar a = half*Foam::sqrt(0.6);
    return
        half/9
       *(
            5*rate->value(middle - a) + 8*rate->value(middle)
          + 5*rate->value(middle + a)
        );
}


Foam::loads::move::move(const dictionary& dict)
:
    load
    (
        dict,
        {
            "velocity", "velocityCoeffs", "displacement", "displacementCoeffs",
            "directions", "angularVelocity", "angularVelocityCoeffs", "angle",
            "angleCoeffs", "axis"
        }
    ),
    along_(Zero),
    axis_(Zero),
    centre_(dict, "displacement", "velocity"),
    turn_(dict, "angle", "angularVelocity")
{
    if (!centre_.given() && !turn_.given())
    {
        FatalIOErrorInFunction(dict)
            << "The load move needs an entry 'velocity' or 'displacement' for the centre,"
            << " or 'angularVelocity' or 'angle' for the rotation."
            << exit(FatalIOError);
    }
    if (centre_.given())
    {
        along_ = dict.found("directions") ? hold::projector(dict) : symmTensor(I);
    }
    else if (dict.found("directions"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'directions' needs 'velocity' or 'displacement'."
            << exit(FatalIOError);
    }
    if (turn_.given())
    {
        axis_ = getFinite<vector>(dict, "axis");
        if (mag(axis_) < VSMALL)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'axis' must not be zero." << exit(FatalIOError);
        }
        axis_ /= mag(axis_);
    }
    else if (dict.found("axis"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'axis' needs 'angularVelocity' or 'angle'." << exit(FatalIOError);
    }
}


void Foam::loads::move::prescribe
(
    const scalar from,
    const scalar to,
    externalForces& ext
) const
{
    if (centre_.given())
    {
        ext.moved = along_ & centre_.change(from, to);
    }
    if (turn_.given())
    {
        ext.turned = true;
        ext.turn = turn_.change(from, to)*axis_;
    }
}
