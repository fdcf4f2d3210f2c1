/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpPassages.H"
#include "deformableCloud.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpPassages, 0);
    addToRunTimeSelectionTable(functionObject, clumpPassages, dictionary);
}
}


namespace
{

using namespace Foam;

functionObjects::tableHeader passageColumns()
{
    return
        functionObjects::tableHeader("Clumps that have entered and left")
       .add("time", "s").add("clump").add("type").add("event").add("patch")
       .addVector("", "m").addVector("U", "m/s").add("inside")
       .explain("time clump type", "number of the clump and name of its type")
       .explain("event patch", "entered or left, through which patch; none for a clump put"
            " inside the mesh")
       .explain("x y z Ux Uy Uz", "position and velocity of the centre of mass")
       .explain("inside", "number of clumps in the mesh after it");
}

}


Foam::functionObjects::clumpPassages::clumpPassages
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, typeName)
{
    read(dict);
}


bool Foam::functionObjects::clumpPassages::read(const dictionary& dict)
{
    checkEntries(dict, {"cloud"}, functionObjectEntries());
    cloudName_ = deformableCloud::findName(mesh_, dict);
    return fvMeshFunctionObject::read(dict) && table_.read(dict);
}


bool Foam::functionObjects::clumpPassages::execute()
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    const clumpCount& count = cloud.count();
    if (!Pstream::master())
    {
        return true;
    }

    // There is a table, if only with the names of its columns, before the first clump passes
    Ostream& os = table_.open(passageColumns());
    for (const clumpPassage& p : count.passages())
    {
        os  << time_.timeOutputValue() << '\t'
            << p.id << '\t' << cloud.types()[p.typeId].name() << '\t'
            << (p.entered ? "entered" : "left") << '\t'
            << count.patchName(p);
        for (const vector& v : {p.centre, p.velocity})
        {
            os  << '\t' << v.x() << '\t' << v.y() << '\t' << v.z();
        }
        os  << '\t' << count.inside() << nl;
    }
    table_.flush();
    return true;
}
