/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellFreeLayer.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntries.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(cellFreeLayer, 0);
    addToRunTimeSelectionTable(functionObject, cellFreeLayer, dictionary);
}
}


Foam::functionObjects::cellFreeLayer::cellFreeLayer
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    suspensionTable(name, runTime, dict, typeName, {"section", "stations"}),
    nStations_(100)
{
    read(dict);
}


bool Foam::functionObjects::cellFreeLayer::read(const dictionary& dict)
{
    const bool good = suspensionTable::read(dict);
    section_ = crossSection(dict, axes(), mesh_);
    nStations_ = getNumberOrDefault(dict, "stations", 100, 1, 1000000);
    return good;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::cellFreeLayer::header() const
{
    return
        tableHeader("Width of the layer at the walls without clumps")
       .add("layer", "m").add("deviation", "m").add("least", "m")
       .explain("time layer deviation least", "mean distance from the walls to the edge of"
            " the clumps over stations and directions, its standard deviation, the least");
}


void Foam::functionObjects::cellFreeLayer::addSphere
(
    const vector& centre,
    const scalar radius,
    const UList<vector>& directions,
    UList<scalar>& edges
) const
{
    const scalar spacing = section_.length()/nStations_;
    const scalar x = centre.z() + 0.5*section_.length();
    const label last = std::floor((x + radius)/spacing - 0.5);
    for
    (
        label k = std::ceil((x - radius)/spacing - 0.5);
        k <= last;
        ++k
    )
    {
        const scalar half2 = sqr(radius) - sqr((k + 0.5)*spacing - x);
        const scalar half = Foam::sqrt(max(half2, scalar(0)));

        // A clump that leaves the mesh at one end enters it at the other one
        const label station = ((k % nStations_) + nStations_) % nStations_;
        forAll(directions, d)
        {
            scalar& edge = edges[d*nStations_ + station];
            edge = max(edge, (directions[d] & centre) + half);
        }
    }
}


bool Foam::functionObjects::cellFreeLayer::write()
{
    const List<vector> directions(section_.towardsWalls());
    scalarList edges(directions.size()*nStations_, Zero);
    for (const clumpParcel& p : cloud())
    {
        const scalarField& r = cloud().type(p).radii();
        const pointField x(p.centres());
        forAll(x, i)
        {
            addSphere(section_.local(x[i]), r[i], directions, edges);
        }
    }
    Pstream::listCombineGather(edges, maxEqOp<scalar>());

    if (Pstream::master())
    {
        const scalarField widths(section_.half() - edges);
        const scalar layer = average(widths);
        writeRow
        ({
            layer, Foam::sqrt(average(sqr(widths - layer))), min(widths)
        });
    }

    return true;
}
