/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "ghostExchange.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "foamCompat.H"
#include "processorCyclicPolyPatch.H"
#include "IPstream.H"
#include "sentMessages.H"
#include "HashTable.H"
#include "symmetryPlanes.H"

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
    if (type == "wedge")
    {
        return "A clump off the axis would be a torus in the flow of a wedge: mesh the"
            " full circle.";
    }
    if (type == "cyclic" || type == "cyclicAMI")
    {
        return "Mesh the full circle.";
    }
    return "Make the faces of both sides match and use a pair of type cyclic.";
}


//- Whether clumps pass a patch of this class, unless it turns them
bool isPeriodic(const polyPatch& pp)
{
    return isA<cyclicPolyPatch>(pp) || isType<cyclicAMIPolyPatch>(pp);
}


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
        else if (isA<cyclicAMIPolyPatch>(pp))
        {
            const auto& cpp = refCast<const cyclicAMIPolyPatch>(pp);
            name = cpp.owner() ? cpp.name() : cpp.neighbPatch().name();
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


//- The different separations of the periodic patches, on all processors
DynamicList<vector> periodsOf(const polyBoundaryMesh& patches)
{
    HashTable<vector> separations(separationsOf(patches));
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
    return different;
}


//- What an image has of a value of its original
void moveTo(const imageTransform& image, nodeWeights& weights)
{
    weights.moveTo(image);
}


void moveTo(const imageTransform& image, vectorField& vectors)
{
    image.polars(vectors);
}


void moveTo(const imageTransform&, scalar&)
{}


//- What an original has of the sums of an image
template<class Sums>
void bringBack(const imageTransform& from, Sums& sums)
{
    sums.bringBack(from);
}


void bringBack(const imageTransform& from, vectorField& vectors)
{
    from.polars(vectors);
}


void bringBack(const imageTransform&, vector2D&)
{}


void bringBack(const imageTransform&, scalar&)
{}

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
            if (split || isPeriodic(pp))
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
            isPeriodic(patches[patchi])
          ? !rotates[patchi]
          : !polyPatch::constraintType(type)
         || symmetryPlanes::isOne(patches[patchi]);

        if (faces[patchi] && !supported)
        {
            FatalErrorInFunction
                << "Patch " << patches[patchi].name() << " of "
                << patches.objectPath() << " is of type " << type
                << (rotates[patchi] ? " (rotational)" : "")
                << ". Clumps cannot have images behind such a patch; supported"
                << " types are wall, patch, translational cyclic and cyclicAMI,"
                << " symmetryPlane and symmetry." << nl
                << "    " << insteadOf(type) << exit(FatalError);
        }
    }

    const string fault(symmetryPlanes(patches).fault(periodsOf(patches)));
    if (fault.size())
    {
        FatalErrorInFunction
            << fault.c_str() << " Boundary: " << patches.objectPath() << '.' << nl
            << "    Mesh both sides of the plane." << exit(FatalError);
    }
}


void Foam::ghostExchange::checkMatching
(
    const polyBoundaryMesh& patches,
    const char* what,
    const dictionary& dict
)
{
    for (const polyPatch& pp : patches)
    {
        if (isA<cyclicAMIPolyPatch>(pp) && returnReduce(pp.size(), sumOp<label>()))
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << pp.name() << " of " << patches.objectPath()
                << " is of type " << pp.type() << ", across which " << what
                << " cannot be computed." << nl << "    Make the faces of both sides"
                << " match and use a pair of type cyclic." << exit(FatalIOError);
        }
    }
}


const Foam::polyMesh& Foam::ghostExchange::checkProcessors(const polyMesh& mesh)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<cyclicAMIPolyPatch>(pp))
        {
            continue;
        }
        const auto& half = refCast<const cyclicAMIPolyPatch>(pp);
        if (half.owner() && half.AMI().singlePatchProc() == -1)
        {
            FatalErrorInFunction
                << "Faces of the patches " << half.name() << " and "
                << half.neighbPatchName() << " (" << half.type() << ") are on several"
                << " processors, across which OpenFOAM follows no particle." << nl
                << "    Decompose the case with a face set of both patches (topoSet,"
                << " patchToFace) and this entry in system/decomposeParDict:" << nl
                << "    constraints { joint { type singleProcessorFaceSets; sets ((joint"
                << " -1)); } }" << exit(FatalError);
        }
    }
    return mesh;
}


