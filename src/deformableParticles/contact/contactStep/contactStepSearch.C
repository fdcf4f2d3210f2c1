/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStep.H"
#include "foamCompat.H"
#include "sphereGrid.H"
#include "wallDisplacement.H"
#include <algorithm>

void Foam::contactStep::clearCoupled()
{
    coupled_.clear();
    clumpOf_.clear();
    forces_.clear();
    torques_.clear();
    energies_.clear();
    nRenewed_.clear();
    isCoupled_ = Zero;
    hasNewCoupled_ = false;
    inPart_ = false;
}


bool Foam::contactStep::resume
(
    const scalar dt,
    const bool betweenClumps,
    const bool atWalls
)
{
    if
    (
        search_.dt != dt
     || search_.betweenClumps != betweenClumps
     || search_.atWalls != atWalls
     || search_.acrossGaps != gaps_.active()
    )
    {
        slacks_.clear();
        touched_ = false;
        return false;
    }
    if (search_.tooNarrow)
    {
        return false;
    }
    clearCoupled();
    sphereContacts_ = search_.contacts;
    begins_ = search_.begins;
    move(true);
    for (sphereContact& t : sphereContacts_)
    {
        evaluate(t);
    }
    distribute(true);
    return true;
}


void Foam::contactStep::find
(
    Cloud<clumpParcel>& clumps,
    const scalar dt,
    const bool betweenClumps
)
{
    wholeDt_ = dt;
    dt_ = dt;
    leastEigenvalue = 0;

    clumps_.setSize(clumps.size());
    label index = 0;
    for (clumpParcel& p : clumps)
    {
        clumps_.set(index++, &p);
    }
    if (slacks_.empty())
    {
        slacks_.setSize(clumps_.size());
        forAll(slacks_, a)
        {
            slacks_[a] = margin(a);
        }
    }
    clearCoupled();
    sphereContacts_.clear();
    search_.betweenClumps = betweenClumps;
    search_.atWalls = false;
    search_.acrossGaps = gaps_.active();

    setCellWidths();
    setImages(betweenClumps);
    if (betweenClumps)
    {
        findPairs();
    }
}


void Foam::contactStep::findPlanes()
{
    search_.atWalls = true;
    wallsNear_.setSize(clumps_.size());
    for (label a = 0; a < clumps_.size(); ++a)
    {
        findWalls(a);
        if (wallsNear_[a].size())
        {
            findPlanes(a);
            findFilms(a);
        }
    }
    std::stable_sort
    (
        sphereContacts_.begin(), sphereContacts_.end(),
        [](const sphereContact& s, const sphereContact& t) { return s.a < t.a; }
    );
}


void Foam::contactStep::endSearch()
{
    setLocalIndices();
    setRanges();
    setBonds();
    distribute(true);

    search_.dt = wholeDt_;
    search_.tooNarrow = false;
    search_.contacts = sphereContacts_;
    search_.begins = begins_;
}


bool Foam::contactStep::wallsMove() const
{
    return Foam::wallsMove(mesh_);
}


void Foam::contactStep::findWalls(const label a)
{
    // Around all places that the clump may reach in the step
    const clumpParcel& p = clumps_[a];
    wallsNear_[a].clear();
    if (type(a).fixed() || !type(a).ofSpheres())
    {
        return;
    }
    const scalar width =
        max(type(a).radii()) + wholeDt_*max(mag(p.state().u)) + slacks_[a]
      + gaps_.range(cellWidths_[a], true);
    wallsNear_[a] =
        walls_.surface().near(grown(boundBox(p.centres(), false), width));
}


void Foam::contactStep::setCellWidths()
{
    range_ = 0;
    cellWidths_ = scalarList(clumps_.size(), Zero);
    if (!gaps_.active())
    {
        return;
    }
    scalar widest = 0;
    for (label a = 0; a < clumps_.size(); ++a)
    {
        cellWidths_[a] = Foam::cbrt(mesh_.cellVolumes()[clumps_[a].cell()]);
        widest = max(widest, cellWidths_[a]);
    }
    range_ = gaps_.range(returnReduce(widest, maxOp<scalar>()), false);
}


void Foam::contactStep::setRanges()
{
    if (!gaps_.active())
    {
        return;
    }
    cellWidths_.setSize(remote_.nClumps());
    remote_.exchange(cellWidths_);
    for (sphereContact& t : sphereContacts_)
    {
        if (t.reaches)
        {
            const scalar own = cellWidths_[t.a];
            t.cellWidth = t.b < 0 ? own : 0.5*(own + cellWidths_[t.otherIndex]);
            t.range = gaps_.range(t.cellWidth, t.b < 0);
        }
    }
}


