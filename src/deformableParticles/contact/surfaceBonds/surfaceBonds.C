/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceBonds.H"
#include "ListListOps.H"
#include "Pstream.H"
#include "Time.H"
#include <cstdint>
#include <limits>
#include <tuple>

namespace Foam
{
    defineTypeNameAndDebug(surfaceBonds, 0);
}


namespace
{

//- The output function of the generator SplitMix64 (Steele, Lea and Flood 2014, OOPSLA,
//  doi:10.1145/2660193.2660195)
std::uint64_t mixed(std::uint64_t z)
{
    z += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30))*0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27))*0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}


//- Of the characters of a word, on any machine
std::uint64_t mixed(const Foam::word& name)
{
    std::uint64_t result = 0;
    for (const char c : name)
    {
        result = mixed(result ^ std::uint64_t(static_cast<unsigned char>(c)));
    }
    return result;
}

}


bool Foam::surfaceBond::sameSpheres(const surfaceBond& other) const
{
    return
        law == other.law
     && patch == other.patch
     && clump == other.clump
     && sphere == other.sphere;
}


bool Foam::surfaceBond::operator<(const surfaceBond& other) const
{
    const auto key = [](const surfaceBond& b)
    {
        return std::make_tuple
        (
            b.clump.first(), b.clump.second(), b.sphere.first(), b.sphere.second(),
            std::string(b.patch), std::string(b.law), b.place
        );
    };
    return key(*this) < key(other);
}


bool Foam::surfaceBond::operator==(const surfaceBond& other) const
{
    return
        sameSpheres(other)
     && place == other.place
     && born == other.born
     && anchor == other.anchor
     && otherAnchor == other.otherAnchor
     && length == other.length;
}


Foam::Ostream& Foam::operator<<(Ostream& os, const surfaceBond& b)
{
    // A word may be empty
    return os
        << string(b.law) << token::SPACE << string(b.patch) << token::SPACE
        << b.clump.first() << token::SPACE << b.clump.second() << token::SPACE
        << b.sphere.first() << token::SPACE << b.sphere.second() << token::SPACE
        << b.place << token::SPACE << b.born << token::SPACE
        << b.anchor << token::SPACE << b.otherAnchor << token::SPACE << b.length;
}


Foam::Istream& Foam::operator>>(Istream& is, surfaceBond& b)
{
    string law, patch;
    is  >> law >> patch
        >> b.clump.first() >> b.clump.second()
        >> b.sphere.first() >> b.sphere.second()
        >> b.place >> b.born >> b.anchor >> b.otherAnchor >> b.length;
    b.law = law;
    b.patch = patch;
    return is;
}


Foam::surfaceBonds::surfaceBonds(const Time& time)
:
    regIOobject
    (
        IOobject
        (
            typeName, time.timeName(), "uniform", time,
            IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        )
    ),
    longest_(0)
{
    if (headerOk())
    {
        readStream(typeName) >> bonds_;
        close();
    }
    setLongest();
}


void Foam::surfaceBonds::setLongest()
{
    longest_ = 0;
    for (const surfaceBond& b : bonds_)
    {
        longest_ = max(longest_, b.length);
    }
}


void Foam::surfaceBonds::replace(const UList<surfaceBond>& own)
{
    List<List<surfaceBond>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = own;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    bonds_ =
        ListListOps::combine<List<surfaceBond>>(all, accessOp<List<surfaceBond>>());
    sort(bonds_);
    setLongest();
}


Foam::scalar Foam::surfaceBonds::uniform
(
    const chance what,
    const label seed,
    const surfaceBond& b,
    const label timeIndex
)
{
    std::uint64_t h = mixed(std::uint64_t(seed));
    for
    (
        const label value
      : {
            label(what), b.clump.first(), b.clump.second(), b.sphere.first(),
            b.sphere.second(), b.place, timeIndex
        }
    )
    {
        h = mixed(h ^ std::uint64_t(value));
    }
    h = mixed(h ^ mixed(b.law));
    h = mixed(h ^ mixed(b.patch));
    return std::ldexp(scalar(h >> 11), -53);
}


bool Foam::surfaceBonds::writeData(Ostream& os) const
{
    // Every bit, for the restart
    const int precision =
        os.precision(std::numeric_limits<scalar>::max_digits10);
    os  << bonds_ << nl;
    os.precision(precision);
    return os.good();
}
