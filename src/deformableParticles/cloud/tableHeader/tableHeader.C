/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tableHeader.H"
#include "error.H"
#include "Ostream.H"

Foam::functionObjects::tableHeader&
Foam::functionObjects::tableHeader::add(const word& name, const string& unit)
{
    if (names_.found(name))
    {
        FatalErrorInFunction
            << "The table '" << title_.c_str() << "' has two columns "
            << name << exit(FatalError);
    }
    names_.append(name);
    units_.append(unit);
    return *this;
}


Foam::functionObjects::tableHeader&
Foam::functionObjects::tableHeader::addVector
(
    const word& name,
    const string& unit
)
{
    return add(name + "x", unit).add(name + "y", unit).add(name + "z", unit);
}


Foam::functionObjects::tableHeader&
Foam::functionObjects::tableHeader::explain
(
    const string& columns,
    const string& meaning
)
{
    explanations_.append(columns + ": " + meaning);
    return *this;
}


Foam::functionObjects::tableHeader&
Foam::functionObjects::tableHeader::add(const tableHeader& further)
{
    explanations_.append(further.explanations_);
    forAll(further.names_, i)
    {
        add(further.names_[i], further.units_[i]);
    }
    return *this;
}


void Foam::functionObjects::tableHeader::write(Ostream& os) const
{
    os << "# " << title_.c_str() << nl;
    for (const string& line : explanations_)
    {
        os << "#   " << line.c_str() << nl;
    }
    os << "# ";
    forAll(names_, i)
    {
        os << (i ? "\t" : "") << names_[i].c_str();
        if (!units_[i].empty())
        {
            os << '[' << units_[i].c_str() << ']';
        }
    }
    os << nl;
    forAll(names_, i)
    {
        os << (i ? "\t" : "") << names_[i].c_str();
    }
    os << nl;
}
