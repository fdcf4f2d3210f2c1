/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "suspensionTable.H"
#include "checkedEntries.H"
#include <cmath>
#include <limits>

Foam::functionObjects::suspensionTable::suspensionTable
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const word& fileName,
    const wordList& further
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, fileName),
    entries_({"cloud", "flow", "gradient"})
{
    entries_.append(further);
}


bool Foam::functionObjects::suspensionTable::read(const dictionary& dict)
{
    checkEntries(dict, entries_, functionObjectEntries());
    cloudName_ = deformableCloud::findName(mesh_, dict);
    axes_ = flowAxes(dict);
    return fvMeshFunctionObject::read(dict) && table_.read(dict);
}


const Foam::deformableCloud&
Foam::functionObjects::suspensionTable::cloud() const
{
    return mesh_.lookupObject<deformableCloud>(cloudName_);
}


Foam::scalar Foam::functionObjects::suspensionTable::ratio
(
    const scalar a,
    const scalar b
)
{
    return
        std::isnan(a) || std::isnan(b) || mag(b) < VSMALL
      ? std::numeric_limits<scalar>::quiet_NaN()
      : a/b;
}


void Foam::functionObjects::suspensionTable::sumUp(scalarList& values)
{
    Pstream::listCombineGather(values, plusEqOp<scalar>());
}


void Foam::functionObjects::suspensionTable::writeRow
(
    const scalarList& values
)
{
    const tableHeader further(header());
    tableHeader all(further.title());
    Ostream& os = table_.open(all.add("time", "s").add(further));
    os  << time_.timeOutputValue();
    for (const scalar value : values)
    {
        os  << '\t' << value;
    }
    os  << nl;
    table_.flush();
}
