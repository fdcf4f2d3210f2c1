/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "vtkClumps.H"
#include "deformableCloud.H"
#include "bondForces.H"
#include "foamVtkOutput.H"
#include "globalIndex.H"
#include "addToRunTimeSelectionTable.H"
#include "OSspecific.H"
#include <fstream>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(vtkClumps, 0);
    addToRunTimeSelectionTable(functionObject, vtkClumps, dictionary);
}
}

namespace
{

using namespace Foam;

//- Values of all processors, on the master
template<class Type>
List<Type> gathered(const DynamicList<Type>& local)
{
    List<List<Type>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = local;
    Pstream::gatherList(all);

    DynamicList<Type> result;
    for (const List<Type>& part : all)
    {
        result.append(part);
    }
    return List<Type>(result);
}


//- The name of every type as field data: texts are the codes of their letters,
//  each ended by 0
void writeTypeNames(vtk::formatter& format, const PtrList<clumpType>& types)
{
    format.beginFieldData();
    format.openTag
    (
        "Array",
        "type", string("String"),
        "Name", string("typeNames"),
        "NumberOfTuples", types.size(),
        "format", string("ascii")
    );
    format.closeTag();
    for (const clumpType& type : types)
    {
        for (const char letter : type.name())
        {
            format.os() << int(letter) << ' ';
        }
        format.os() << "0\n";
    }
    format.endTag("Array");
    format.endFieldData();
}


//- Start of a piece of polydata: points, and vertices or lines in order
void beginPiece
(
    vtk::formatter& format,
    const List<point>& points,
    const label nVerts,
    const label nLines,
    const labelList& triangles = labelList()
)
{
    format
        .tag
        (
            vtk::fileTag::PIECE,
            vtk::fileAttr::NUMBER_OF_POINTS, points.size(),
            vtk::fileAttr::NUMBER_OF_VERTS, nVerts,
            vtk::fileAttr::NUMBER_OF_LINES, nLines,
            vtk::fileAttr::NUMBER_OF_POLYS, triangles.size()/3
        );

    format.tag(vtk::fileTag::POINTS);
    format.beginDataArray<float, 3>(vtk::dataArrayAttr::POINTS);
    format.writeSize(vtk::sizeofData<float, 3>(points.size()));
    vtk::writeList(format, points);
    format.flush();
    format.endDataArray();
    format.endTag(vtk::fileTag::POINTS);

    const bool polygons = triangles.size();
    const label nCells = nVerts + nLines + triangles.size()/3;
    const label size = polygons ? 3 : nLines ? 2 : 1;
    const auto tag =
        polygons ? vtk::fileTag::POLYS
      : nLines ? vtk::fileTag::LINES : vtk::fileTag::VERTS;

    format.tag(tag);
    format.beginDataArray<label>(vtk::dataArrayAttr::CONNECTIVITY);
    format.writeSize(vtk::sizeofData<label>(size*nCells));
    if (polygons)
    {
        vtk::writeList(format, triangles);
    }
    else
    {
        // Point i belongs to cell i/size
        vtk::writeIdentity(format, size*nCells);
    }
    format.flush();
    format.endDataArray();

    format.beginDataArray<label>(vtk::dataArrayAttr::OFFSETS);
    format.writeSize(vtk::sizeofData<label>(nCells));
    for (label i = 1; i <= nCells; ++i)
    {
        format.write(size*i);
    }
    format.flush();
    format.endDataArray();
    format.endTag(tag);
}


template<class Type>
void writeField
(
    vtk::formatter& format, const word& name, const List<Type>& values
)
{
    format.beginDataArray<float, pTraits<Type>::nComponents>(name);
    format.writeSize
    (
        vtk::sizeofData<float, pTraits<Type>::nComponents>(values.size())
    );
    vtk::writeList(format, values);
    format.flush();
    format.endDataArray();
}


//- Fatal when not all of the file could be written
void refuseUnwritten(std::ofstream& os, const fileName& file)
{
    os.close();
    if (!os)
    {
        FatalErrorInFunction << "cannot write " << file << exit(FatalError);
    }
}


void endPiece(vtk::formatter& format)
{
    format.endPiece();
    format.endTag(vtk::fileTag::POLY_DATA).endVTKFile();
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
    loaded_(false)
{
    read(dict);

    // Nothing is written before the first step: other input may be wrong
    if (!functionObject::postProcess && time_.timeIndex() == 0)
    {
        gather(mesh_.lookupObject<deformableCloud>(cloudName_), start_);
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


void Foam::functionObjects::vtkClumps::load(const fileName& dir)
{
    if (!loaded_)
    {
        const scalar end = time_.startTime().value() + 0.5*time_.deltaTValue();
        spheres_.load(dir/"spheres.vtp", true, end);
        bonds_.load(dir/"bonds.vtp", true, end);
        membranes_.load(dir/"membranes.vtp", true, end);
        loaded_ = true;
    }
}


bool Foam::functionObjects::vtkClumps::read(const dictionary& dict)
{
    checkEntries(dict, {"cloud"}, functionObjectEntries());
    cloudName_ = deformableCloud::findName(mesh_, dict);
    return fvMeshFunctionObject::read(dict);
}


void Foam::functionObjects::vtkClumps::gather
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

        for (label i = 0; i < x.size() && !type.hasSurface(); ++i)
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
    all.centres = gathered(centres);
    all.radii = gathered(radii);
    all.clumps = gathered(clumps);
    all.numbers = gathered(numbers);
    all.types = gathered(types);
    all.velocities = gathered(velocities);
    all.forces = gathered(forces);
    all.ends = gathered(ends);
    all.tension = gathered(tension);
    all.bondClumps = gathered(bondClumps);
}


bool Foam::functionObjects::vtkClumps::write()
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    frame all;
    gather(cloud, all);
    writeMembranes(cloud);
    write(all);
    return true;
}


void Foam::functionObjects::vtkClumps::write(const frame& all)
{
    if (!Pstream::master())
    {
        return;
    }

    const auto& types = mesh_.lookupObject<deformableCloud>(cloudName_).types();
    const fileName dir(time_.globalPath()/"VTK"/cloudName_);
    mkDir(dir);
    load(dir);
    const word step("_" + Foam::name(all.index) + ".vtp");

    {
        const fileName file(dir/"spheres" + step);
        std::ofstream os(file);
        autoPtr<vtk::formatter> format
        (
            vtk::newFormatter(os, vtk::formatType::INLINE_BASE64)
        );
        format->xmlHeader().beginVTKFile<vtk::fileTag::POLY_DATA>();
        writeTypeNames(*format, types);
        beginPiece(*format, all.centres, all.centres.size(), 0);
        format->beginPointData();
        writeField(*format, "radius", all.radii);
        writeField(*format, "clump", all.clumps);
        writeField(*format, "sphere", all.numbers);
        writeField(*format, "type", all.types);
        writeField(*format, "U", all.velocities);
        writeField(*format, "fluidForce", all.forces);
        format->endPointData();
        endPiece(*format);
        refuseUnwritten(os, file);
        spheres_.append(all.time, file.name());
        spheres_.sort();
        spheres_.write(dir/"spheres.vtp");
    }
    {
        const fileName file(dir/"bonds" + step);
        std::ofstream os(file);
        autoPtr<vtk::formatter> format
        (
            vtk::newFormatter(os, vtk::formatType::INLINE_BASE64)
        );
        format->xmlHeader().beginVTKFile<vtk::fileTag::POLY_DATA>();
        beginPiece(*format, all.ends, 0, all.ends.size()/2);
        format->beginCellData();
        writeField(*format, "axialForce", all.tension);
        writeField(*format, "clump", all.bondClumps);
        format->endCellData();
        endPiece(*format);
        refuseUnwritten(os, file);
        bonds_.append(all.time, file.name());
        bonds_.sort();
        bonds_.write(dir/"bonds.vtp");
    }
}


void Foam::functionObjects::vtkClumps::writeMembranes
(
    const deformableCloud& cloud
)
{
    bool some = false;
    for (const clumpType& type : cloud.types())
    {
        some = some || type.hasSurface();
    }
    if (!some)
    {
        return;
    }

    DynamicList<point> nodes;
    DynamicList<vector> velocities, forces;
    DynamicList<scalar> clumps;
    DynamicList<label> corners;
    for (const clumpParcel& p : cloud)
    {
        const clumpType& type = cloud.type(p);
        if (!type.hasSurface())
        {
            continue;
        }
        const label first = nodes.size();
        nodes.append(p.centres());
        velocities.append(p.state().u);
        forces.append(-p.fluidForces());
        clumps.append(scalarField(type.size(), p.origId()));
        for (const triFace& t : type.surface().triangles())
        {
            for (const label i : t)
            {
                corners.append(first + i);
            }
        }
    }

    // The nodes of a processor follow those of the ones before
    const globalIndex order(nodes.size());
    for (label& i : corners)
    {
        i = order.toGlobal(i);
    }
    const List<point> allNodes(gathered(nodes));
    const List<vector> allVelocities(gathered(velocities));
    const List<vector> allForces(gathered(forces));
    const List<scalar> allClumps(gathered(clumps));
    const List<label> allCorners(gathered(corners));
    if (!Pstream::master())
    {
        return;
    }

    const fileName dir(time_.globalPath()/"VTK"/cloud.name());
    mkDir(dir);
    load(dir);
    const fileName file
    (
        dir/"membranes_" + Foam::name(time_.timeIndex()) + ".vtp"
    );
    std::ofstream os(file);
    autoPtr<vtk::formatter> format
    (
        vtk::newFormatter(os, vtk::formatType::INLINE_BASE64)
    );
    format->xmlHeader().beginVTKFile<vtk::fileTag::POLY_DATA>();
    beginPiece(*format, allNodes, 0, 0, allCorners);
    format->beginPointData();
    writeField(*format, "clump", allClumps);
    writeField(*format, "U", allVelocities);
    writeField(*format, "force", allForces);
    format->endPointData();
    endPiece(*format);
    refuseUnwritten(os, file);
    membranes_.append(time_.value(), file.name());
    membranes_.sort();
    membranes_.write(dir/"membranes.vtp");
}
