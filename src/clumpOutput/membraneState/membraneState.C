/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneState.H"
#include "addToRunTimeSelectionTable.H"
#include "deformableCloud.H"
#include "membranes.H"
#include "membraneTensions.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(membraneState, 0);
    addToRunTimeSelectionTable(functionObject, membraneState, dictionary);
}
}

namespace
{

using namespace Foam;

//- Mean over the area, the largest and the smallest of principal values
vector summary(const List<Pair<scalar>>& values, const scalarField& areas)
{
    scalar mean = 0;
    scalar largest = -GREAT;
    scalar smallest = GREAT;
    forAll(values, n)
    {
        const Pair<scalar>& v = values[n];
        mean += 0.5*areas[n]*(v.first() + v.second());
        largest = max(largest, v.first());
        smallest = min(smallest, v.second());
    }
    return vector(mean/sum(areas), largest, smallest);
}

}


Foam::functionObjects::membraneState::membraneState
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    clumpTable(name, runTime, dict, typeName)
{
    read(dict);
}


Foam::functionObjects::tableHeader
Foam::functionObjects::membraneState::header() const
{
    return
        tableHeader("Strain and tension of each membrane")
       .add("meanStretch").add("largestStretch").add("smallestStretch")
       .add("meanTension", "N/m").add("largestTension", "N/m")
       .add("smallestTension", "N/m").add("bendingEnergy", "J")
       .add("areaRatio").add("volumeRatio")
       .explain("meanStretch largestStretch smallestStretch", "principal stretches of the"
            " triangles relative to the state without stress: mean over the surface,"
            " extremes")
       .explain("meanTension largestTension smallestTension", "principal tensions, without"
            " those of bending and viscosity")
       .explain("bendingEnergy", "sum of the models that resist bending")
       .explain("areaRatio volumeRatio", "area and volume over those of the shape at rest");
}


Foam::string Foam::functionObjects::membraneState::row
(
    const clumpParcel& p,
    const clumpType& type
) const
{
    const auto* kind = dynamic_cast<const membranes*>(cloud().kind(p));
    if (!kind)
    {
        return string();
    }
    const membraneMechanics& mechanics = kind->mechanics(p.typeId());
    const closedSurface& surface = type.surface();
    const pointField& x = p.state().x;
    const membraneTensions state(mechanics, x);
    return
        columns
        (
            {
                summary(state.stretches(), state.areas()),
                summary(state.tensions(), state.areas())
            }
        )
      + columns
        (
            {
                mechanics.bendingEnergy(x),
                sum(state.areas())/surface.area(type.centres()),
                surface.volume(x)/type.volume()
            }
        );
}
