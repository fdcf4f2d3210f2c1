/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallContacts.H"
#include "StringStream.H"
#include "volFields.H"
#include "wallDisplacement.H"
#include "wallPolyPatch.H"

Foam::wallContacts::wallContacts
(
    const polyMesh& mesh,
    const PtrList<clumpType>& types,
    const dictionary& clumpProperties
)
:
    mesh_(mesh),
    types_(types),
    laws_
    (
        getDict(clumpProperties, "wallContactModel"), types, mesh.boundaryMesh()
    ),
    neighbourhood_(-1),
    gap_(GREAT),
    radius_(0),
    sight_(GREAT),
    nearness_(0),
    clearance_(0)
{}


void Foam::wallContacts::update(const ghostExchange& ghosts)
{
    // Walls of the neighbouring processors belong to it
    if (neighbourhood_ != ghosts.neighbourhood())
    {
        neighbourhood_ = ghosts.neighbourhood();
        clear();
    }
    if (!walls_.valid())
    {
        walls_.reset(new wallSurface(mesh_, ghosts));
    }
}


void Foam::wallContacts::updateMotions
(
    const ghostExchange& ghosts,
    const gapForces& gaps
)
{
    const auto* U = mesh_.findObject<volVectorField>("U");
    if (!(laws_.frictional() || gaps.bonds()) || !U)
    {
        return;
    }
    motions_.setSize(mesh_.boundaryMesh().size());
    forAll(U->boundaryField(), patchi)
    {
        if (!isA<wallPolyPatch>(mesh_.boundaryMesh()[patchi]))
        {
            continue;
        }
        bool rubs = false;
        forAll(types_, typei)
        {
            rubs =
                rubs || laws_(typei, patchi).frictional()
             || gaps.kineticsAt({typei, patchi, true, 0}).size();
        }
        if (!rubs)
        {
            continue;
        }
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        if (pointsMove(patch) && !pointsSlide(patch))
        {
            // Each contact has the displacement of its wall
            motions_[patchi] = wallMotion();
            continue;
        }
        motions_[patchi] = wallMotion(U->boundaryField()[patchi]);
        const vector& w = motions_[patchi].w();
        for (const vector& shift : ghosts.shifts())
        {
            if (mag(w ^ shift) > 1e-6*mag(w)*mag(shift))
            {
                FatalErrorInFunction
                    << "The wall patch " << mesh_.boundaryMesh()[patchi].name()
                    << " turns about the direction " << w/mag(w) << " in a mesh with the"
                    << " period " << shift << ": its images would not move as it does."
                    << " Friction and bonds need walls that turn about a periodic direction,"
                    << " or no periodic patches." << exit(FatalError);
            }
        }
    }
}


void Foam::wallContacts::clear()
{
    walls_.clear();
    clearance_ = 0;
}


bool Foam::wallContacts::gapMeasured
(
    const Cloud<clumpParcel>& clumps,
    const scalar displacement,
    const scalar range
)
{
    const auto nearness = [&]()
    {
        return max(max(0.5*radius_, range), 2*displacement);
    };

    // A step may accelerate a clump to twice its velocity
    clearance_ -= displacement;
    nearness_ = nearness();
    if (clearance_ > nearness_ - 0.5*radius_)
    {
        return false;
    }
    measureGap(clumps);
    nearness_ = nearness();
    clearance_ = near() ? 0 : gap_ - 0.5*radius_;
    return true;
}


void Foam::wallContacts::measureGap(const Cloud<clumpParcel>& clumps)
{
    gap_ = GREAT;
    sight_ = GREAT;
    radius_ = 0;
    for (const clumpParcel& p : clumps)
    {
        const clumpType& type = types_[p.typeId()];
        if (type.fixed())
        {
            continue;
        }
        const pointField centres(p.centres());
        forAll(centres, i)
        {
            const scalar r = type.radii()[i];
            const scalar limit = min(20*r, walls_->known());
            const scalar nearest = min(limit, gap_ + r);    // what is farther does not count
            if (nearest > 0)
            {
                gap_ = min(gap_, walls_->distance(centres[i], nearest) - r);
            }
            sight_ = min(sight_, limit - r);
            radius_ = max(radius_, r);
        }
    }
    reduce(gap_, minOp<scalar>());
    reduce(sight_, minOp<scalar>());
    reduce(radius_, maxOp<scalar>());
}


Foam::string Foam::wallContacts::gap() const
{
    if (gap_ >= sight_)
    {
        return "no wall is near";
    }

    // Two digits are enough for the log
    OStringStream os;
    os.precision(2);
    os << "the nearest wall is " << gap_ << " m away";
    return os.str();
}
