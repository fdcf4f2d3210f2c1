/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constraintForce.H"
#include "clumpMotion.H"
#include "deformableCloud.H"
#include "addToRunTimeSelectionTable.H"
#include "SortableList.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(constraintForce, 0);
    addToRunTimeSelectionTable(functionObject, constraintForce, dictionary);
}
}


namespace
{

using namespace Foam;

functionObjects::tableHeader constraintColumns()
{
    return
        functionObjects::tableHeader("Force of the loads that hold or move clumps")
       .add("time", "s").add("clump").add("type")
       .addVector("F", "N").addVector("T", "N.m").addVector("", "m")
       .addVector("U", "m/s").addVector("w", "rad/s").add("power", "W")
       .explain("time clump type", "number of the clump and name of its type")
       .explain("Fx Fy Fz Tx Ty Tz", "force of the constraint over the last step, and its"
            " torque about the centre of mass")
       .explain("x y z", "centre of mass at the end of the step")
       .explain("Ux Uy Uz wx wy wz", "its velocity and the angular velocity of the clump"
            " over the step")
       .explain("power", "F.U + T.w");
}

}


Foam::functionObjects::constraintForce::constraintForce
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


bool Foam::functionObjects::constraintForce::read(const dictionary& dict)
{
    checkEntries(dict, {"cloud"}, functionObjectEntries());
    cloudName_ = deformableCloud::findName(mesh_, dict);
    return fvMeshFunctionObject::read(dict) && table_.read(dict);
}


bool Foam::functionObjects::constraintForce::write()
{
    if (functionObject::postProcess)
    {
        Info<< name() << ": the forces over a step are known in the run only; no table is"
            << " written" << endl;
        return true;
    }
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    List<DynamicList<label>> ids(Pstream::nProcs());
    List<DynamicList<label>> types(Pstream::nProcs());
    List<DynamicList<vector>> values(Pstream::nProcs());
    const label here = Pstream::myProcNo();
    for (const clumpMotion::constraint& c : cloud.motion().constraints())
    {
        ids[here].append(c.id);
        types[here].append(c.typeId);
        for (const vector& v : {c.force, c.torque, c.centre, c.velocity, c.omega})
        {
            values[here].append(v);
        }
    }
    Pstream::gatherList(ids);
    Pstream::gatherList(types);
    Pstream::gatherList(values);
    if (!Pstream::master())
    {
        return true;
    }

    DynamicList<label> allIds, allTypes;
    DynamicList<vector> allValues;
    forAll(ids, proci)
    {
        allIds.append(ids[proci]);
        allTypes.append(types[proci]);
        allValues.append(values[proci]);
    }
    const label nValues = 5;
    Ostream& os = table_.open(constraintColumns());
    const SortableList<label> order(allIds);
    forAll(order, k)
    {
        const label n = order.indices()[k];
        const SubList<vector> v(allValues, nValues, nValues*n);
        os  << time_.timeOutputValue() << '\t' << order[k] << '\t'
            << cloud.types()[allTypes[n]].name();
        for (const vector& value : v)
        {
            os << '\t' << value.x() << '\t' << value.y() << '\t' << value.z();
        }
        os << '\t' << (v[0] & v[3]) + (v[1] & v[4]) << nl;
    }
    table_.flush();
    return true;
}