Foam::ghostExchange::ghostExchange(const polyMesh& mesh, const bool mirrors)
:
    mesh_(mesh),
    mirrors_(mirrors),
    procBoxes_(Pstream::nProcs(), boundBox(point::zero, point::zero)),
    reaches_(Pstream::nProcs(), Zero),
    partnerDistance_(-1),
    nSearches_(0),
    nOwn_(0)
{
    findBoxes();
    findShifts();
}


bool Foam::ghostExchange::findBoxes()
{
    const List<boundBox> before(procBoxes_);
    procBoxes_[Pstream::myProcNo()] = boundBox(mesh_.points(), false);
    gatherToAll(procBoxes_);

    bool same = true;
    forAll(before, proci)
    {
        same =
            same
         && before[proci].min() == procBoxes_[proci].min()
         && before[proci].max() == procBoxes_[proci].max();
    }
    return !same;
}


void Foam::ghostExchange::meshChanged()
{
    // The neighbours are found anew with the next clumps
    boxesMoved_ = findBoxes() || boxesMoved_;
    findShifts();
    partnerDistance_ = -1;
}


const Foam::boundBox& Foam::ghostExchange::localBox() const
{
    return procBoxes_[Pstream::myProcNo()];
}


bool Foam::ghostExchange::reachesOwnImage() const
{
    if (transforms_.size() > shifts_.size())
    {
        return true;
    }
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


void Foam::ghostExchange::findShifts()
{
    const DynamicList<vector> different(periodsOf(mesh_.boundaryMesh()));
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
    transforms_.clear();
    for (const vector& shift : shifts_)
    {
        imageTransform t;
        t.shift = shift;
        transforms_.append(t);
    }
    if (mirrors_)
    {
        transforms_.append
        (
            symmetryPlanes(mesh_.boundaryMesh()).transforms(shifts_)
        );
    }
}


const Foam::imageTransform& Foam::ghostExchange::inverse(const label s) const
{
    // A reflection is its own inverse, a shift that of the opposite sign
    const label nShifts = shifts_.size();
    label opposite = 0;
    forAll(shifts_, k)
    {
        opposite = shifts_[k] == -shifts_[s % nShifts] ? k : opposite;
    }
    return transforms_[s - s % nShifts + opposite];
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
        const scalar width = 2*margin(proci);
        const boundBox mine(grown(localBox(), width));
        const boundBox other(grown(procBoxes_[proci], width));
        for (const imageTransform& t : transforms_)
        {
            // Boxes do not turn with an oblique plane: both processors must find both
            if
            (
                mine.overlaps(t.box(procBoxes_[proci]))
             || (t.mirrors() && other.overlaps(t.box(localBox())))
            )
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
        forAll(transforms_, s)
        {
            const imageTransform& t = me <= proci ? transforms_[s] : inverse(s);
            if (t.box(procBoxes_[min(me, proci)]).overlaps(standing))
            {
                near.append(s);
            }
        }
        if (near.size())
        {
            found.transforms = near;
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

    forAll(transforms_, s)
    {
        const imageTransform& t = transforms_[s];
        if (proci == Pstream::myProcNo() && s == 0)
        {
            continue;
        }
        const boundBox box(t.box(images_[i].box));
        if (box.overlaps(reachable))
        {
            // The clump itself may move with this list
            images.setSize(images.size() + 1);
            clumpImage& image = images.last();
            image = images_[i];
            image.original = false;
            image.transform = t;
            t.positions(image.x);
            t.polars(image.u);
            t.axials(image.omega);
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
    if (returnReduce(larger, orOp<bool>()) || boxesMoved_)
    {
        boxesMoved_ = false;
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
            image.transform.polars(image.u);
            image.transform.axials(image.omega);
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
                image.transform.polars(image.u);
                image.transform.axials(image.omega);
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
            moveTo(images_[i].transform, images_[i].*value);
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
                moveTo(image.transform, image.*value);
            }
        }
    }
}


template<class Sums>
void Foam::ghostExchange::returnSums(Sums clumpImage::* sums)
{
    const label me = Pstream::myProcNo();
    sentMessages messages(neighbours_.size());
    for (label i = nOwn_; i < images_.size(); ++i)
    {
        if (images_[i].transform.mirrors())
        {
            bringBack(images_[i].transform, images_[i].*sums);
        }
    }

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
