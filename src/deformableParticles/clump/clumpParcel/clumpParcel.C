/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpParcel.H"
#include "Cloud.H"
#include "standingMesh.H"

namespace Foam
{
    defineTypeNameAndDebug(clumpParcel, 0);
    defineTemplateTypeNameAndDebug(Cloud<clumpParcel>, 0);
}


Foam::point Foam::clumpParcel::inside
(
    const polyMesh& mesh,
    const point& position,
    const label celli
)
{
    return position + 1e-9*(mesh.cellCentres()[celli] - position);
}


Foam::clumpParcel::clumpParcel
(
    const polyMesh& mesh,
    const point& position,
    const label celli,
    const label typeId,
    const clumpState& state
)
:
    particle(standingMesh(mesh)(), inside(mesh, position, celli), celli),
    typeId_(typeId),
    pieceOf_(-1),
    state_(state),
    fluidForces_(state.x.size(), Zero),
    fluidTorques_(state.x.size(), Zero),
    couplingFactor_(1),
    overshoots_(0),
    displacement_(Zero),
    target_(position),
    offset_(Zero),
    sinceMet_(Zero),
    acceleration_(Zero),
    accelerationBefore_(Zero)
{
    state_.x += position - this->position();
}


Foam::point Foam::clumpParcel::position() const
{
    return
        mesh().moving()
      ? currentTetIndices().tet(mesh()).barycentricToPoint(coordinates())
      : particle::position();
}


void Foam::clumpParcel::autoMap
(
    const point& position,
    const mapPolyMesh& mapper
)
{
    label celli = mapper.reverseCellMap()[cell()];
    if (celli < -1)
    {
        celli = -celli - 2;     // merged
    }
    const standingMesh standing(mesh());
    relocate(inside(mesh(), position, celli), celli);
    state_.x += position - this->position();
}


void Foam::clumpParcel::accept
(
    const clumpType& type,
    const vector& s,
    const vector& dU
)
{
    sinceMet_ = step_.end.centre(type) - state_.centre(type) - s - step_.extrapolation;
    const vector change(step_.end.velocity(type) - state_.velocity(type));
    const scalar along = (change & dU)/max(magSqr(dU), VSMALL);
    const scalar shared = min(max(along, scalar(0)), scalar(1));
    accelerationBefore_ = acceleration_;
    acceleration_ = (change - shared*dU)/mesh().time().deltaTValue();
    state_ = step_.end;
    step_.extrapolation = Zero;
    step_.extrapolationTime = 0;
}


void Foam::clumpParcel::becomePiece
(
    const label typeId,
    const labelUList& spheres,
    const labelUList& bonds
)
{
    typeId_ = typeId;
    if (pieceOf_ < 0)
    {
        pieceOf_ = origId();
    }
    state_ = state_.part(spheres, bonds);
    fluidForces_ = vectorField(fluidForces_, spheres);
    fluidTorques_ = vectorField(fluidTorques_, spheres);

    // That of the whole clump tells nothing of the next step
    acceleration_ = Zero;
    accelerationBefore_ = Zero;

    clumpStep step;
    step.fadeFactor = step_.fadeFactor;
    step.begin(state_);
    step.end = state_;
    if (step_.forces.f.size())
    {
        step.forces = externalForces(step_.forces, spheres);
    }
    step_ = step;
}


Foam::vector Foam::clumpParcel::expectedAcceleration() const
{
    const scalar change =
        mag(acceleration_ - accelerationBefore_)
       /max(max(mag(acceleration_), mag(accelerationBefore_)), VSMALL);
    return min(max(2 - 2*change, scalar(0)), scalar(1))*acceleration_;
}


void Foam::clumpParcel::recentre(const clumpType& type)
{
    displacement_ = state_.centre(type);
    target_ = position() + displacement_;
    state_.x -= displacement_;
}


Foam::clumpParcel::clumpParcel
(
    const polyMesh& mesh,
    Istream& is,
    bool readFields,
    bool newFormat
)
:
    particle(mesh, is, readFields, newFormat),
    typeId_(-1),
    pieceOf_(-1),
    couplingFactor_(1),
    overshoots_(0),
    displacement_(Zero),
    target_(Zero),
    offset_(Zero),
    sinceMet_(Zero),
    acceleration_(Zero),
    accelerationBefore_(Zero)
{
    if (readFields)
    {
        is  >> typeId_ >> pieceOf_ >> displacement_ >> target_ >> offset_ >> sinceMet_
            >> acceleration_ >> accelerationBefore_ >> state_
            >> fluidForces_ >> fluidTorques_ >> surfaceForce_ >> surfaceTorque_
            >> couplingFactor_ >> overshoots_;
    }
    is.check(FUNCTION_NAME);
}


Foam::Ostream& Foam::operator<<(Ostream& os, const clumpParcel& p)
{
    os  << static_cast<const particle&>(p)
        << token::SPACE << p.typeId_
        << token::SPACE << p.pieceOf_
        << token::SPACE << p.displacement_
        << token::SPACE << p.target_
        << token::SPACE << p.offset_
        << token::SPACE << p.sinceMet_
        << token::SPACE << p.acceleration_
        << token::SPACE << p.accelerationBefore_
        << token::SPACE << p.state_
        << token::SPACE << p.fluidForces_
        << token::SPACE << p.fluidTorques_
        << token::SPACE << p.surfaceForce_
        << token::SPACE << p.surfaceTorque_
        << token::SPACE << p.couplingFactor_
        << token::SPACE << p.overshoots_;
    os.check(FUNCTION_NAME);
    return os;
}
