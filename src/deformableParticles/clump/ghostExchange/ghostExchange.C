/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "ghostExchange.H"
#include "cyclicPolyPatch.H"
#include "foamCompat.H"
#include "processorCyclicPolyPatch.H"
#include "IPstream.H"
#include "sentMessages.H"
#include "HashTable.H"

namespace
{

using namespace Foam;

//- What to use in place of a type that clumps do not support
const char* insteadOf(const word& type)
{
    if (type == "empty")
    {
        return "The flow around clumps has three dimensions: use a pair of type"
            " cyclic.";
    }
    if (type == "wedge" || type == "cyclic")
    {
        return "Mesh the full circle.";
    }
    if (!type.compare(0, 8, "symmetry"))
    {
        return "Mesh both sides of the plane.";
    }
    return "Make the faces of both sides match and use a pair of type cyclic.";
}

}


void Foam::ghostExchange::checkPatches(const polyBoundaryMesh& patches)
{
    const label n = patches.nNonProcessor();
    labelList faces(n, Zero);
    labelList rotates(n, Zero);

    for (const polyPatch& pp : patches)
    {
        // A processor that has no faces of a cyclic may have some that meet
        // the other side of it on another processor
        const bool split = isA<processorCyclicPolyPatch>(pp);
        const label patchi =
            split
          ? refCast<const processorCyclicPolyPatch>(pp).referPatchID()
          : pp.index();

        if (patchi < n && pp.size())
        {
            faces[patchi] += pp.size();
            if (split || isA<cyclicPolyPatch>(pp))
            {
                const auto& cpp = refCast<const coupledPolyPatch>(pp);
                rotates[patchi] += cpp.parallel() ? 0 : 1;
            }
        }
    }
    reduceList(faces, plusEqOp<label>());
    reduceList(rotates, plusEqOp<label>());

    for (label patchi = 0; patchi < n; ++patchi)
    {
        const word& type = patches[patchi].type();
        const bool supported =
            isA<cyclicPolyPatch>(patches[patchi])
          ? !rotates[patchi]
          : !polyPatch::constraintType(type);

        if (faces[patchi] && !supported)
        {
            FatalErrorInFunction
                << "Patch " << patches[patchi].name() << " of "
                << patches.objectPath() << " is of type " << type
                << (rotates[patchi] ? " (rotational)" : "")
                << ". Clumps cannot have images behind such a patch; supported"
                << " types are wall, patch and translational cyclic." << nl
                << "    " << insteadOf(type) << exit(FatalError);
        }
    }
}


Foam::ghostExchange::ghostExchange(const polyMesh& mesh)
:
    mesh_(mesh),
    procBoxes_(Pstream::nProcs()),
    reaches_(Pstream::nProcs(), Zero),
    partnerDistance_(-1),
    nSearches_(0),
    nOwn_(0)
{
    procBoxes_[Pstream::myProcNo()] = boundBox(mesh_.points(), false);
    gatherToAll(procBoxes_);

    findShifts();
}


const Foam::boundBox& Foam::ghostExchange::localBox() const
{
    return procBoxes_[Pstream::myProcNo()];
}


bool Foam::ghostExchange::reachesOwnImage() const
{
    const scalar largest = max(reaches_);
    for (label s = 1; s < shifts_.size(); ++s)
    {
        if (mag(shifts_[s]) < 2*largest)
        {
            return true;
        }
    }
    return false;
}


namespace
{

using namespace Foam;

//- Separation of every pair of cyclic patches of which this processor has faces
HashTable<vector> separationsOf(const polyBoundaryMesh& patches)
{
    HashTable<vector> separations;
    for (const polyPatch& pp : patches)
    {
        if (!isA<coupledPolyPatch>(pp) || pp.empty())
        {
            continue;
        }

        word name;
        if (isA<cyclicPolyPatch>(pp))
        {
            const auto& cpp = refCast<const cyclicPolyPatch>(pp);
            name = cpp.owner() ? cpp.name() : cpp.neighbPatch().name();
        }
        else if (isA<processorCyclicPolyPatch>(pp))
        {
            const auto& cpp =
                refCast<const processorCyclicPolyPatch>(pp).referPatch();
            const auto& cyc = refCast<const cyclicPolyPatch>(cpp);
            name = cyc.owner() ? cyc.name() : cyc.neighbPatch().name();
        }
        else
        {
            continue;
        }

        const auto& cpp = refCast<const coupledPolyPatch>(pp);
        if (cpp.separated() && !separations.found(name))
        {
            // One sign for both sides
            vector s(cpp.separation()[0]);
            if (s.x() + Foam::sqrt(2.0)*s.y() + Foam::sqrt(3.0)*s.z() < 0)
            {
                s = -s;
            }
            separations.insert(name, s);
        }
    }
    return separations;
}

}


