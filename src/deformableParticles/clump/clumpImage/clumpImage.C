/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpImage.H"

void Foam::clumpImage::set
(
    const clumpParcel& p,
    const clumpType& type,
    const clumpState& s,
    const label parcelIndex,
    const vector& extrapolation,
    const scalar extrapolationTime
)
{
    owner = Pstream::myProcNo();
    index = parcelIndex;
    original = true;
    typeId = p.typeId();
    id = labelPair(p.origProc(), p.origId());
    pieceOf = p.pieceOf();
    transform = imageTransform();
    fadeFactor = 1;

    const point centre(p.position());
    x.setSize(s.x.size());
    u = s.u;
    omega.setSize(s.u.size());
    omega = Zero;
    contraction = 0;
    slack = 0;
    box = boundBox::invertedBox;
    const bool deforms = extrapolationTime > 0;
    const vector velocity(deforms ? s.velocity(type) : vector::zero);
    forAll(x, i)
    {
        x[i] = s.x[i] + centre + extrapolation;
        if (deforms)
        {
            x[i] += extrapolationTime*(s.u[i] - velocity);
        }
        box.add(x[i] - type.radii()[i]*vector::one);
        box.add(x[i] + type.radii()[i]*vector::one);
    }
    reach = max
    (
        cmptMax(box.max() - centre), cmptMax(centre - box.min())
    );
    clearForces();
}


Foam::Ostream& Foam::operator<<(Ostream& os, const clumpImage& i)
{
    return os
        << i.owner << token::SPACE << i.index << token::SPACE
        << i.typeId << token::SPACE << i.id << token::SPACE
        << i.pieceOf << token::SPACE << i.transform
        << token::SPACE << i.x << token::SPACE << i.u << token::SPACE
        << i.omega << token::SPACE << i.box << token::SPACE << i.fadeFactor
        << token::SPACE << i.slack;
}


Foam::Istream& Foam::operator>>(Istream& is, clumpImage& i)
{
    is  >> i.owner >> i.index >> i.typeId >> i.id >> i.pieceOf >> i.transform >> i.x
        >> i.u >> i.omega >> i.box >> i.fadeFactor >> i.slack;
    i.original = false;
    i.contraction = 0;
    i.clearForces();
    return is;
}
