/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneTensions.H"
#include "triangleElasticity.H"

namespace
{

using namespace Foam;

//- The mean and half the difference of two values, the larger one first
Pair<scalar> values(const scalar mean, const scalar apart)
{
    return Pair<scalar>(mean + apart, mean - apart);
}

}


Foam::membraneTensions::membraneTensions
(
    const membraneMechanics& mechanics,
    const pointField& x
)
:
    areas_(mechanics.surface().triangles().size()),
    stretches_(areas_.size()),
    tensions_(areas_.size())
{
    symmTensorField T(areas_.size(), Zero);
    mechanics.addTensions(x, T);
    forAll(areas_, n)
    {
        const triFace& t = mechanics.surface().triangles()[n];
        areas_[n] = t.mag(x);

        // l1^2 + l2^2 and l1 l2
        const Pair<scalar> I
        (
            triangleElasticity::invariants
            (
                triangleElasticity::rest(t, mechanics.stressFree()),
                x[t[1]] - x[t[0]],
                x[t[2]] - x[t[0]]
            )
        );
        const scalar squares = I.first() + 2;
        const scalar product = Foam::sqrt(max(I.second() + 1, scalar(0)));
        stretches_[n] = values
        (
            0.5*Foam::sqrt(squares + 2*product),
            0.5*Foam::sqrt(max(squares - 2*product, scalar(0)))
        );

        // None along the normal
        const scalar mean = 0.5*tr(T[n]);
        tensions_[n] = values
        (
            mean, Foam::sqrt(max(0.5*magSqr(T[n]) - sqr(mean), scalar(0)))
        );
    }
}


Foam::scalar Foam::membraneTensions::partBelow(const scalar tension) const
{
    scalar below = 0;
    forAll(areas_, n)
    {
        if (tensions_[n].second() < tension)
        {
            below += areas_[n];
        }
    }
    return below/sum(areas_);
}
