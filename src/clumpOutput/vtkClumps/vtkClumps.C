/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "vtkClumps.H"
#include "deformableCloud.H"
#include "bondForces.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(vtkClumps, 0);
    addToRunTimeSelectionTable(functionObject, vtkClumps, dictionary);
}
}

Foam::functionObjects::vtkClumps::vtkClumps
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    spheres_("spheres"),
    bonds_("bonds"),
    membranes_("membranes")
{
    read(dict);

    // Nothing is written before the first step: other input may be wrong
    if (!functionObject::postProcess && time_.timeIndex() == 0)
    {
        collect(mesh_.lookupObject<deformableCloud>(cloudName_), start_);
        start_.time = time_.value();
    }
}


bool Foam::functionObjects::vtkClumps::execute()
{
    if (start_.time < GREAT && time_.timeIndex() > 0)
    {
        write(start_);
        start_ = frame();
    }
    return true;
}


bool Foam::functionObjects::vtkClumps::read(const dictionary& dict)
{
    checkEntries(dict, {"cloud"}, functionObjectEntries());
    cloudName_ = deformableCloud::findName(mesh_, dict);
    return fvMeshFunctionObject::read(dict);
}


void Foam::functionObjects::vtkClumps::collect
(
    const deformableCloud& cloud,
    frame& all
) const
{
    DynamicList<point> centres;
    DynamicList<scalar> radii, clumps, numbers, types;
    DynamicList<vector> velocities, forces;
    DynamicList<point> ends;
    DynamicList<scalar> tension, bondClumps;

    for (const clumpParcel& p : cloud)
    {
        const clumpType& type = cloud.type(p);
        const pointField x(p.centres());

        for (label i = 0; i < x.size() && !type.hasTriangles(); ++i)
        {
            centres.append(x[i]);
            radii.append(type.radii()[i]);
            clumps.append(p.origId());
            numbers.append(i);
            types.append(p.typeId());
            velocities.append(p.state().u[i]);
            forces.append(p.fluidForces()[i]);
        }

        const scalarField axial(bondForces(cloud.bonds(p)).tension(p.state()));
        forAll(type.pairs(), b)
        {
            ends.append(x[type.pairs()[b].first()]);
            ends.append(x[type.pairs()[b].second()]);
            tension.append(axial[b]);
            bondClumps.append(p.origId());
        }
    }

    all.index = time_.timeIndex();
    all.time = time_.value();

    all.spheres.points.transfer(centres);
    all.spheres.scalars =
    {
        {"radius", radii}, {"clump", clumps}, {"sphere", numbers}, {"type", types}
    };
    all.spheres.vectors = {{"U", velocities}, {"fluidForce", forces}};
    all.spheres.textName = "typeNames";
    all.spheres.texts.setSize(cloud.types().size());
    forAll(cloud.types(), i)
    {
        all.spheres.texts[i] = cloud.types()[i].name();
        all.hasMembranes = all.hasMembranes || cloud.types()[i].hasTriangles();
    }
    if (all.hasMembranes)
    {
        collectMembranes(cloud, all.membranes);
    }

    all.bonds.kind = vtkSeries::lines;
    all.bonds.points.transfer(ends);
    all.bonds.isCellData = true;
    all.bonds.scalars = {{"axialForce", tension}, {"clump", bondClumps}};
}


bool Foam::functionObjects::vtkClumps::write()
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    frame now;
    collect(cloud, now);
    write(now);
    return true;
}


void Foam::functionObjects::vtkClumps::write
(
    vtkSeries& series,
    const label index,
    const scalar time,
    const vtkSeries::polyData& data
)
{
    series.write
    (
        time_.globalPath()/"VTK"/cloudName_,
        index,
        time,
        time_.startTime().value(),
        0.5*time_.deltaTValue(),
        data
    );
}


void Foam::functionObjects::vtkClumps::write(const frame& all)
{
    write(spheres_, all.index, all.time, all.spheres);
    write(bonds_, all.index, all.time, all.bonds);
    if (all.hasMembranes)
    {
        write(membranes_, all.index, all.time, all.membranes);
    }
}


void Foam::functionObjects::vtkClumps::collectMembranes
(
    const deformableCloud& cloud,
    vtkSeries::polyData& data
)
{
    data.kind = vtkSeries::triangles;
    DynamicList<vector> velocities, forces;
    DynamicList<scalar> clumps, types;
    for (const clumpParcel& p : cloud)
    {
        const clumpType& type = cloud.type(p);
        if (!type.hasTriangles())
        {
            continue;
        }
        const label first = data.points.size();
        data.points.append(p.centres());
        velocities.append(p.state().u);
        forces.append(-p.fluidForces());
        clumps.append(scalarField(type.size(), p.origId()));
        types.append(scalarField(type.size(), p.typeId()));
        for (const triFace& t : type.surface().triangles())
        {
            for (const label i : t)
            {
                data.corners.append(first + i);
            }
        }
    }
    data.scalars = {{"clump", clumps}, {"type", types}};
    data.vectors = {{"U", velocities}, {"force", forces}};
}
