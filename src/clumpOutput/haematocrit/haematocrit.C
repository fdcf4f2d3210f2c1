/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "haematocrit.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(haematocrit, 0);
    addToRunTimeSelectionTable(functionObject, haematocrit, dictionary);
}
}


Foam::functionObjects::haematocrit::haematocrit
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    suspensionTable(name, runTime, dict, typeName, {"types"})
{
    read(dict);
}


bool Foam::functionObjects::haematocrit::read(const dictionary& dict)
{
    const bool good = suspensionTable::read(dict);
    types_ = typeSelection(dict, mesh_, cloudName());
    return good;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::haematocrit::header() const
{
    tableHeader result("Tube and discharge haematocrit");
    result.add("Ht").add("Hd").add("HtHd").add("phi")
       .add("Ub", "m/s").add("Uc", "m/s")
       .explain("time Ht Hd", "tube haematocrit (nominal volume of the clumps over that of"
            " the mesh), and discharge haematocrit (of what flows)")
       .explain("HtHd phi", "Ht/Hd, and volume of the unions of the spheres over that of"
            " the mesh")
       .explain("Ub Uc", "mean velocity of fluid and clumps, and of the clumps, along the"
            " flow");
    for (const label i : types_.numbers(cloud()))
    {
        const word& type = cloud().types()[i].name();
        result.add("Ht_" + type).add("Hd_" + type).add("Uc_" + type, "m/s");
        result.explain
        (
            "Ht_" + type + " Hd_" + type + " Uc_" + type,
            "of this type of clump and its pieces"
        );
    }
    return result;
}


bool Foam::functionObjects::haematocrit::write()
{
    const deformableCloud& clumps = cloud();
    const vector& e = axes().flow;

    // Volume, flow, its magnitude, volume of the unions; then volume and flow of
    // each type
    const label first = 4;
    scalarList sums(first + 2*clumps.nTypes(), Zero);
    for (const clumpParcel& p : clumps)
    {
        if (!types_.holds(clumps, p))
        {
            continue;
        }
        const clumpType& type = clumps.type(p);
        const scalar V = type.nominalVolume();
        sums[3] += type.volume()*type.relativeVolume(p.state().x);
        const label k = first + 2*clumps.wholeType(p);
        sums[k] += V;
        sums[k + 1] += V*(p.state().velocity(type) & e);
    }
    const volVectorField* U = velocity();
    const scalarField& V = mesh_.V();
    sums[0] = sum(V);
    if (U)
    {
        const scalarField u(U->primitiveField() & e);
        sums[1] = sum(V*u);
        sums[2] = sum(V*mag(u));
    }
    sumUp(sums);

    if (Pstream::master())
    {
        const scalar flow = mag(sums[1]) > 0.5*sums[2] ? sums[1] : 0;
        scalar volume = 0;
        scalar ofClumps = 0;
        DynamicList<scalar> row(6);
        row.setSize(6);
        for (const label i : types_.numbers(clumps))
        {
            const label k = first + 2*i;
            volume += sums[k];
            ofClumps += sums[k + 1];
            row.append(sums[k]/sums[0]);
            row.append(ratio(sums[k + 1], flow));
            row.append(ratio(sums[k + 1], sums[k]));
        }
        row[0] = volume/sums[0];
        row[1] = ratio(ofClumps, flow);
        row[2] = ratio(row[0], row[1]);
        row[3] = sums[3]/sums[0];
        row[4] = sums[1]/sums[0];
        row[5] = ratio(ofClumps, volume);
        writeRow(row);
    }

    return true;
}