void Foam::ghostExchange::findShifts()
{
    HashTable<vector> separations(separationsOf(mesh_.boundaryMesh()));
    const auto keepOne = [](const vector& a, const vector&) { return a; };
    reduceMap
    (
        separations,
        [&](vector& a, const vector& b) { a = keepOne(a, b); }
    );

    // A periodic end may consist of several pairs, with one separation
    DynamicList<vector> different;
    for (const word& name : separations.sortedToc())
    {
        const vector& s = separations[name];
        bool fresh = true;
        for (const vector& other : different)
        {
            fresh = fresh && mag(s - other) > 1e-6*mag(s);
        }
        if (fresh)
        {
            different.append(s);
        }
    }

    shifts_ = List<vector>(1, vector::zero);
    for (const vector& separation : different)
    {
        const List<vector> before(shifts_);
        for (const scalar sign : {1.0, -1.0})
        {
            for (const vector& s : before)
            {
                shifts_.append(s + sign*separation);
            }
        }
    }
}


void Foam::ghostExchange::findNeighbours(const scalar reach)
{
    const label me = Pstream::myProcNo();
    const bool first = max(reaches_) <= 0;

    // Widened, so that this need not be repeated when a clump stretches
    reaches_[me] = max(reaches_[me], 1.5*reach);
    gatherToAll(reaches_);
    if (first)
    {
        checkPatches(mesh_.boundaryMesh());
    }
    neighbours_.clear();
    ++nSearches_;

    forAll(procBoxes_, proci)
    {
        if (proci == me)
        {
            continue;
        }
        const boundBox mine(grown(localBox(), 2*margin(proci)));
        for (const vector& shift : shifts_)
        {
            boundBox other(procBoxes_[proci]);
            other.min() += shift;
            other.max() += shift;

            if (mine.overlaps(other))
            {
                neighbours_.append(proci);
                break;
            }
        }
    }
}


const Foam::UList<Foam::ghostExchange::partner>&
Foam::ghostExchange::partners(const scalar distance) const
{
    if (partnerDistance_ == distance)
    {
        return partners_;
    }
    partnerDistance_ = distance;

    // Both of two partners compare the same numbers
    const label me = Pstream::myProcNo();
    DynamicList<partner> result;
    forAll(procBoxes_, proci)
    {
        const boundBox standing(grown(procBoxes_[max(me, proci)], 7*distance/6));
        partner found{proci, labelList()};
        DynamicList<label> near;
        forAll(shifts_, s)
        {
            const vector shift(me <= proci ? shifts_[s] : -shifts_[s]);
            boundBox moved(procBoxes_[min(me, proci)]);
            moved.min() += shift;
            moved.max() += shift;
            if (moved.overlaps(standing))
            {
                near.append(s);
            }
        }
        if (near.size())
        {
            found.shifts = near;
            result.append(found);
        }
    }
    partners_ = result;
    return partners_;
}


void Foam::ghostExchange::appendImages
(
    const label i,
    const label proci,
    DynamicList<clumpImage>& images
) const
{
    const boundBox reachable(grown(procBoxes_[proci], margin(proci)));

    for (const vector& shift : shifts_)
    {
        if (proci == Pstream::myProcNo() && shift == vector::zero)
        {
            continue;
        }

        boundBox box(images_[i].box);
        box.min() += shift;
        box.max() += shift;

        if (box.overlaps(reachable))
        {
            // The clump itself may move with this list
            images.setSize(images.size() + 1);
            clumpImage& image = images.last();
            image = images_[i];
            image.original = false;
            image.shift = shift;
            image.x += shift;
            image.box = box;
        }
    }
}


Foam::UList<Foam::clumpImage>& Foam::ghostExchange::own(const label n)
{
    nOwn_ = n;
    images_.setSize(n);
    return images_;
}


void Foam::ghostExchange::updateNeighbours()
{
    images_.setSize(nOwn_);

    scalar reach = 0;
    for (const clumpImage& image : images_)
    {
        reach = max(reach, image.reach + range_);
    }
    const bool larger = reach > reaches_[Pstream::myProcNo()];
    if (returnReduce(larger, orOp<bool>()))
    {
        findNeighbours(reach);
    }
}


