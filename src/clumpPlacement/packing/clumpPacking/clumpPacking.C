/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpPacking.H"
#include "bondFrame.H"
#include "clockTime.H"
#include "endSignal.H"
#include "foamCompat.H"
#include "surfaceSpacing.H"
#include "sphereGrid.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- Clearance beyond the least gap, relative to the sum of the radii
const scalar clearance = 0.02;

//- Largest displacement in a step, in radii of the smallest sphere
const scalar maxStep = 0.1;

//- Deepest overlap with which the clumps grow on, in radii
const scalar growOverlap = 0.05;

//- Steps without growth after which the clumps do not fit
const label patience = 2000;

//- Steps for a tenth of the distance that is wanted between membranes
const label patienceApart = 100;

}


//- Lines of progress, and the end of a run that received a signal
class Foam::clumpPacking::progress
{
    clockTime clock_;
    scalar said_ = 0;

public:

    //- After a step, the membranes so far apart [m]: one line in two seconds
    void say
    (
        const label step,
        const scalar size,
        const scalar apart,
        const scalar deepest,
        const label since
    )
    {
        const label signal = returnReduce(endSignal::received(), maxOp<label>());
        if (signal)
        {
            Info<< "--> Signal " << signal << " received: the clumps are not packed, and"
                << " nothing is written" << nl << endl;
            UPstream::exit(128 + signal);
        }
        if (clock_.elapsedTime() > said_ + 2)
        {
            said_ = clock_.elapsedTime();
            Info<< "    step " << step << ": ";
            if (apart > 0)
            {
                Info<< "membranes " << apart << " m apart";
            }
            else
            {
                Info<< 0.1*round(1000*size) << " % of the size";
            }
            Info<< ", deepest overlap " << 0.01*round(100*deepest) << " radii";
            if (since > 200)
            {
                Info<< ", no growth in " << since << " steps (the end: "
                    << patience << ')';
            }
            Info<< ", " << label(said_) << " s" << endl;
        }
    }
};


Foam::clumpPacking::clumpPacking
(
    packingRegion& region,
    const PtrList<clumpType>& types,
    Cloud<clumpParcel>& clumps,
    const scalar gap,
    const bool turns
)
:
    region_(region),
    types_(types),
    clumps_(clumps),
    nClumps_(returnReduce(clumps.size(), sumOp<label>())),
    gap_(gap),
    apart_(0),
    turns_(turns),
    bodies_(types.size()),
    scale_(1),
    ghosts_(region.mesh(), false),
    nSteps_(0)
{}


void Foam::clumpPacking::setBodies(const bool whole)
{
    forAll(types_, i)
    {
        const clumpType& type = types_[i];
        const bool membrane = type.hasTriangles();
        bodies_.set(i, new body);
        body& b = bodies_[i];
        b.x = whole ? pointField(1, Zero) : type.centres();
        b.r = whole ? scalarField(1, type.reach()) : type.radii();
        b.size = membrane ? 0.5*type.halfWidth() : min(type.radii());
        b.box = boundBox(type.centres(), false);
        if (membrane && !whole)
        {
            b.r = Zero;
            b.surface.reset(new surfaceDistance(type.surface(), type.centres()));
        }
    }
}


Foam::scalar Foam::clumpPacking::startScale() const
{
    scalar sum = 0;
    for (const clumpParcel& p : clumps_)
    {
        sum += pow3(types_[p.typeId()].reach());
    }
    reduce(sum, sumOp<scalar>());
    const scalar filled = constant::mathematical::pi*4/3*sum/region_.volume();
    return min(scalar(1), Foam::cbrt(0.2/filled));
}


void Foam::clumpPacking::setImages()
{
    UList<clumpImage>& images = ghosts_.own(clumps_.size());
    label index = 0;
    for (const clumpParcel& p : clumps_)
    {
        const body& b = bodies_[p.typeId()];
        const point centre(p.position() + p.state().x[0]);
        const tensor R(p.state().q[0].R());

        clumpImage& image = images[index];
        image.owner = Pstream::myProcNo();
        image.index = index;
        image.original = true;
        image.typeId = p.typeId();
        image.transform = imageTransform();
        image.x.setSize(b.x.size());
        image.u.setSize(1);
        image.u[0] = centre;
        image.omega.clear();
        if (b.surface.valid())
        {
            image.omega = vectorField({R.x(), R.y(), R.z()});
        }
        image.box = boundBox::invertedBox;
        forAll(b.x, i)
        {
            image.x[i] = centre + scale_*(R & b.x[i]);
            const scalar r =
                0.5*(gap_ + apart_)
              + (
                    b.surface.valid()
                  ? clearance*scale_*b.size : (1 + clearance)*scale_*b.r[i]
                );
            image.box.add(image.x[i] - r*vector::one);
            image.box.add(image.x[i] + r*vector::one);
        }
        image.reach = max
        (
            cmptMax(image.box.max() - p.position()),
            cmptMax(p.position() - image.box.min())
        );
        ++index;
    }
    const label before = ghosts_.neighbourhood();
    ghosts_.update();
    if (ghosts_.neighbourhood() != before)
    {
        region_.update(ghosts_);
    }
}


