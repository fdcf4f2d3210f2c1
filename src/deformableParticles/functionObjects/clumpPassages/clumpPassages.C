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

void writeHeader(Ostream& os)
{
    os  << "# Clumps that have entered and left" << nl
        << "# time [s]\tevent\tnumber\ttype\tpatch\tcentre x y z [m]"
        << "\tvelocity x y z [m/s]\tinside" << nl;
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
    cloudName_ = deformableCloud::find(mesh_, dict).name();
    return fvMeshFunctionObject::read(dict) && table_.read(dict);
}


bool Foam::functionObjects::clumpPassages::execute()
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    const clumpCount& count = cloud.count();
    if (!Pstream::master() || count.passages().empty())
    {
        return true;
    }

    Ostream& os = table_.open(&writeHeader);
    for (const clumpPassage& p : count.passages())
    {
        os  << time_.timeOutputValue() << '\t'
            << (p.entered ? "entered" : "left") << '\t' << p.id << '\t'
            << cloud.types()[p.typeId].name() << '\t' << count.patchName(p);
        for (const vector& v : {p.centre, p.velocity})
        {
            os  << '\t' << v.x() << '\t' << v.y() << '\t' << v.z();
        }
        os  << '\t' << count.inside() << nl;
    }
    table_.flush();
    return true;
}
