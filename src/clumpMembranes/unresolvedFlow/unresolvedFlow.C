/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "unresolvedFlow.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

const scalar rootHalf = Foam::sqrt(0.5);
const scalar rootTwoOverPi = Foam::sqrt(2/constant::mathematical::pi);

//- Integral of 1/r over the plane less its sum over the other points of a hexagonal lattice,
//  with one point in the area one (Bonsall and Maradudin 1977)
constexpr scalar hexagonal = 3.921034;

//- Distances, over s: below the first one the differences lose their digits, beyond the
//  second one the Gaussian is zero to eight of them
constexpr scalar near = 1e-3;
constexpr scalar far = 6;

}


void Foam::unresolvedFlow::addPair
(
    const vector& r,
    const vector& force,
    const vector& otherForce,
    vector& u,
    vector& other
) const
{
    const scalar distance = max(mag(r)/s_, near);
    const scalar inverse = 1/(s_*distance);
    scalar c = 0;
    scalar q = sqr(s_)*pow3(inverse);
    if (distance < far)
    {
        c = Foam::erfc(rootHalf*distance);
        q *= 1 - c - rootTwoOverPi*distance*Foam::exp(-0.5*sqr(distance));
    }
    const scalar isotropic = c*inverse - q;
    const vector n(inverse*r);
    const vector radial((c*inverse + 3*q)*n);
    u += isotropic*otherForce + (n & otherForce)*radial;
    other += isotropic*force + (n & force)*radial;
}


Foam::vectorField Foam::unresolvedFlow::operator()
(
    const UList<point>& x,
    const UList<vector>& forces,
    const UList<vector>& normals,
    const UList<scalar>& areas,
    const label nOnSurface
) const
{
    const scalar own = 4*rootTwoOverPi/(3*s_);
    vectorField u(x.size(), Zero);
    for (label i = 0; i < nOnSurface; ++i)
    {
        const vector& F = forces[i];
        const scalar even = hexagonal/Foam::sqrt(areas[i]);
        const scalar left =
            4*constant::mathematical::pi*rootTwoOverPi*s_/areas[i];
        const vector along(normals[i]*(normals[i] & F));
        u[i] += (even - own)*along + (1.5*even - own - left)*(F - along);
        for (label j = 0; j < i; ++j)
        {
            addPair(x[i] - x[j], F, forces[j], u[i], u[j]);
        }
    }
    return u/(8*constant::mathematical::pi);
}
