/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "coveredCells.H"
#include "nearPoints.H"
#include "sphereDistance.H"

namespace
{

//- Of the weights: below exp(-this) times the largest one they are zero
constexpr Foam::scalar largestExponent = 74;

}


void Foam::coveredCells::update
(
    const cellGeometry& geometry,
    const solidFractionModel& solidFraction,
    const forcingModel& forcing,
    const clumpType& type,
    const clumpImage& image
)
{
    fadeFactor_ = image.fadeFactor;
    if (image.typeId == typeId_ && image.x == centres_)
    {
        return;
    }
    typeId_ = image.typeId;
    centres_ = image.x;

    findCells({geometry, solidFraction, forcing, type}, image);
    setWeights(type);
}


Foam::scalar Foam::coveredCells::fractionOf
(
    const search& by,
    const label celli,
    const scalar d,
    const UList<label>& spheres
) const
{
    const cellGeometry::cell& c = by.geometry[celli];
    if (mag(d) >= c.reach)
    {
        return d > c.reach ? 0 : 1;
    }
    const scalarField& radii = by.type.radii();
    DynamicList<point> nearCentres;
    DynamicList<scalar> nearRadii;
    if (by.solidFraction.needsSpheres())
    {
        for (const label i : spheres)
        {
            // The others do not reach into the cell
            if (mag(c.x - centres_[i]) < radii[i] + c.reach)
            {
                nearCentres.append(centres_[i]);
                nearRadii.append(radii[i]);
            }
        }
    }
    return by.solidFraction.fraction
    (
        by.geometry, celli, d, nearCentres, nearRadii
    );
}


void Foam::coveredCells::addCell
(
    const search& by,
    const label celli,
    const UList<label>& spheres,
    const sphereDistance& distance
)
{
    const cellGeometry::cell& c = by.geometry[celli];
    const scalar d = distance(c.x);
    if (d > by.forcing.nReaches()*c.reach)
    {
        return;
    }
    const scalar fraction = fractionOf(by, celli, d, spheres);
    const forcingModel::surfaceInCell surface
    (
        by.forcing.surface(by.geometry, celli, d, distance)
    );
    if
    (
        fraction <= SMALL && surface.wallConductance <= 0
     && !surface.centreInside
    )
    {
        return;
    }

    const scalar smallest = min(by.type.radii());
    if (smallest < 0.999*c.width)
    {
        FatalErrorInFunction
            << "Clump type " << by.type.name() << " has "
            << 2*smallest/c.width
            << " mesh cells per sphere diameter (sphere radius " << smallest
            << " m, mesh cell " << c.width << " m, at " << centres_[0]
            << "). At least 2 are required, and 4 are recommended: refine"
            << " the mesh." << exit(FatalError);
    }
    cells_.append
    (
        {
            celli, surface.centreInside, false, surface.wallConductance,
            d, c.x, c.volume, fraction, 0, 0, 0, Zero
        }
    );
}


void Foam::coveredCells::findCells(const search& by, const clumpImage& image)
{
    const scalarField& radii = by.type.radii();
    const scalar nReaches = by.forcing.nReaches();
    const scalar largest = max(radii);
    nearPoints near(centres_);
    const sphereDistance toAll(centres_, radii);

    DynamicList<point> someCentres;
    DynamicList<scalar> someRadii;
    cells_.clear();
    for (const label celli : by.geometry.find(image.box, nReaches))
    {
        const cellGeometry::cell& c = by.geometry[celli];
        if (magSqr(c.x - image.box.nearest(c.x)) > sqr(nReaches*c.reach))
        {
            continue;
        }
        if (near.few())
        {
            addCell(by, celli, near(c.x, 0), toAll);
            continue;
        }

        // The forcing asks for the distance on the lines to the neighbours, where
        // it may see larger radii
        const UList<label>& spheres = near
        (
            c.x,
            largest + max(nReaches*c.reach, c.longestLine) + 2*c.width
        );
        someCentres.clear();
        someRadii.clear();
        for (const label i : spheres)
        {
            someCentres.append(centres_[i]);
            someRadii.append(radii[i]);
        }
        if (spheres.size())
        {
            addCell(by, celli, spheres, sphereDistance(someCentres, someRadii));
        }
    }
}


Foam::vector Foam::coveredCells::normalise
(
    const label first,
    const scalar largest,
    const point& x
)
{
    scalar sum = 0;
    label end = first;
    for (label m = first; m < weights_.size(); ++m)
    {
        const scalar e = weights_[m].w - largest;
        if (e >= -largestExponent)
        {
            weights_[end] = {weights_[m].i, Foam::exp(e)};
            sum += weights_[end++].w;
        }
    }
    weights_.setSize(end);

    vector mean(Zero);
    for (label m = first; m < end; ++m)
    {
        sphereWeight& s = weights_[m];
        s.w /= sum;
        mean += s.w*(slopes_[s.i]*(x - centres_[s.i]));
    }
    return mean;
}


void Foam::coveredCells::setWeights(const clumpType& type)
{
    const scalarField radiiSqr(sqr(type.radii()));
    slopes_ = -2/sqr(type.transitions());

    // ln g of a sphere
    const auto logOf = [&](const label i, const point& x)
    {
        return 0.5*slopes_[i]*(magSqr(x - centres_[i]) - radiiSqr[i]);
    };
    nearPoints near(centres_);
    const scalar widestSqr = sqr(max(type.transitions()));
    const scalar largestSqr = max(radiiSqr);

    // Within which the ln g of a sphere is not too far below another
    const auto within = [&](const scalar other)
    {
        return 1.001*Foam::sqrt
        (
            largestSqr + widestSqr*max(largestExponent - other, scalar(0))
        );
    };

    weights_.clear();
    starts_.setSize(cells_.size() + 1);
    starts_[0] = 0;
    forAll(cells_, k)
    {
        const point& x = cells_[k].x;

        // Of any sphere; the nearer, the fewer are looked at then
        scalar some = logOf(0, x);
        if (!near.few())
        {
            for (const label i : near(x, Foam::sqrt(largestSqr)))
            {
                some = max(some, logOf(i, x));
            }
        }

        // The largest exponent taken out: the sum is never zero
        const UList<label>& around = near(x, within(some));
        const label first = weights_.size();
        scalar largest = -VGREAT;
        for (const label i : around)
        {
            weights_.append({i, logOf(i, x)});
            largest = max(largest, weights_.last().w);
        }

        cells_[k].meanSlope = normalise(first, largest, x);
        starts_[k + 1] = weights_.size();
    }
}
