/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "compression.H"
#include "mathematicalConstants.H"
#include "sphereUnion.H"

namespace Foam
{
namespace conservationModels
{
    defineTypeNameAndDebug(compression, 0);
    addToRunTimeSelectionTable(conservationModel, compression, dictionary);
}
}


Foam::conservationModels::compression::compression
(
    const dictionary& dict,
    const pointField& centres,
    const scalarField& radii
)
:
    volumeModulus_(getPositive(dict, "volumeModulus")),
    radii_(radii),
    volume0_(0)
{
    checkEntries(dict, {"type", "volumeModulus"});

    forAll(centres, i)
    {
        for (label j = i + 1; j < centres.size(); ++j)
        {
            if (!covered(centres, i, j))
            {
                pairs_.append(labelPair(i, j));
            }
        }
    }

    vectorField grad(centres.size());
    volume0_ = volume(centres, grad);

    const scalar exact = sphereUnion::volume(centres, radii);
    if (mag(volume0_ - exact) > 0.01*exact)
    {
        FatalIOErrorInFunction(dict)
            << "conservationModel compression: the overlaps of pairs give a volume "
            << "of " << volume0_ << " m3, the union of the spheres has " << exact
            << " m3. Use unionVolume for this shape." << exit(FatalIOError);
    }
}


bool Foam::conservationModels::compression::covered
(
    const pointField& x,
    const label i,
    const label j
) const
{
    // The disc, or the point between spheres that are apart
    const vector d(x[j] - x[i]);
    const scalar part =
        0.5*(1 + (sqr(radii_[i]) - sqr(radii_[j]))/max(magSqr(d), VSMALL));
    const point centre(x[i] + part*d);
    const scalar radius =
        Foam::sqrt(max(sqr(radii_[i]) - magSqr(centre - x[i]), 0));

    const vector axis(normalised(d));
    forAll(x, k)
    {
        const vector c(x[k] - centre);
        const scalar along = c & axis;
        const scalar farthest = mag(c - along*axis) + radius;
        if (k != i && k != j && sqr(along) + sqr(farthest) < sqr(radii_[k]))
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::conservationModels::compression::volume
(
    const pointField& x,
    vectorField& grad
) const
{
    using constant::mathematical::pi;

    grad = Zero;
    scalar result = 4*pi/3*sum(pow3(radii_));

    for (const labelPair& p : pairs_)
    {
        const scalar ri = radii_[p.first()];
        const scalar rj = radii_[p.second()];
        const vector dx(x[p.second()] - x[p.first()]);
        const scalar d2 = magSqr(dx);
        if (d2 >= sqr(ri + rj))
        {
            continue;
        }
        if (d2 <= sqr(ri - rj) + sqr(1e-6*ri))
        {
            result -= 4*pi/3*pow3(min(ri, rj));
            continue;
        }

        const scalar d = Foam::sqrt(d2);
        result -=
            pi*sqr(ri + rj - d)*(d2 + 2*d*(ri + rj) - 3*sqr(ri - rj))/(12*d);

        const scalar area =
            pi*(sqr(ri) - sqr(d2 + sqr(ri) - sqr(rj))/(4*d2));
        const vector slope(area/d*dx);
        grad[p.second()] += slope;
        grad[p.first()] -= slope;
    }

    return result;
}


Foam::scalar Foam::conservationModels::compression::deviation
(
    const pointField& x,
    vectorField& grad
) const
{
    const scalar change = volume(x, grad) - (1 - freeLoss)*volume0_;
    if (change >= 0)
    {
        grad = Zero;
    }
    return min(change, 0);
}