void Foam::clumpPacking::addClumps()
{
    const auto& images = ghosts_.images();
    sphereGrid::forEachNear
    (
        images, ghosts_.nOwn(), scalarField(ghosts_.nOwn(), Zero),
        [&](const label a, const label b)
        {
            const bool surfaceA = bodies_[images[a].typeId].surface.valid();
            const bool surfaceB = bodies_[images[b].typeId].surface.valid();
            if (surfaceA)
            {
                addToSurface(images[b], images[a], false, contacts_[a]);
            }
            if (surfaceB)
            {
                addToSurface(images[a], images[b], true, contacts_[a]);
            }
            if (!surfaceA && !surfaceB)
            {
                addSpheres(images[a], images[b], contacts_[a]);
            }
        }
    );
}


void Foam::clumpPacking::addSpheres
(
    const clumpImage& A,
    const clumpImage& B,
    contacts& sum
) const
{
    const body& bodyA = bodies_[A.typeId];
    const body& bodyB = bodies_[B.typeId];
    const point& centre = A.u[0];
    const scalar reach = types_[A.typeId].reach();

    forAll(A.x, i)
    {
        forAll(B.x, j)
        {
            const scalar rSum = scale_*(bodyA.r[i] + bodyB.r[j]);
            const scalar target = (1 + clearance)*rSum + gap_;
            const vector d(A.x[i] - B.x[j]);
            if (magSqr(d) >= sqr(target))
            {
                continue;
            }
            const scalar distance = mag(d);
            const vector n
            (
                distance > SMALL*rSum ? d/distance : vector(1, 0, 0)
            );
            const scalar smaller = scale_*min(bodyA.r[i], bodyB.r[j]);
            sum.deepest = max(sum.deepest, (rSum + gap_ - distance)/smaller);
            sum.add(n, A.x[i] - centre, reach, target - distance, 2);
        }
    }
}


void Foam::clumpPacking::addToSurface
(
    const clumpImage& points,
    const clumpImage& membrane,
    const bool ofPoints,
    contacts& sum
) const
{
    const body& P = bodies_[points.typeId];
    const body& M = bodies_[membrane.typeId];
    const scalar size = scale_*min(P.size, M.size);
    const scalar least = gap_ + apart_;
    const scalar gap = least + clearance*scale_*(P.size + M.size);

    // In the frame of the membrane at rest, those that are near
    const tensor R(membrane.omega[0], membrane.omega[1], membrane.omega[2]);
    const scalar most = max(P.r) + gap/scale_;
    const boundBox reach(grown(M.box, most));
    DynamicList<label> near;
    DynamicList<point> local;
    forAll(points.x, i)
    {
        const point x((R.T() & (points.x[i] - membrane.u[0]))/scale_);
        if (reach.contains(x))
        {
            near.append(i);
            local.append(x);
        }
    }
    if (near.empty())
    {
        return;
    }

    // Deep inside, too
    const auto places = M.surface->nearest
    (
        pointField(local), max(most, types_[membrane.typeId].halfWidth())
    );
    const clumpImage& mine = ofPoints ? points : membrane;
    forAll(near, k)
    {
        const auto& p = places[k];
        const scalar r = scale_*P.r[near[k]];
        const scalar depth = r + gap - scale_*p.distance;
        if (p.found && depth > 0)
        {
            const vector n((ofPoints ? 1 : -1)*(R & p.outwards));
            sum.deepest =
                max(sum.deepest, (r + least - scale_*p.distance)/size);
            sum.add
            (
                n, points.x[near[k]] - mine.u[0],
                types_[mine.typeId].reach(), depth, 2
            );
        }
    }
}


void Foam::clumpPacking::addSurface()
{
    const auto& images = ghosts_.images();
    for (label a = 0; a < ghosts_.nOwn(); ++a)
    {
        const clumpImage& A = images[a];
        const body& bodyA = bodies_[A.typeId];
        const point& centre = A.u[0];
        const scalar reach = types_[A.typeId].reach();

        bool near = false;
        region_.forEachSurface
        (
            centre, 1.05*scale_*reach + gap_ + apart_,
            [&](const scalar, const vector&) { near = true; }
        );
        if (!near)
        {
            continue;
        }
        forAll(A.x, i)
        {
            const bool membrane = bodyA.surface.valid();
            const scalar r = scale_*bodyA.r[i];
            const scalar size = membrane ? scale_*bodyA.size : r;
            const scalar least = gap_ + (membrane ? apart_ : scalar(0));
            const scalar target =
                (membrane ? clearance*size : (1 + clearance)*r) + least;
            region_.forEachSurface
            (
                A.x[i], 2*(membrane ? size + target : target),
                [&](const scalar height, const vector& away)
                {
                    if (height < target)
                    {
                        contacts_[a].deepest = max
                        (
                            contacts_[a].deepest, (r + least - height)/size
                        );
                        contacts_[a].add
                        (
                            away, A.x[i] - centre, reach, target - height, 1
                        );
                    }
                }
            );
        }
    }
}


