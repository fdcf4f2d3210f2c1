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
    suspensionTable(name, runTime, dict, typeName, {"section", "stations", "types"}),
    nStations_(100)
{
    read(dict);
}


bool Foam::functionObjects::cellFreeLayer::read(const dictionary& dict)
{
    const bool good = suspensionTable::read(dict);
    section_ = crossSection(dict, axes(), mesh_);
    nStations_ = getNumberOrDefault(dict, "stations", 100, 1, 1000000);
    types_ = typeSelection(dict, mesh_, cloudName());
    return good;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::cellFreeLayer::header() const
{
    tableHeader result("Width of the layer at the walls without clumps");
    result
       .add("layer", "m").add("deviation", "m").add("least", "m")
       .explain("time layer deviation least", "mean distance from the walls to the edge of"
            " the clumps over stations and directions, its standard deviation, the least");
    for (const label i : types_.numbers(cloud()))
    {
        const word& type = cloud().types()[i].name();
        result.add("layer_" + type, "m");
        result.explain("layer_" + type, "layer of this type of clump and its pieces alone");
    }
    return result;
}


template<class Action>
void Foam::functionObjects::cellFreeLayer::forEachStation
(
    const scalar from,
    const scalar to,
    const Action& visit
) const
{
    const scalar spacing = section_.length()/nStations_;
    const scalar start = -0.5*section_.length();
    const label last = std::floor((to - start)/spacing - 0.5);
    for (label k = std::ceil((from - start)/spacing - 0.5); k <= last; ++k)
    {
        // A clump that leaves the mesh at one end enters it at the other one
        const label station = ((k % nStations_) + nStations_) % nStations_;
        visit(station, start + (k + 0.5)*spacing);
    }
}


void Foam::functionObjects::cellFreeLayer::addSphere
(
    const vector& centre,
    const scalar radius,
    const UList<vector>& directions,
    UList<scalar>& edges
) const
{
    forEachStation
    (
        centre.z() - radius, centre.z() + radius,
        [&](const label station, const scalar z)
        {
            const scalar half2 = sqr(radius) - sqr(z - centre.z());
            const scalar half = Foam::sqrt(max(half2, scalar(0)));
            forAll(directions, d)
            {
                scalar& edge = edges[d*nStations_ + station];
                edge = max(edge, (directions[d] & centre) + half);
            }
        }
    );
}


void Foam::functionObjects::cellFreeLayer::addMembrane
(
    const closedSurface& surface,
    const pointField& x,
    const UList<vector>& directions,
    UList<scalar>& edges
) const
{
    for (const closedSurface::hinge& h : surface.hinges())
    {
        const point& a = x[h.i].z() < x[h.j].z() ? x[h.i] : x[h.j];
        const vector along((x[h.i].z() < x[h.j].z() ? x[h.j] : x[h.i]) - a);
        forEachStation
        (
            a.z(), a.z() + along.z(),
            [&](const label station, const scalar z)
            {
                const point y(a + (z - a.z())/max(along.z(), VSMALL)*along);
                forAll(directions, d)
                {
                    scalar& edge = edges[d*nStations_ + station];
                    edge = max(edge, directions[d] & y);
                }
            }
        );
    }
}


bool Foam::functionObjects::cellFreeLayer::write()
{
    const List<vector> directions(section_.towardsWalls());
    const label n = directions.size()*nStations_;
    scalarList allEdges(n*cloud().nTypes(), Zero);
    for (const clumpParcel& p : cloud())
    {
        if (!types_.holds(cloud(), p))
        {
            continue;
        }
        const clumpType& type = cloud().type(p);
        SubList<scalar> edges(allEdges, n, n*cloud().wholeType(p));
        pointField x(p.centres());
        for (point& c : x)
        {
            c = section_.local(c);
        }
        if (type.hasTriangles())
        {
            addMembrane(type.surface(), x, directions, edges);
            continue;
        }
        forAll(x, i)
        {
            addSphere(x[i], type.radii()[i], directions, edges);
        }
    }
    Pstream::listCombineGather(allEdges, maxEqOp<scalar>());

    if (Pstream::master())
    {
        scalarField widths(n, section_.half());
        DynamicList<scalar> row(3);
        row.setSize(3);
        for (const label type : types_.numbers(cloud()))
        {
            const scalarField ofType
            (
                section_.half() - scalarField(SubList<scalar>(allEdges, n, n*type))
            );
            widths = min(widths, ofType);
            row.append(average(ofType));
        }
        row[0] = average(widths);
        row[1] = Foam::sqrt(average(sqr(widths - row[0])));
        row[2] = min(widths);
        writeRow(row);
    }

    return true;
}
