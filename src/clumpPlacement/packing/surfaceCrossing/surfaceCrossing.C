/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceCrossing.H"
#include "foamCompat.H"
#include "packingRegion.H"
#include "StringStream.H"

Foam::surfaceCrossing::surfaceCrossing
(
    const polyMesh& mesh,
    const PtrList<clumpType>& types,
    const ghostExchange& ghosts,
    const scalar tolerance
)
:
    types_(types),
    nClumps_(0),
    depth_(tolerance),
    clump_(-1),
    typeId_(-1),
    sphere_(-1),
    centre_(Zero),
    width_(GREAT)
{
    packingRegion region(dictionary(), mesh);
    region.update(ghosts);

    for (label a = 0; a < ghosts.nOwn(); ++a)
    {
        const clumpImage& image = ghosts.images()[a];
        const clumpType& type = types[image.typeId];
        const scalar size = cmptMax(image.box.span());
        bool crosses = false;
        forAll(image.x, i)
        {
            const scalar r = type.radii()[i];
            region.forEachSurface
            (
                image.x[i], size,
                [&](const scalar height, const vector& away)
                {
                    // A node of a surface is outside as soon as it crosses
                    const scalar depth =
                        type.hasTriangles()
                      ? (height < 0 ? 1 - height/r : scalar(0)) : (r - height)/r;
                    crosses = crosses || (depth > tolerance && !type.fixed());
                    if (depth > tolerance && !type.fixed() && type.ofSpheres())
                    {
                        findOpposite
                        (
                            region, image, i, image.x[i] + (r - height)*away, away,
                            tolerance
                        );
                    }
                    if (depth > depth_ && !type.fixed())
                    {
                        depth_ = depth;
                        clump_ = image.id.second();
                        typeId_ = image.typeId;
                        sphere_ = i;
                        centre_ = image.x[i];
                    }
                }
            );
        }
        nClumps_ += crosses;
    }
    reduce(nClumps_, sumOp<label>());
    keepDeepest();
}


void Foam::surfaceCrossing::findOpposite
(
    const packingRegion& region,
    const clumpImage& image,
    const label sphere,
    const point& touching,
    const vector& away,
    const scalar tolerance
)
{
    const scalar r = types_[image.typeId].radii()[sphere];
    region.forEachSurface
    (
        touching, r,
        [&](const scalar height, const vector& other)
        {
            if (height < (1 - tolerance)*r && (away & other) < -0.9 && width_ == GREAT)
            {
                width_ = r + height;
                OStringStream os;
                os  << "sphere " << sphere << " of clump " << image.id.second()
                    << " of type " << types_[image.typeId].name() << " has a diameter of "
                    << 2*r << " m, but the mesh has a width of " << width_
                    << " m at " << image.x[sphere] << '.';
                wide_ = os.str();
            }
        }
    );
}


void Foam::surfaceCrossing::keepDeepest()
{
    reduceWhole
    (
        wide_, [](string& a, const string& b) { if (a.empty()) { a = b; } }
    );

    const scalar deepest = returnReduce(depth_, maxOp<scalar>());
    const label owner = returnReduce
    (
        depth_ < deepest ? labelMax : Pstream::myProcNo(), minOp<label>()
    );
    const bool mine = owner == Pstream::myProcNo();
    depth_ = deepest;
    for (label* n : {&clump_, &typeId_, &sphere_})
    {
        *n = returnReduce(mine ? *n : label(-1), maxOp<label>());
    }
    centre_ = returnReduce(mine ? centre_ : vector::zero, sumOp<vector>());
}


Foam::string Foam::surfaceCrossing::description() const
{
    OStringStream os;
    os  << "sphere " << sphere_ << " of clump " << clump_ << " of type "
        << types_[typeId_].name() << " at " << centre_;
    if (outside())
    {
        os  << " lies outside the mesh.";
    }
    else
    {
        os  << " reaches " << depth_ << " of its radii beyond a wall, a plane of"
            << " symmetry or an open patch.";
    }
    return os.str();
}