void Foam::contactStep::setLocalIndices()
{
    begins_ = labelList(clumps_.size() + 1, Zero);
    boolList used(ghosts_.images().size(), false);
    for (const sphereContact& t : sphereContacts_)
    {
        ++begins_[t.a + 1];
        if (t.b >= 0)
        {
            used[t.b] = true;
        }
    }
    for (label a = 0; a < clumps_.size(); ++a)
    {
        begins_[a + 1] += begins_[a];
    }

    remote_.find(ghosts_, clumps_.size(), used);
    List<labelHashSet> partners(clumps_.size());
    for (sphereContact& t : sphereContacts_)
    {
        t.otherIndex = t.b < 0 ? -1 : remote_.localIndex(t.b);
        if (t.b >= 0)
        {
            partners[t.a].insert(t.otherIndex);
        }
    }
    partners_.setSize(partners.size());
    forAll(partners_, a)
    {
        partners_[a] = partners[a].sortedToc();
    }

    isCoupled_ = labelList(remote_.nClumps(), Zero);
    moved_.clear();
    moved_.setSize(remote_.nClumps());
    for (label a = 0; a < clumps_.size(); ++a)
    {
        moved_[a] = vectorField(type(a).size(), Zero);
    }
    remote_.exchange(moved_);
    turned_ = moved_;
    hasMoved_.setSize(moved_.size());
    hasMoved_ = true;
}


void Foam::contactStep::setImages(const bool betweenClumps)
{
    UList<clumpImage>& images = ghosts_.own(betweenClumps ? clumps_.size() : 0);

    // Boxes that hold the paths
    forAll(images, a)
    {
        const clumpParcel& p = clumps_[a];
        clumpImage& image = images[a];
        image.set(p, type(a), p.state(), a);
        boundBox& box = image.box;
        forAll(image.x, i)
        {
            const point end(image.x[i] + wholeDt_*image.u[i]);
            box.add(end - type(a).radii()[i]*vector::one);
            box.add(end + type(a).radii()[i]*vector::one);
        }
        image.slack = slacks_[a];
        box = grown(box, image.slack + 0.5*range_);
        const point centre(p.position());
        image.reach = max
        (
            cmptMax(box.max() - centre), cmptMax(centre - box.min())
        );
    }
    ghosts_.update();
}


void Foam::contactStep::addPair
(
    const label a,
    const label i,
    const label b,
    const label j
)
{
    const clumpImage& A = ghosts_.images()[a];
    const clumpImage& B = ghosts_.images()[b];
    const scalar rA = types_[A.typeId].radii()[i];
    const scalarField& rB = types_[B.typeId].radii();
    const vector x(A.x[i] - B.x[j]);
    const vector dx(wholeDt_*(A.u[i] - B.u[j]));
    const scalar r = contacts_.distance(A, i, B, j);
    if (leastDistance(x, dx) >= r + range_ + A.slack + B.slack)
    {
        return;
    }
    sphereContact t = sphereContact();
    t.hasLaw = true;
    t.reaches = range_ > 0;
    t.law = &contacts_.laws()(A.typeId, B.typeId);
    t.a = a;
    t.i = i;
    t.b = b;
    t.j = j;
    t.radii = r;
    t.d = r - mag(x);
    t.first = t.d;
    t.n = mag(x) > SMALL*r ? vector(x/mag(x)) : vector::zero;
    t.R = contactModel::reduced(rA, rB[j]);
    t.gapR = t.R;
    t.m = contactModel::reduced
    (
        massAt(a, i),
        contactWeights::mass(j, B.x, rB, types_[B.typeId].masses())
    );
    sphereContacts_.append(t);
}


void Foam::contactStep::findPairs()
{
    const UList<clumpImage>& images = ghosts_.images();
    const label nOwn = ghosts_.nOwn();

    // Spheres of a clump whose paths reach into the box of another one
    DynamicList<label> spheresA, spheresB;
    const auto reaching = [&]
    (
        const clumpImage& image, const boundBox& box, DynamicList<label>& found
    )
    {
        const scalarField& r = types_[image.typeId].radii();
        found.clear();
        forAll(image.x, i)
        {
            boundBox path(image.x[i], image.x[i]);
            path.add(image.x[i] + wholeDt_*image.u[i]);
            if (grown(path, r[i] + image.slack + 0.5*range_).overlaps(box))
            {
                found.append(i);
            }
        }
    };

    sphereGrid::forEachNear
    (
        images, nOwn, scalarField(nOwn, Zero),
        [&](const label a, const label b)
        {
            const clumpImage& A = images[a];
            const clumpImage& B = images[b];
            if (!types_[A.typeId].ofSpheres() || !types_[B.typeId].ofSpheres())
            {
                return;
            }
            reaching(A, B.box, spheresA);
            reaching(B, A.box, spheresB);
            for (const label i : spheresA)
            {
                for (const label j : spheresB)
                {
                    addPair(a, i, b, j);
                }
            }
        }
    );
}


