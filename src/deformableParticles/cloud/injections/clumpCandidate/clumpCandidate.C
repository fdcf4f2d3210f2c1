/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpCandidate.H"
#include "PtrList.H"

Foam::Ostream& Foam::operator<<(Ostream& os, const clumpCandidate& c)
{
    return os
        << c.typeId << token::SPACE << c.patchi << token::SPACE << c.position
        << token::SPACE << c.state
        << token::SPACE << c.followsFlow << token::SPACE << c.inwards
        << token::SPACE << c.index << token::SPACE << c.couplingFactor;
}


Foam::Istream& Foam::operator>>(Istream& is, clumpCandidate& c)
{
    return is
        >> c.typeId >> c.patchi >> c.position >> c.state >> c.followsFlow
        >> c.inwards >> c.index >> c.couplingFactor;
}


bool Foam::overlap
(
    const clumpCandidate& a,
    const clumpCandidate& b,
    const PtrList<clumpType>& types,
    const scalar gap,
    const vector& shift
)
{
    const scalarField& ra = types[a.typeId].radii();
    const scalarField& rb = types[b.typeId].radii();
    forAll(ra, i)
    {
        const point x(a.position + a.state.x[i] - b.position - shift);
        forAll(rb, j)
        {
            if (magSqr(x - b.state.x[j]) < sqr(ra[i] + rb[j] + gap))
            {
                return true;
            }
        }
    }
    return false;
}
