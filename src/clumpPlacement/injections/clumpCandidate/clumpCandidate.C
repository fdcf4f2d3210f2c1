/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpCandidate.H"
#include "foamCompat.H"
#include "PtrList.H"
#include "surfaceDistance.H"
#include <algorithm>

namespace
{

using namespace Foam;

//- Whether spheres of a clump or nodes of a membrane at x are nearer to a membrane than
//  a gap, or inside
bool near
(
    const clumpType& membrane,
    const pointField& nodes,
    const clumpType& other,
    const pointField& x,
    const scalar gap
)
{
    const scalarField r
    (
        other.hasTriangles() ? scalarField(x.size(), Zero) : other.radii()
    );
    const scalar most = max(max(r) + gap, scalar(0));
    const boundBox box(grown(boundBox(nodes, false), most));
    DynamicList<label> inBox;
    forAll(x, i)
    {
        if (box.contains(x[i]))
        {
            inBox.append(i);
        }
    }
    if (inBox.empty())
    {
        return false;
    }
    const auto places = surfaceDistance(membrane.surface(), nodes).nearest
    (
        pointField(x, inBox), max(most, membrane.halfWidth())
    );
    forAll(inBox, k)
    {
        if (places[k].found && places[k].distance < r[inBox[k]] + gap)
        {
            return true;
        }
    }
    return false;
}

}


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


void Foam::gatherByIndex(List<clumpCandidate>& candidates)
{
    if (!returnReduce(candidates.size(), sumOp<label>()))
    {
        return;
    }
    reduceWhole
    (
        candidates,
        [](List<clumpCandidate>& a, const List<clumpCandidate>& b) { a.append(b); }
    );
    std::sort
    (
        candidates.begin(), candidates.end(),
        [](const clumpCandidate& a, const clumpCandidate& b)
        {
            return a.index < b.index;
        }
    );
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
    const clumpType& typeA = types[a.typeId];
    const clumpType& typeB = types[b.typeId];
    if (typeA.hasTriangles() || typeB.hasTriangles())
    {
        const pointField xa(a.centres());
        const pointField xb(b.centres() + shift);
        return
            (typeA.hasTriangles() && near(typeA, xa, typeB, xb, gap))
         || (typeB.hasTriangles() && near(typeB, xb, typeA, xa, gap));
    }
    const scalarField& ra = typeA.radii();
    const scalarField& rb = typeB.radii();
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
