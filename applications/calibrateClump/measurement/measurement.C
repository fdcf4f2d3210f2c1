/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "measurement.H"
#include "HashSet.H"
#include "modelSelection.H"
#include "MinMax.H"
#include "Pair.H"

namespace
{

using namespace Foam;

//- A column's name or a cell's text: a word, a quoted string or a number
string textOf(const dictionary& dict, const word& key)
{
    const token t(dict.lookup(key));
    return
        t.isWord() ? string(t.wordToken())
      : t.isString() ? t.stringToken()
      : string(Foam::name(t.number()));
}


//- Intervals of the abscissa that are not fitted
List<scalarMinMax> intervals(const dictionary& dict)
{
    const List<Pair<scalar>> ends
    (
        dict.getOrDefault("heldOut", List<Pair<scalar>>())
    );
    List<scalarMinMax> result(ends.size());
    forAll(ends, k)
    {
        if (ends[k].first() > ends[k].second())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'heldOut' has the interval " << ends[k]
                << "; its lower end comes first." << exit(FatalIOError);
        }
        result[k] = scalarMinMax(ends[k].first(), ends[k].second());
    }
    return result;
}


//- Half an error bar, in the table's unit; 0 where none is given
scalar errorBar(const csvTable& table, const label row, const dictionary& v)
{
    scalar error = 0;

    if (v.found("errorColumn"))
    {
        const label e = table.column(textOf(v, "errorColumn"));
        if (table.empty(row, e))
        {
            return 0;
        }
        error = table.number(row, e);
    }
    else if (v.found("boundColumns"))
    {
        const Pair<word> names(v.lookup("boundColumns"));
        const label low = table.column(names.first());
        const label high = table.column(names.second());
        if (table.empty(row, low) || table.empty(row, high))
        {
            return 0;
        }
        error = 0.5*(table.number(row, high) - table.number(row, low));
    }
    else
    {
        return 0;
    }

    if (error <= 0)
    {
        table.fail(row, "an error bar must be positive");
    }
    return error;
}

}


void Foam::measurement::addAbscissa
(
    const csvTable& table,
    const label row,
    const scalar x
)
{
    if (abscissas_.size() && x < abscissas_.last())
    {
        table.fail(row, "the abscissa is lower than in the row before");
    }
    abscissas_.append(x);
}


void Foam::measurement::addPoints
(
    const csvTable& table,
    const label row,
    const dictionary& values,
    const bool heldOut
)
{
    forAll(quantities_, q)
    {
        if (!values.found(quantities_[q]))
        {
            continue;
        }
        const dictionary& v = values.subDict(quantities_[q]);
        const label column = table.column(textOf(v, "column"));
        const scalar unit = getPositive(v, "unit");
        if (table.empty(row, column))
        {
            continue;
        }

        point p;
        p.abscissa = abscissas_.size() - 1;
        p.quantity = q;
        p.value = unit*table.number(row, column);
        p.line = table.line(row);
        p.heldOut = heldOut;
        p.error = unit*errorBar(table, row, v);
        if (p.error <= 0)
        {
            if (!v.found("relativeError"))
            {
                table.fail
                (
                    row,
                    "there is no error bar for " + quantities_[q]
                  + "; give the entry relativeError for such rows"
                );
            }
            p.error = getPositive(v, "relativeError")*mag(p.value);
        }
        points_.append(p);
    }
}


Foam::measurement::measurement
(
    const dictionary& dict,
    const fileName& folder,
    const wordList& quantities
)
:
    quantities_(quantities)
{
    checkEntries(dict, {"file", "select", "abscissa", "values", "heldOut"});
    const fileName name(getEntry<fileName>(dict, "file"));
    file_ = name.isAbsolute() ? name : folder/name;
    const csvTable table(file_);

    label selectColumn = -1;
    string selected;
    if (dict.found("select"))
    {
        const dictionary& s = dict.subDict("select");
        selectColumn = table.column(textOf(s, "column"));
        selected = textOf(s, "value");
    }

    const dictionary& abscissa = dict.subDict("abscissa");
    const label abscissaColumn = table.column(textOf(abscissa, "column"));
    const scalar abscissaUnit = getPositive(abscissa, "unit");
    const dictionary& values = dict.subDict("values");
    const List<scalarMinMax> heldOut(intervals(dict));
    labelHashSet matched;        // intervals with a point

    for (const word& q : values.toc())
    {
        if (!quantities_.found(q))
        {
            FatalIOErrorInFunction(values)
                << "Unknown quantity '" << q << "'. Valid quantities: "
                << quantities_ << exit(FatalIOError);
        }
    }

    for (label row = 0; row < table.size(); ++row)
    {
        if (selectColumn >= 0 && table.text(row, selectColumn) != selected)
        {
            continue;
        }

        const scalar inTable = table.number(row, abscissaColumn);
        addAbscissa(table, row, abscissaUnit*inTable);

        bool isHeldOut = false;
        forAll(heldOut, k)
        {
            if (heldOut[k].contains(inTable))
            {
                isHeldOut = true;
                matched.insert(k);
            }
        }
        addPoints(table, row, values, isHeldOut);
    }

    forAll(heldOut, k)
    {
        if (!matched.found(k))
        {
            WarningInFunction
                << "Entry 'heldOut': no point lies in the interval ("
                << heldOut[k].min() << ' ' << heldOut[k].max() << ") of the column "
                << textOf(abscissa, "column").c_str() << ", which is in the unit of "
                << file_ << '.' << endl;
        }
    }

    if (abscissas_.size() < 2)
    {
        FatalIOErrorInFunction(dict)
            << "A curve needs at least two points; the file " << file_
            << " has " << abscissas_.size() << (selectColumn >= 0 ? " of " : "")
            << selected.c_str() << exit(FatalIOError);
    }
}


Foam::label Foam::measurement::nFitted() const
{
    label n = 0;
    for (const point& p : points_)
    {
        n += !p.heldOut;
    }
    return n;
}