void Foam::contactStep::findPlanes(const label a)
{
    const clumpParcel& p = clumps_[a];
    const scalarField& r = type(a).radii();
    const pointField x(p.centres());

    forAll(x, i)
    {
        const vector path(wholeDt_*p.state().u[i]);
        const scalar reach = mag(path) + slacks_[a];
        for
        (
            const auto& c
          : walls_.surface().contacts(x[i], r[i] + reach, wallsNear_[a])
        )
        {
            // At the start, and as deep as it may become
            const scalar d = c.overlap - reach;
            if (d + slacks_[a] + max(-(path & c.normal), 0.0) > 0)
            {
                sphereContact t(makeWallContact(a, i, x[i], c, d));
                t.hasLaw = true;
                t.law = &walls_.laws()(p.typeId(), c.patch);
                t.weight = c.weight;
                sphereContacts_.append(t);
            }
        }
    }
}


void Foam::contactStep::findFilms(const label a)
{
    if (!gaps_.active())
    {
        return;
    }
    const clumpParcel& p = clumps_[a];
    const scalarField& r = type(a).radii();
    const pointField x(p.centres());
    const scalar range = gaps_.range(cellWidths_[a], true);
    const scalar reach = range + wholeDt_*max(mag(p.state().u)) + slacks_[a];

    for
    (
        const auto& c : contactWeights::findWallFilms
        (
            walls_.surface(), wallsNear_[a], x, r, range, reach
        )
    )
    {
        sphereContact t
        (
            makeWallContact(a, c.i, x[c.i], c.wall, c.wall.overlap - reach)
        );
        t.reaches = true;
        t.gapR = gapModel::radii(r[c.i], c.curvature);
        t.bend = bendOf(c.curvature, t.n, r[c.i] - t.d, r[c.i]);
        t.gapWeight = c.weight;
        sphereContacts_.append(t);
    }
}


Foam::symmTensor Foam::contactStep::bendOf
(
    const symmTensor& curvature,
    const vector& n,
    const scalar s,
    const scalar radius
)
{
    // A function of the tensor from that of its eigenvalues, across n
    const scalar sum = tr(curvature);
    const scalar difference =
        Foam::sqrt(max(2*magSqr(curvature) - sqr(sum), scalar(0)));
    const auto bent = [&](const scalar k)
    {
        const scalar limited = max(k, -0.9/max(s, radius));
        return limited/(1 + limited*s);
    };
    const scalar k1 = 0.5*(sum + difference);
    const scalar b1 = bent(k1);
    if (difference <= 1e-6/radius)
    {
        return b1*(symmTensor::I - sqr(n));
    }
    const scalar slope = (b1 - bent(k1 - difference))/difference;
    return slope*curvature + (b1 - slope*k1)*(symmTensor::I - sqr(n));
}


Foam::contactStep::sphereContact Foam::contactStep::makeWallContact
(
    const label a,
    const label i,
    const point& x,
    const wallSurface::contact& plane,
    const scalar d
) const
{
    const vector& n = plane.normal;
    sphereContact t = sphereContact();
    t.patch = plane.patch;
    t.place = x - (type(a).radii()[i] - d)*n;
    t.moved = plane.moved;
    t.a = a;
    t.i = i;
    t.b = -1;
    t.j = -1;
    t.otherIndex = -1;
    t.n = n;
    t.wallNormal = n;
    t.d = d;
    t.radii = d;
    t.first = d - (plane.moved & n);    // the wall is where it ends the step
    t.R = type(a).radii()[i];
    t.m = massAt(a, i);
    t.ratio = 1;
    return t;
}


Foam::scalar Foam::contactStep::leastDistance
(
    const vector& x,
    const vector& dx
)
{
    const scalar at = -(x & dx)/max(magSqr(dx), VSMALL);
    return mag(x + min(max(at, scalar(0)), scalar(1))*dx);
}


Foam::scalar Foam::contactStep::massAt(const label a, const label i) const
{
    const clumpType& ct = type(a);
    return contactWeights::mass
    (
        i, clumps_[a].state().x, ct.radii(), ct.masses()
    );
}
