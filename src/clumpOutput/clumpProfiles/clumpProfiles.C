/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpProfiles.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntries.H"
#include "sphereUnion.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpProfiles, 0);
    addToRunTimeSelectionTable(functionObject, clumpProfiles, dictionary);
}
}


Foam::functionObjects::clumpProfiles::clumpProfiles
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    suspensionTable(name, runTime, dict, typeName, {"section", "bins", "types"}),
    nBins_(10)
{
    read(dict);
}


bool Foam::functionObjects::clumpProfiles::read(const dictionary& dict)
{
    const bool good = suspensionTable::read(dict);
    section_ = crossSection(dict, axes(), mesh_);
    nBins_ = getNumberOrDefault(dict, "bins", 10, 1, 10000);
    types_ = typeSelection(dict, mesh_, cloudName());
    return good;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpProfiles::header() const
{
    tableHeader result("Profiles of haematocrit and velocity");
    result.add("bin").add("s", "m").add("H").add("U", "m/s").add("Uc", "m/s");
    result
       .explain("time bin s", "number of the bin, and its middle across the stream, from"
            " the axis of a tube or the lower wall of a slit")
       .explain("H", "volume of the clumps in the bin over that of the bin")
       .explain("U Uc", "mean velocity along the flow of fluid and clumps, and of the"
            " clumps in the bin; nan where there are none");
    for (const label i : types_.numbers(cloud()))
    {
        const word& type = cloud().types()[i].name();
        result.add("H_" + type).add("n_" + type);
        result.explain("H_" + type, "H of this type of clump and its pieces")
           .explain("n_" + type, "number of them with their centre of mass in the bin");
    }
    return result;
}


Foam::label Foam::functionObjects::clumpProfiles::bin
(
    const scalar y,
    const scalar z
) const
{
    const scalar fraction = section_.position(y, z)/section_.width();
    return min(max(label(fraction*nBins_), 0), nBins_ - 1);
}


void Foam::functionObjects::clumpProfiles::addClump
(
    const clumpParcel& p,
    UList<scalar>& volumes,
    UList<scalar>& flows
) const
{
    const clumpType& type = cloud().type(p);
    pointField x(p.centres());
    for (point& c : x)
    {
        c = section_.local(c);
    }
    if (type.hasTriangles())
    {
        addMembrane(p, x, volumes, flows);
        return;
    }
    const scalarField& r = type.radii();
    const scalar weight = type.nominalRatio();
    sphereUnion::forEachChord
    (
        x, r, 0.1*min(r),
        [&](const scalar y, const scalar z, const label i, const scalar V)
        {
            const label k = bin(y, z);
            volumes[k] += weight*V;
            flows[k] += weight*V*(p.state().u[i] & axes().flow);
        }
    );
}


void Foam::functionObjects::clumpProfiles::addMembrane
(
    const clumpParcel& p,
    const pointField& x,
    UList<scalar>& volumes,
    UList<scalar>& flows
) const
{
    const clumpType& type = cloud().type(p);
    const closedSurface& surface = type.surface();
    const scalar weight = type.nominalRatio();
    const vector& e = axes().flow;
    const point centre(surface.centroid(x));
    const scalar uCentre = p.state().velocity(type) & e;
    const vectorField& u = p.state().u;

    constexpr label nLayers = 10;
    for (const triFace& t : surface.triangles())
    {
        const vector middle(t.centre(x) - centre);
        const scalar uMiddle = ((u[t[0]] + u[t[1]] + u[t[2]])/3) & e;
        const scalar V = weight*(t.areaNormal(x) & middle)/3;
        for (label k = 0; k < nLayers; ++k)
        {
            // Part of the distance from the centre: between two layers, and their middle
            const scalar s0 = scalar(k)/nLayers;
            const scalar s1 = scalar(k + 1)/nLayers;
            const scalar fraction = pow3(s1) - pow3(s0);
            const scalar s = 0.75*(pow4(s1) - pow4(s0))/fraction;

            const vector y(centre + s*middle);
            const label i = bin(y.x(), y.y());
            volumes[i] += V*fraction;
            flows[i] += V*fraction*((1 - s)*uCentre + s*uMiddle);
        }
    }
}


bool Foam::functionObjects::clumpProfiles::write()
{
    const label nTypes = cloud().nTypes();

    // By bins: volume and flow of the mesh cells, flow of the clumps, then the
    // volume and number of each type
    scalarList sums((3 + 2*nTypes)*nBins_, Zero);
    const auto part = [&](const label k)
    {
        return SubList<scalar>(sums, nBins_, k*nBins_);
    };
    if (const volVectorField* U = velocity())
    {
        SubList<scalar> volumes(part(0)), flows(part(1));
        forAll(mesh_.C(), celli)
        {
            const vector x(section_.local(mesh_.cellCentres()[celli]));
            const label k = bin(x.x(), x.y());
            volumes[k] += mesh_.V()[celli];
            flows[k] += mesh_.V()[celli]*((*U)[celli] & axes().flow);
        }
    }
    SubList<scalar> flows(part(2));
    for (const clumpParcel& p : cloud())
    {
        if (!types_.holds(cloud(), p))
        {
            continue;
        }
        const label type = 3 + 2*cloud().wholeType(p);
        SubList<scalar> volumes(part(type)), numbers(part(type + 1));
        addClump(p, volumes, flows);
        const vector x(section_.local(p.centre(cloud().type(p))));
        numbers[bin(x.x(), x.y())] += 1;
    }
    sumUp(sums);

    if (Pstream::master())
    {
        const scalar width = section_.width()/nBins_;
        for (label k = 0; k < nBins_; ++k)
        {
            const scalar binVolume =
                section_.volumeTo((k + 1)*width) - section_.volumeTo(k*width);
            DynamicList<scalar> row(5);
            row.setSize(5);
            scalar volume = 0;
            for (const label type : types_.numbers(cloud()))
            {
                const scalar V = sums[(3 + 2*type)*nBins_ + k];
                volume += V;
                row.append(V/binVolume);
                row.append(sums[(4 + 2*type)*nBins_ + k]);
            }
            row[0] = k;
            row[1] = (k + 0.5)*width;
            row[2] = volume/binVolume;
            row[3] = ratio(sums[nBins_ + k], sums[k]);
            row[4] = ratio(sums[2*nBins_ + k], volume);
            writeRow(row);
        }
    }

    return true;
}
