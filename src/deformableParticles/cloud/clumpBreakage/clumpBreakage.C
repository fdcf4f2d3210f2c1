/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpBreakage.H"
#include "bondForces.H"
#include "clumpPieces.H"
#include "clumpSource.H"
#include "clumpSuspension.H"
#include "foamCompat.H"

namespace
{

using namespace Foam;

//- Those of all processors, by their numbers
template<class Type>
List<Type> gathered(const List<Type>& here)
{
    List<List<Type>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = here;
    gatherToAll(all);
    DynamicList<Type> result;
    for (const List<Type>& some : all)
    {
        result.append(some);
    }
    Foam::stableSort
    (
        result,
        [](const Type& a, const Type& b)
        {
            const labelPair& s = a.first();
            const labelPair& t = b.first();
            return
                s.first() < t.first()
             || (s.first() == t.first() && s.second() < t.second());
        }
    );
    return List<Type>(result);
}

}


Foam::clumpBreakage::clumpBreakage(const objectRegistry& mesh)
:
    table_(mesh, "brokenBonds", "brokenBonds")
{}


bool Foam::clumpBreakage::breakable(const clumpSuspension& clumps)
{
    for (const clumpBonds& bonds : clumps.bonds())
    {
        if (bonds.breakable())
        {
            return true;
        }
    }
    return false;
}


void Foam::clumpBreakage::note(const clumpSuspension& clumps)
{
    here_.clear();
    if (!breakable(clumps))
    {
        return;
    }
    for (const clumpParcel& p : clumps)
    {
        const clumpType& type = clumps.type(p);
        const clumpState& s = p.step().end;
        const scalarField& before = p.state().broken;
        forAll(s.broken, b)
        {
            if (s.broken[b] == 0 || (before.size() && before[b] != 0))
            {
                continue;
            }
            const labelPair& pair = type.pairs()[b];
            const labelPair spheres
            (
                type.numberInWhole(pair.first()), type.numberInWhole(pair.second())
            );
            const point place
            (
                p.position() + 0.5*(s.x[pair.first()] + s.x[pair.second()])
            );
            OStringStream said;
            said<< "Bond " << b << " of clump " << p.origId() << " (" << type.name()
                << "), between the spheres " << spheres.first() << " and "
                << spheres.second() << ", has broken at " << place;

            const Pair<scalar> stresses(bondForces(clumps.bonds(p)).stresses(s, b));
            OStringStream row;
            row.precision(10);
            row << type.name() << '\t' << b << '\t' << spheres.first() << '\t'
                << spheres.second() << '\t' << place.x() << '\t' << place.y() << '\t'
                << place.z() << '\t' << stresses.first() << '\t' << stresses.second();

            here_.append
            (
                bondBreak
                (
                    labelPair(p.origId(), b),
                    List<string>
                    ({
                        said.str(), row.str(),
                        Foam::name(clumpPieces(type, s).size())
                    })
                )
            );
        }
    }
}


Foam::List<Foam::clumpBreakage::division> Foam::clumpBreakage::divisions
(
    const clumpSuspension& clumps,
    const bool all
) const
{
    labelHashSet broken;
    for (const bondBreak& b : here_)
    {
        broken.insert(b.first().first());
    }
    DynamicList<division> result;
    for (const clumpParcel& p : clumps)
    {
        if (p.state().broken.empty() || !(all || broken.found(p.origId())))
        {
            continue;
        }
        const clumpType& type = clumps.type(p);
        const clumpPieces pieces(type, p.state());
        if (pieces.size() < 2)
        {
            continue;
        }
        labelListList numbers(pieces.size());
        forAll(numbers, n)
        {
            for (const label i : pieces[n])
            {
                numbers[n].append(type.numberInWhole(i));
            }
        }
        result.append(division(labelPair(p.origId(), p.typeId()), numbers));
    }
    return List<division>(result);
}