void Foam::clumpPacking::move(clumpParcel& p, const contacts& sum)
{
    const clumpType& type = types_[p.typeId()];
    clumpState& s = p.state();

    vector6 y = vector6::Zero();
    if (sum.g.squaredNorm() > 0)
    {
        matrix6 H = sum.H;
        H.diagonal().array() += 0.02*H.trace()/6;
        y = H.selfadjointView<Eigen::Lower>().ldlt().solve(sum.g);
    }

    // The last step goes on while it points the same way
    vector6 last;
    last << s.u[0].x(), s.u[0].y(), s.u[0].z(),
        s.w[0].x(), s.w[0].y(), s.w[0].z();
    if (last.dot(y) > 0)
    {
        y += 0.8*last;
    }
    if (!turns_)
    {
        y.tail<3>().setZero();
    }
    const scalar size = y.head<3>().norm() + y.tail<3>().norm();
    const scalar limit = maxStep*scale_*bodies_[p.typeId()].size;
    if (size > limit)
    {
        y *= limit/size;
    }
    s.u[0] = vector(y[0], y[1], y[2]);
    s.w[0] = vector(y[3], y[4], y[5]);
    s.q[0] = rotation(s.w[0]/type.reach())*s.q[0];
    normalise(s.q[0]);
    s.x += s.u[0];
}


void Foam::clumpPacking::track()
{
    for (clumpParcel& p : clumps_)
    {
        p.recentre(types_[p.typeId()]);
    }
    clumpParcel::trackingData td(clumps_);
    clumps_.move(clumps_, td, 1);
}


Foam::scalar Foam::clumpPacking::findContacts()
{
    setImages();
    contacts_.setSize(clumps_.size());
    contacts_ = contacts();
    addClumps();
    addSurface();

    scalar deepest = 0;
    for (const contacts& c : contacts_)
    {
        deepest = max(deepest, c.deepest);
    }
    return returnReduce(deepest, maxOp<scalar>());
}


void Foam::clumpPacking::moveAll()
{
    label index = 0;
    for (clumpParcel& p : clumps_)
    {
        move(p, contacts_[index++]);
    }
    if (++nSteps_ % 5 == 0)
    {
        track();
    }
}


bool Foam::clumpPacking::settle
(
    const scalar maxOverlap,
    const label most,
    progress& told
)
{
    for (label n = 0; n < most; ++n)
    {
        const scalar deepest = findContacts();
        if (deepest <= maxOverlap)
        {
            return true;
        }
        moveAll();
        told.say(nSteps_, 1, apart_, deepest, n);
    }
    return false;
}


Foam::scalar Foam::clumpPacking::setApart
(
    const scalar wanted,
    const scalar maxOverlap,
    progress& told
)
{
    // In tenths
    const auto settleAt = [&](const label n, const label most)
    {
        apart_ = 0.1*n*(wanted - gap_);
        return settle(maxOverlap, most, told);
    };
    label n = 0;
    while (n < 10 && settleAt(n + 1, patienceApart))
    {
        ++n;
    }
    while (!settleAt(n, patience) && n > 0)
    {
        --n;
    }
    Info<< "Membranes are " << gap_ + apart_ << " m apart; their contact begins at "
        << wanted << " m" << endl;
    apart_ = 0;
    return findContacts();
}


Foam::scalar Foam::clumpPacking::pack
(
    const scalar maxOverlap,
    scalar& deepest
)
{
    // The first sphere of each clump alone counts here
    for (clumpParcel& p : clumps_)
    {
        p.state().x = Zero;
        p.state().u = Zero;
        p.state().w = Zero;
    }

    setBodies(true);
    scale_ = startScale();
    progress told;
    while (nSteps_ < 300 && (deepest = findContacts()) > growOverlap)
    {
        moveAll();
        told.say(nSteps_, scale_, 0, deepest, 0);
    }

    setBodies(false);
    scalar reached = 0;
    label sinceGrowth = 0;
    while (reached < 1 && ++sinceGrowth < patience)
    {
        deepest = findContacts();
        if (deepest <= (scale_ < 1 ? growOverlap : maxOverlap))
        {
            reached = scale_;
            scale_ = min(scalar(1), scale_ + 0.003);
            sinceGrowth = 0;
        }
        if (reached < 1)
        {
            moveAll();
        }
        told.say(nSteps_, scale_, 0, deepest, sinceGrowth);
    }

    const scalar width = surfaceSpacing::narrowest(clumps_, types_);
    const scalar range = surfaceSpacing::byDefault*width;
    if (reached == 1 && width < GREAT && range > gap_)
    {
        deepest = setApart(range, maxOverlap, told);
    }
    finish();
    return reached;
}


void Foam::clumpPacking::finish()
{
    track();
    for (clumpParcel& p : clumps_)
    {
        const vector offset(p.state().x[0]);
        p.state() = clumpState(types_[p.typeId()], p.state().q[0]);
        p.state().x += offset;
    }
    const label n = returnReduce(clumps_.size(), sumOp<label>());
    if (n != nClumps_)
    {
        FatalErrorInFunction
            << nClumps_ - n << " of " << nClumps_ << " clumps left the mesh"
            << " while they were packed." << exit(FatalError);
    }
}
