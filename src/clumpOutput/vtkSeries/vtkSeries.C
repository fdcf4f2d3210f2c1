/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "vtkSeries.H"
#include "fileNameInstant.H"
#include "foamVtkOutput.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "StringStream.H"
#include <fstream>

namespace
{

using namespace Foam;

//- Texts as field data: the codes of their letters, each text ended by 0
void writeTexts
(
    vtk::formatter& format, const word& name, const wordList& texts
)
{
    format.beginFieldData();
    format.openTag
    (
        "Array",
        "type", string("String"),
        "Name", string(name),
        "NumberOfTuples", texts.size(),
        "format", string("ascii")
    );
    format.closeTag();
    for (const word& text : texts)
    {
        for (const char letter : text)
        {
            format.os() << int(letter) << ' ';
        }
        format.os() << "0\n";
    }
    format.endTag("Array");
    format.endFieldData();
}


template<class Type>
void writeField
(
    vtk::formatter& format, const word& name, const UList<Type>& values
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


//- An array of a list of pieces
void declare(std::ostream& os, const word& name, const direction nComponents)
{
    os  << "      <PDataArray type='Float32' Name='" << name
        << "' NumberOfComponents='" << int(nComponents) << "'/>\n";
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


//- Names and times of a series, from the text that OpenFOAM writes
DynamicList<fileNameInstant> entriesOf(const vtk::seriesWriter& series)
{
    OStringStream text;
    series.print(text);
    IStringStream is(text.str());

    DynamicList<fileNameInstant> entries;
    string key;
    for (token t(is); t.good(); is >> t)
    {
        if (t.isString())
        {
            if (key == "name")
            {
                entries.append(fileNameInstant(0, fileName(t.stringToken())));
            }
            key = t.stringToken();
        }
        else if (t.isNumber() && key == "time")
        {
            entries.last().value() = t.number();
        }
    }
    return entries;
}

}


Foam::functionObjects::vtkSeries::vtkSeries(const word& name)
:
    name_(name),
    loaded_(false),
    pieces_(Pstream::parRun())
{}


Foam::fileName Foam::functionObjects::vtkSeries::seriesFile
(
    const fileName& dir,
    const bool pieces
) const
{
    return dir/name_ + (pieces ? ".pvtp" : ".vtp");
}


void Foam::functionObjects::vtkSeries::load
(
    const fileName& dir,
    const scalar start,
    const scalar halfStep,
    const polyData& data
)
{
    if (loaded_)
    {
        return;
    }
    loaded_ = true;

    vtk::seriesWriter lists;
    pieces_ =
        pieces_
     || lists.load(seriesFile(dir, true), true, start - halfStep) > 0;

    files_.load(seriesFile(dir, pieces_), true, start + halfStep);
    if (pieces_)
    {
        vtk::seriesWriter whole;
        whole.load(seriesFile(dir, false), true, start + halfStep);
        for (const fileNameInstant& file : entriesOf(whole))
        {
            const fileName list(file.name().lessExt() + ".pvtp");
            writeList(dir/list, data, fileNameList(1, file.name()));
            files_.append(file.value(), list);
        }
    }

    // Whoever reads the folder shall not find two
    rm(seriesFile(dir, !pieces_) + ".series");
}


namespace
{

using namespace Foam;

//- The points of the cells, of the same number each
void writeCells
(
    vtk::formatter& format,
    const functionObjects::vtkSeries::polyData& data,
    const label nCells,
    const label size
)
{
    typedef functionObjects::vtkSeries series;
    const bool polygons = data.kind == series::triangles;
    const auto tag =
        polygons ? vtk::fileTag::POLYS
      : data.kind == series::lines ? vtk::fileTag::LINES : vtk::fileTag::VERTS;
    format.tag(tag);
    format.beginDataArray<label>(vtk::dataArrayAttr::CONNECTIVITY);
    format.writeSize(vtk::sizeofData<label>(size*nCells));
    if (polygons)
    {
        vtk::writeList(format, data.corners);
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

}


void Foam::functionObjects::vtkSeries::writeData
(
    const fileName& file,
    const polyData& data
)
{
    std::ofstream os(file);
    autoPtr<vtk::formatter> formatter
    (
        vtk::newFormatter(os, vtk::formatType::INLINE_BASE64)
    );
    vtk::formatter& format = *formatter;
    format.xmlHeader().beginVTKFile<vtk::fileTag::POLY_DATA>();
    if (!data.textName.empty())
    {
        writeTexts(format, data.textName, data.texts);
    }

    const bool polygons = data.kind == triangles;
    const label size = polygons ? 3 : data.kind == lines ? 2 : 1;
    const label nCells =
        polygons ? data.corners.size()/3 : data.points.size()/size;
    format
        .tag
        (
            vtk::fileTag::PIECE,
            vtk::fileAttr::NUMBER_OF_POINTS, data.points.size(),
            vtk::fileAttr::NUMBER_OF_VERTS, data.kind == vertices ? nCells : 0,
            vtk::fileAttr::NUMBER_OF_LINES, data.kind == lines ? nCells : 0,
            vtk::fileAttr::NUMBER_OF_POLYS, polygons ? nCells : 0
        );

    format.tag(vtk::fileTag::POINTS);
    format.beginDataArray<float, 3>(vtk::dataArrayAttr::POINTS);
    format.writeSize(vtk::sizeofData<float, 3>(data.points.size()));
    vtk::writeList(format, data.points);
    format.flush();
    format.endDataArray();
    format.endTag(vtk::fileTag::POINTS);

    writeCells(format, data, nCells, size);

    if (data.isCellData)
    {
        format.beginCellData();
    }
    else
    {
        format.beginPointData();
    }
    for (const auto& field : data.scalars)
    {
        writeField(format, field.first(), field.second());
    }
    for (const auto& field : data.vectors)
    {
        writeField(format, field.first(), field.second());
    }
    if (data.isCellData)
    {
        format.endCellData();
    }
    else
    {
        format.endPointData();
    }
    format.endPiece();
    format.endTag(vtk::fileTag::POLY_DATA).endVTKFile();
    refuseUnwritten(os, file);
}


void Foam::functionObjects::vtkSeries::writeList
(
    const fileName& file,
    const polyData& data,
    const fileNameList& pieces
)
{
    const char* const values = data.isCellData ? "PCellData" : "PPointData";
    std::ofstream os(file);
    os  << "<?xml version='1.0'?>\n"
        << "<VTKFile type='PPolyData' version='0.1'>\n"
        << "  <PPolyData GhostLevel='0'>\n"
        << "    <PPoints>\n";
    declare(os, "Points", 3);
    os  << "    </PPoints>\n"
        << "    <" << values << ">\n";
    for (const auto& field : data.scalars)
    {
        declare(os, field.first(), 1);
    }
    for (const auto& field : data.vectors)
    {
        declare(os, field.first(), 3);
    }
    os  << "    </" << values << ">\n";
    for (const fileName& piece : pieces)
    {
        os  << "    <Piece Source='" << piece << "'/>\n";
    }
    os  << "  </PPolyData>\n"
        << "</VTKFile>\n";
    refuseUnwritten(os, file);
}


void Foam::functionObjects::vtkSeries::write
(
    const fileName& dir,
    const label index,
    const scalar time,
    const scalar start,
    const scalar halfStep,
    const polyData& data
)
{
    if (Pstream::master())
    {
        mkDir(dir);
        load(dir, start, halfStep, data);
    }

    const fileName stem(name_ + "_" + Foam::name(index));
    const fileName file(stem + (pieces_ ? ".pvtp" : ".vtp"));
    if (pieces_)
    {
        const auto piece = [&](const label proci)
        {
            return fileName(stem/stem + "_" + Foam::name(proci) + ".vtp");
        };

        // That of the master has the texts
        const bool own = Pstream::master() || data.points.size();
        if (own)
        {
            mkDir(dir/stem);
            writeData(dir/piece(Pstream::myProcNo()), data);
        }

        // The pieces exist when the list does
        boolList some(Pstream::nProcs());
        some[Pstream::myProcNo()] = own;
        Pstream::gatherList(some);
        if (Pstream::master())
        {
            DynamicList<fileName> pieces;
            forAll(some, proci)
            {
                if (some[proci])
                {
                    pieces.append(piece(proci));
                }
            }
            writeList(dir/file, data, fileNameList(pieces));
        }
    }
    else
    {
        writeData(dir/file, data);
    }

    if (Pstream::master())
    {
        files_.append(time, file);
        files_.sort();
        files_.write(seriesFile(dir, pieces_));
    }
}
