/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "csvTable.H"
#include "error.H"
#include <cmath>
#include <cstdlib>
#include <fstream>

Foam::stringList Foam::csvTable::split(const std::string& line)
{
    DynamicList<string> cells;
    std::string::size_type start = 0;

    while (start != std::string::npos)
    {
        const auto comma = line.find(',', start);
        std::string cell(line.substr(start, comma - start));
        start = comma == std::string::npos ? comma : comma + 1;

        const auto first = cell.find_first_not_of(" \t\r\"");
        const auto last = cell.find_last_not_of(" \t\r\"");
        cells.append
        (
            first == std::string::npos
          ? string() : string(cell.substr(first, last - first + 1))
        );
    }

    return stringList(std::move(cells));
}


Foam::csvTable::csvTable(const fileName& file)
:
    file_(file)
{
    std::ifstream is(file);
    if (!is)
    {
        FatalErrorInFunction
            << "Cannot read the table " << file << exit(FatalError);
    }

    std::string line;
    for (label n = 1; std::getline(is, line); ++n)
    {
        const auto first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#')
        {
            continue;
        }

        const stringList cells(split(line));
        if (columns_.empty())
        {
            columns_ = cells;
            continue;
        }

        rows_.append(cells);
        lines_.append(n);
        if (cells.size() != columns_.size())
        {
            fail
            (
                rows_.size() - 1,
                name(cells.size()) + " cells under "
              + name(columns_.size()) + " column names"
            );
        }
    }

    if (rows_.empty())
    {
        FatalErrorInFunction
            << "The table " << file << " has no rows" << exit(FatalError);
    }
}


Foam::label Foam::csvTable::column(const string& name) const
{
    const label c = columns_.find(name);
    if (c < 0)
    {
        FatalErrorInFunction
            << "The table " << file_ << " has no column '" << name
            << "'. Its columns are " << columns_ << exit(FatalError);
    }
    return c;
}


Foam::scalar Foam::csvTable::number(const label row, const label column) const
{
    const string& cell = rows_[row][column];
    char* end = nullptr;
    const scalar value = std::strtod(cell.c_str(), &end);

    if (cell.empty() || *end || !std::isfinite(value))
    {
        fail
        (
            row,
            "column " + columns_[column] + " holds '" + cell
          + "', which is no number"
        );
    }
    return value;
}


void Foam::csvTable::fail(const label row, const string& what) const
{
    FatalErrorInFunction
        << file_.c_str() << ", line " << lines_[row] << ": " << what.c_str()
        << exit(FatalError);
}
