/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "givenHaematocrit.H"
#include "patchWave.H"
#include <cmath>

namespace Foam
{
namespace clumpInjections
{
    defineTypeNameAndDebug(givenHaematocrit, 0);
    addToRunTimeSelectionTable(injection, givenHaematocrit, dictionary);
}
}


Foam::clumpInjections::givenHaematocrit::givenHaematocrit
(
    const dictionary& dict,
    const site& s
)
:
    patchInjection(dict, s),
    tube_(dict.found("tube")),
    value_(getBetween(dict, tube_ ? "tube" : "discharge", 0, 1)),
    length_(tube_ ? getPositive(dict, "length") : 0),
    volume_(0)
{
    checkEntries(dict, entries({"discharge", "tube", "length"}));
    if (!tube_ && !s.hasFluid)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'discharge' needs the flow of a fluid; there is none."
            << exit(FatalIOError);
    }
    if (tube_ && dict.found("discharge"))
    {
        FatalIOErrorInFunction(dict)
            << "Give one of the entries discharge and tube." << exit(FatalIOError);
    }
    if (tube_)
    {
        findRegion();
    }
}


void Foam::clumpInjections::givenHaematocrit::findRegion()
{
    const polyMesh& mesh = site_.mesh;
    const patchWave wave(mesh, patches(), true);

    inRegion_.setSize(mesh.nCells());
    volume_ = 0;
    forAll(inRegion_, celli)
    {
        inRegion_[celli] = wave.distance()[celli] <= length_;
        volume_ += inRegion_[celli] ? mesh.cellVolumes()[celli] : scalar(0);
    }
    reduce(volume_, sumOp<scalar>());
    if (volume_ <= 0)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'length' is " << length_ << ", but no mesh cell is as near"
            << " to the patches." << exit(FatalIOError);
    }
}


Foam::scalar Foam::clumpInjections::givenHaematocrit::due
(
    const Cloud<clumpParcel>& clumps,
    const clumpCount&,
    const scalar before
)
{
    const scalar dt = activeTime();
    if (!tube_)
    {
        return before + value_*inflow()*dt/meanVolume();
    }

    scalar lacking = value_*volume_;
    scalar present = 0;
    for (const clumpParcel& p : clumps)
    {
        if (inRegion_[p.cell()] && !site_.types[p.typeId()].fixed())
        {
            present += site_.types[p.typeId()].nominalVolume();
        }
    }
    lacking -= returnReduce(present, sumOp<scalar>());
    const scalar number = std::floor(lacking/meanVolume() + 0.5);
    return nInjected() + (dt > 0 ? max(number, scalar(0)) : scalar(0));
}


void Foam::clumpInjections::givenHaematocrit::meshChanged()
{
    patchInjection::meshChanged();
    if (tube_)
    {
        findRegion();
    }
}
