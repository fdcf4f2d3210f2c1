/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "oppositeForces.H"

namespace Foam
{
namespace loads
{
    defineTypeNameAndDebug(oppositeForces, 0);
    addToRunTimeSelectionTable(load, oppositeForces, dictionary);
}
}


Foam::loads::oppositeForces::oppositeForces(const dictionary& dict)
:
    load(dict, {"direction", "plus", "minus", "force", "forceCoeffs"}),
    direction_(getFinite<vector>(dict, "direction")),
    plus_(getEntry<labelList>(dict, "plus")),
    minus_(getEntry<labelList>(dict, "minus")),
    force_(Function1<scalar>::New("force", dict))
{
    if (mag(direction_) < VSMALL || plus_.empty() || minus_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "oppositeForces needs a 'direction' that is not zero and at"
            << " least one sphere each in 'plus' and 'minus'."
            << exit(FatalIOError);
    }
    for (const label i : plus_)
    {
        if (minus_.found(i))
        {
            FatalIOErrorInFunction(dict)
                << "Entries 'plus' " << plus_ << " and 'minus' " << minus_
                << " both contain the sphere " << i
                << ", whose forces would cancel." << exit(FatalIOError);
        }
    }
    direction_ /= mag(direction_);
}


void Foam::loads::oppositeForces::check
(
    const dictionary& dict,
    const label nSpheres
) const
{
    checkSpheres(dict, "plus", plus_, nSpheres);
    checkSpheres(dict, "minus", minus_, nSpheres);
}


void Foam::loads::oppositeForces::add
(
    const site& clump,
    externalForces& ext
) const
{
    const vector F(force_->value(clump.time())*direction_);

    for (const label i : plus_)
    {
        addForce(clump, i, F/plus_.size(), ext);
    }
    for (const label i : minus_)
    {
        addForce(clump, i, -F/minus_.size(), ext);
    }
}
