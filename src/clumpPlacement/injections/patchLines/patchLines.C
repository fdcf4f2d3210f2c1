/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "patchLines.H"
#include "faceTriangles.H"

Foam::patchLines::patchLines
(
    const polyMesh& mesh,
    const labelHashSet& patches
)
:
    mesh_(mesh),
    patches_(patches)
{
    collect();
}


void Foam::patchLines::collect()
{
    DynamicList<point> corners;
    DynamicList<label> faces;
    for (const label patchi : patches_)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        forAll(pp, i)
        {
            const List<point> ofFace
            (
                faceTriangles(pp[i], mesh_.points())
            );
            corners.append(ofFace);
            faces.append(labelList(ofFace.size()/3, pp.start() + i));
        }
    }
    corners_ = corners;
    faces_ = faces;
    box_ = boundBox(corners_, true);
}


Foam::scalar Foam::patchLines::place
(
    const label triangle,
    const point& origin,
    const vector& direction
) const
{
    // Moeller and Trumbore 1997, Journal of Graphics Tools 2, 21-28
    const point& a = corners_[3*triangle];
    const vector ab(corners_[3*triangle + 1] - a);
    const vector ac(corners_[3*triangle + 2] - a);
    const vector p(direction ^ ac);
    const scalar det = ab & p;
    if (mag(det) < VSMALL)
    {
        return GREAT;
    }
    const vector d(origin - a);
    const scalar u = (d & p)/det;
    const vector q(d ^ ab);
    const scalar v = (direction & q)/det;
    return u < 0 || v < 0 || u + v > 1 ? GREAT : (ac & q)/det;
}


void Foam::patchLines::keepFirst(hit& a, const hit& b)
{
    if (b.place < a.place)
    {
        a = b;
    }
}


Foam::Ostream& Foam::operator<<(Ostream& os, const patchLines::hit& h)
{
    return os
        << h.place << token::SPACE << h.patchi << token::SPACE << h.x
        << token::SPACE << h.inwards;
}


Foam::Istream& Foam::operator>>(Istream& is, patchLines::hit& h)
{
    return is >> h.place >> h.patchi >> h.x >> h.inwards;
}
