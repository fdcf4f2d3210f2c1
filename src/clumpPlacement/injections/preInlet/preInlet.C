/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "preInlet.H"
#include "foamCompat.H"
#include "ListOps.H"

namespace Foam
{
namespace clumpInjections
{
    defineTypeNameAndDebug(preInlet, 0);
    addToRunTimeSelectionTable(injection, preInlet, dictionary);
}
}


namespace
{

//- Radius of the smallest sphere [m]
Foam::scalar smallestRadius(const Foam::PtrList<Foam::clumpType>& types)
{
    Foam::scalar r = Foam::GREAT;
    for (const Foam::clumpType& type : types)
    {
        r = Foam::min(r, Foam::min(type.radii()));
    }
    return r;
}

//- Overlap with the ends of the stretch at the start, in radii, that a packing may
//  have left
const Foam::scalar slack = 0.05;

}


Foam::clumpInjections::preInlet::preInlet
(
    const dictionary& dict,
    const site& s
)
:
    injection(dict, s),
    patches_(openPatches("patches")),
    length_(getPositive(dict, "length")),
    gap_
    (
       -getNonNegativeOrDefault(dict, "maxOverlap", 0.1)
       *smallestRadius(s.types)
    ),
    normal_(Zero),
    centre_(Zero),
    radius_(0),
    nWaiting_(0),
    nLost_(0)
{
    checkEntries(dict, {"type", "patches", "length", "maxOverlap"});
    if (patches_.size() != 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'patches' must name one patch." << exit(FatalIOError);
    }

    box_ = patchLines(s.mesh, patches_).box();
    boundBox box(box_);
    centre_ = box.midpoint();
    radius_ = 0.5*box.mag();
    findPlane();
    box.add(box.min() + length_*normal_);
    box.add(box.max() + length_*normal_);
    places_.reset
    (
        new freePlaces
        (
            s.mesh, s.ghosts, s.types, labelHashSet(), around(box), gap_
        )
    );
}


void Foam::clumpInjections::preInlet::findPlane()
{
    const polyPatch& pp =
        site_.mesh.boundaryMesh()[patches_.sortedToc()[0]];
    normal_ = -gSum(pp.faceAreas());
    normal_.normalise();

    scalar farthest = 0;
    for (const point& x : pp.localPoints())
    {
        farthest = max(farthest, mag((x - centre_) & normal_));
    }
    if (returnReduce(farthest, maxOp<scalar>()) > 1e-3*radius_)
    {
        FatalIOErrorInFunction(dict_)
            << "Patch " << pp.name() << " is not plane, as a stretch that is"
            << " repeated needs it." << exit(FatalIOError);
    }
}


Foam::Pair<Foam::scalar> Foam::clumpInjections::preInlet::distances
(
    const clumpParcel& p
) const
{
    const scalarField d((p.centres() - centre_) & normal_);
    const scalarField& r = site_.types[p.typeId()].radii();
    return Pair<scalar>(min(d - r), max(d + r));
}


void Foam::clumpInjections::preInlet::begin
(
    const Cloud<clumpParcel>& clumps
)
{
    for (const clumpParcel& p : clumps)
    {
        const clumpType& type = site_.types[p.typeId()];
        const scalar small = slack*max(type.radii());
        const Pair<scalar> d(distances(p));
        const vector x(p.position() - centre_);
        if
        (
            !type.fixed()
         && d.first() > -small && d.second() < length_ + small
         && mag(x - (x & normal_)*normal_) < radius_
        )
        {
            members_.insert(p.origId());
        }
    }
    reduceWhole(members_, plusEqOp<labelHashSet>());
    if (members_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "No clump lies whole within the stretch of length " << length_
            << " behind the patch. Place clumps there with the entry placement,"
            << " type random, min and max." << exit(FatalIOError);
    }
    Info<< "Injection " << name() << ": the stretch has " << members_.size()
        << " clumps" << endl;
}


Foam::scalar Foam::clumpInjections::preInlet::shift
(
    const clumpParcel& p,
    const scalar d
) const
{
    // In the step in which it leaves the stretch it is no farther than it has moved
    const scalar moved =
        max(p.state().u & normal_)*site_.mesh.time().deltaTValue();
    return d - length_ > 2*moved ? d : length_;
}


Foam::List<Foam::clumpCandidate> Foam::clumpInjections::preInlet::leaving
(
    const Cloud<clumpParcel>& clumps
) const
{
    List<clumpCandidate> result;
    for (const clumpParcel& p : clumps)
    {
        const scalar d = distances(p).first();
        if (members_.found(p.origId()) && d >= length_)
        {
            clumpCandidate c;
            c.typeId = p.typeId();
            c.position = p.position() - shift(p, d)*normal_;
            c.state = p.state();
            c.index = p.origId();
            c.couplingFactor = p.couplingFactor();
            c.patchi = patches_.sortedToc()[0];
            result.append(c);
        }
    }
    gatherByIndex(result);
    return result;
}


void Foam::clumpInjections::preInlet::inject
(
    Cloud<clumpParcel>& clumps,
    const clumpCount&,
    const putAction& action
)
{
    nWaiting_ = 0;
    List<clumpCandidate> candidates(leaving(clumps));
    if (candidates.size())
    {
        const labelList owners(places_->find(candidates, clumps, true));
        forAll(owners, k)
        {
            if (owners[k] >= 0)
            {
                members_.erase(candidates[k].index);
                members_.insert(put(candidates[k], owners[k], action));
            }
            else
            {
                ++nWaiting_;
            }
        }
    }
    countLost(clumps);
}


void Foam::clumpInjections::preInlet::meshChanged()
{
    places_->clear();
    refuseMotion(box_, patchLines(site_.mesh, patches_).box());
}


void Foam::clumpInjections::preInlet::countLost
(
    const Cloud<clumpParcel>& clumps
)
{
    label nThere = 0;
    for (const clumpParcel& p : clumps)
    {
        nThere += members_.found(p.origId());
    }
    const label nLost = members_.size() - returnReduce(nThere, sumOp<label>());
    if (nLost != nLost_)
    {
        Info<< "Injection " << name() << ": " << nLost << " of "
            << members_.size() << " clumps of the stretch left the domain before"
            << " they could be copied" << endl;
        nLost_ = nLost;
    }
}


void Foam::clumpInjections::preInlet::readState(const dictionary& state)
{
    injection::readState(state);
    members_.clear();
    members_.insert(storedLabels(state, "stretch"));
    nLost_ = state.get<label>("lost");
}


void Foam::clumpInjections::preInlet::writeState(dictionary& state) const
{
    injection::writeState(state);
    setExact(state, "stretch", members_.sortedToc());
    state.set("lost", nLost_);
}