void Foam::clumpBreakage::divide
(
    clumpSuspension& clumps,
    const division& d,
    const labelUList& types,
    const label next
)
{
    clumpParcel* whole = nullptr;
    for (clumpParcel& p : clumps)
    {
        if (p.origId() == d.first().first() && p.typeId() == d.first().second())
        {
            whole = &p;
        }
    }
    if (!whole)
    {
        return;
    }

    const clumpType& type = clumps.type(*whole);
    const auto become = [&](clumpParcel& p, const label n)
    {
        labelList spheres(d.second()[n]);
        for (label& i : spheres)
        {
            i = type.sphere(i);
        }
        p.becomePiece(types[n], spheres, clumps.types()[types[n]].bondsOf(type));
    };
    for (label n = 1; n < types.size(); ++n)
    {
        auto* p = new clumpParcel(*whole);
        become(*p, n);
        p->origId() = next + n - 1;
        clumps.addParticle(p);
    }
    become(*whole, 0);
}


void Foam::clumpBreakage::divide
(
    clumpSuspension& clumps,
    clumpSource& numbers,
    clumpCount& count,
    const bool all
)
{
    if (!breakable(clumps))
    {
        return;
    }
    if (!returnReduce(all || here_.size(), orOp<bool>()))
    {
        return;
    }
    const List<bondBreak> breaks(gathered(List<bondBreak>(here_)));
    const List<division> broken(gathered(divisions(clumps, all)));
    here_.clear();

    label nAdded = 0;
    for (const division& d : broken)
    {
        nAdded += d.second().size() - 1;
    }
    label next = nAdded ? numbers.newNumbers(nAdded) : 0;
    Map<labelList> added;
    string said;
    for (const division& d : broken)
    {
        const label n = d.second().size();
        const clumpType& type = clumps.types()[d.first().second()];
        const label whole = type.whole(d.first().second());
        labelList types(n);
        OStringStream os;
        os  << "Clump " << d.first().first() << " (" << type.name() << ") is now the clumps";
        forAll(types, k)
        {
            types[k] = clumps.pieceType(whole, d.second()[k]);
            os  << (k ? ", " : " ") << (k ? next + k - 1 : d.first().first()) << " ("
                << clumps.types()[types[k]].name() << ')';
        }
        os  << nl;
        said += os.str();
        divide(clumps, d, types, next);
        added.insert(d.first().first(), identity(n - 1, next));
        next += n - 1;
    }
    if (nAdded)
    {
        count.breakOff(nAdded);
    }
    announce(clumps, breaks, added);
    Info<< said.c_str() << flush;
}


Foam::functionObjects::tableHeader Foam::clumpBreakage::header()
{
    functionObjects::tableHeader result("Bonds that have broken");
    result.add("time", "s").add("clump").add("type").add("bond").add("sphere1")
       .add("sphere2").addVector("place", "m").add("sigma", "Pa").add("tau", "Pa")
       .add("pieces").add("added")
       .explain("clump type bond", "number of the clump, name of its type, and number of"
            " the bond in this type")
       .explain("sphere1 sphere2", "spheres that it joined, with their numbers in the"
            " whole clump")
       .explain("placex placey placez", "the middle between them")
       .explain("sigma tau", "tensile and shear stress at which it broke (see bondModel)")
       .explain("pieces added", "number of the clump's pieces at the end of the step, and"
            " the numbers of the clumps that were added, - if there are none");
    return result;
}


void Foam::clumpBreakage::announce
(
    const clumpSuspension& clumps,
    const UList<bondBreak>& breaks,
    const Map<labelList>& added
)
{
    const Time& time = clumps.mesh().time();
    for (const bondBreak& b : breaks)
    {
        Info<< "Time " << time.timeName() << ": " << b.second()[0].c_str() << "; pieces: "
            << b.second()[2].c_str() << nl;
    }
    if (!Pstream::master() || breaks.empty())
    {
        return;
    }
    Ostream& os = table_.open(header());
    for (const bondBreak& b : breaks)
    {
        os  << time.timeOutputValue() << '\t' << b.first().first() << '\t'
            << b.second()[1].c_str() << '\t' << b.second()[2].c_str() << '\t';
        const labelList numbers(added.lookup(b.first().first(), labelList()));
        if (numbers.empty())
        {
            os  << '-';
        }
        forAll(numbers, k)
        {
            os  << (k ? "," : "") << numbers[k];
        }
        os  << nl;
    }
    table_.flush();
}
