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
            pairs_.append(makePair(centres, i, j));
        }
    }

    vectorField grad(centres.size());
    volume0_ = volume(centres, grad);

    // To 0.1 %: calibrateClump makes the models of a type for every curve
    const label nColumns = 100;
    const scalar exact = sphereUnion::volume(centres, radii, nColumns);
    if (mag(volume0_ - exact) > 0.01*exact)
    {
        FatalIOErrorInFunction(dict)
            << "conservationModel compression: the overlaps of pairs give a volume "
            << "of " << volume0_ << " m3, the union of the spheres has " << exact
            << " m3. Use unionVolume for this shape." << exit(FatalIOError);
    }
}


Foam::scalar Foam::conservationModels::compression::lensVolume
(
    const scalar d2,
    const scalar ri,
    const scalar rj,
    scalar& area
)
{
    using constant::mathematical::pi;

    area = 0;
    if (d2 >= sqr(ri + rj))
    {
        return 0;
    }
    if (d2 <= sqr(ri - rj) + sqr(1e-6*ri))
    {
        return 4*pi/3*pow3(min(ri, rj));
    }
    const scalar d = Foam::sqrt(d2);
    area = pi*(sqr(ri) - sqr(d2 + sqr(ri) - sqr(rj))/(4*d2));
    return pi*sqr(ri + rj - d)*(d2 + 2*d*(ri + rj) - 3*sqr(ri - rj))/(12*d);
}


Foam::conservationModels::compression::pair
Foam::conservationModels::compression::makePair
(
    const pointField& x,
    const label i,
    const label j
) const
{
    // The disc, or the middle of the gap
    const vector d(x[j] - x[i]);
    const scalar part =
        0.5*(1 + (sqr(radii_[i]) - sqr(radii_[j]))/max(magSqr(d), VSMALL));
    const point centre(x[i] + part*d);
    const scalar radius =
        Foam::sqrt(max(sqr(radii_[i]) - magSqr(centre - x[i]), 0));

    const vector axis(normalised(d));
    scalar area;
    scalar l = 0;
    forAll(x, k)
    {
        const vector c(x[k] - centre);
        const scalar along = c & axis;
        const scalar farthest = mag(c - along*axis) + radius;
        if (k != i && k != j && sqr(along) + sqr(farthest) < sqr(radii_[k]))
        {
            for (const label end : {i, j})
            {
                l = max
                (
                    l,
                    lensVolume(magSqr(x[k] - x[end]), radii_[k], radii_[end], area)
                );
            }
        }
    }

    if (l <= 0)
    {
        return pair{i, j, 0, 0};
    }

    const scalar v =
        4*constant::mathematical::pi/3*pow3(min(radii_[i], radii_[j]));
    const scalar L0 =
        min(l, lensVolume(magSqr(d), radii_[i], radii_[j], area));
    return pair{i, j, L0, (l - L0)*(v - L0)/max(v - l, 1e-3*v)};
}


Foam::scalar Foam::conservationModels::compression::volume
(
    const pointField& x,
    vectorField& grad
) const
{
    grad = Zero;
    scalar result = 4*constant::mathematical::pi/3*sum(pow3(radii_));

    for (const pair& p : pairs_)
    {
        const vector dx(x[p.j] - x[p.i]);
        scalar area;
        const scalar X =
            lensVolume(magSqr(dx), radii_[p.i], radii_[p.j], area) - p.L0;
        if (X <= 0)
        {
            continue;
        }
        result -= sqr(X)/(X + p.B);

        if (area > 0)
        {
            const vector slope
            (
                area*X*(X + 2*p.B)/sqr(X + p.B)/mag(dx)*dx
            );
            grad[p.j] += slope;
            grad[p.i] -= slope;
        }
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