void Foam::ghostExchange::exchange()
{
    sentMessages messages(neighbours_.size());
    sent_.setSize(neighbours_.size());
    DynamicList<clumpImage> ghosts;
    forAll(neighbours_, n)
    {
        ghosts.clear();
        for (label i = 0; i < nOwn_; ++i)
        {
            appendImages(i, neighbours_[n], ghosts);
        }

        sentMessages::stream os(messages, n, neighbours_[n]);
        os << label(ghosts.size());
        sent_[n].setSize(ghosts.size());
        forAll(ghosts, i)
        {
            os << ghosts[i];
            sent_[n][i] = ghosts[i].index;
        }
    }

    for (label i = 0; i < nOwn_; ++i)
    {
        appendImages(i, Pstream::myProcNo(), images_);
    }

    for (const label proci : neighbours_)
    {
        IPstream is(UPstream::commsTypes::blocking, proci);
        const label n = readLabel(is);
        for (label i = 0; i < n; ++i)
        {
            images_.setSize(images_.size() + 1);
            is >> images_.last();
        }
    }
}


void Foam::ghostExchange::updateVelocities()
{
    sentMessages messages(neighbours_.size());
    forAll(neighbours_, n)
    {
        sentMessages::stream os(messages, n, neighbours_[n]);
        for (const label i : sent_[n])
        {
            os  << images_[i].u << images_[i].omega << images_[i].contraction
                << token::SPACE;
        }
    }

    for (label i = nOwn_; i < images_.size(); ++i)
    {
        clumpImage& image = images_[i];
        if (image.owner == Pstream::myProcNo())
        {
            image.u = images_[image.index].u;
            image.omega = images_[image.index].omega;
            image.contraction = images_[image.index].contraction;
        }
    }

    // The images of a processor stand in the order in which it sent them
    for (const label proci : neighbours_)
    {
        IPstream is(UPstream::commsTypes::blocking, proci);
        for (clumpImage& image : images_)
        {
            if (image.owner == proci)
            {
                is >> image.u >> image.omega >> image.contraction;
            }
        }
    }
}


template<class Type>
void Foam::ghostExchange::copyToImages(Type clumpImage::* value)
{
    sentMessages messages(neighbours_.size());
    forAll(neighbours_, n)
    {
        sentMessages::stream os(messages, n, neighbours_[n]);
        for (const label i : sent_[n])
        {
            os << images_[i].*value;
        }
    }
    for (label i = nOwn_; i < images_.size(); ++i)
    {
        if (images_[i].owner == Pstream::myProcNo())
        {
            images_[i].*value = images_[images_[i].index].*value;
        }
    }
    for (const label proci : neighbours_)
    {
        IPstream is(UPstream::commsTypes::blocking, proci);
        for (clumpImage& image : images_)
        {
            if (image.owner == proci)
            {
                is >> image.*value;
            }
        }
    }
}


template<class Sums>
void Foam::ghostExchange::returnSums(Sums clumpImage::* sums)
{
    const label me = Pstream::myProcNo();
    sentMessages messages(neighbours_.size());

    forAll(neighbours_, n)
    {
        sentMessages::stream os(messages, n, neighbours_[n]);
        for (const clumpImage& image : images_)
        {
            if (image.owner == neighbours_[n])
            {
                os << image.*sums;
            }
        }
    }

    for (label i = nOwn_; i < images_.size(); ++i)
    {
        if (images_[i].owner == me)
        {
            images_[images_[i].index].*sums += images_[i].*sums;
        }
    }

    // A processor returns the images in the order in which they were sent to it
    forAll(neighbours_, n)
    {
        IPstream is(UPstream::commsTypes::blocking, neighbours_[n]);
        for (const label i : sent_[n])
        {
            Sums received;
            is >> received;
            images_[i].*sums += received;
        }
    }
}


void Foam::ghostExchange::returnForces()
{
    returnSums(&clumpImage::fluid);
}


void Foam::ghostExchange::returnConstraints()
{
    returnSums(&clumpImage::constraint);
}


void Foam::ghostExchange::returnViscosities()
{
    returnSums(&clumpImage::viscosity);
}


void Foam::ghostExchange::returnMoments()
{
    returnSums(&clumpImage::moments);
}


void Foam::ghostExchange::returnSamples()
{
    returnSums(&clumpImage::sampled);
}


void Foam::ghostExchange::updateWeights()
{
    copyToImages(&clumpImage::weights);
}


void Foam::ghostExchange::updateNodeForces()
{
    copyToImages(&clumpImage::force);
}


void Foam::ghostExchange::sumInside()
{
    returnSums(&clumpImage::inside);
    copyToImages(&clumpImage::inside);
}
