/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "coveredCells.H"
#include "sphereDistance.H"

void Foam::coveredCells::update
(
    const cellGeometry& geometry,
    const solidFractionModel& solidFraction,
    const forcingModel& forcing,
    const clumpType& type,
    const clumpImage& image
)
{
    presence_ = image.presence;
    if (image.typeId == typeId_ && image.x == centres_)
    {
        return;
    }
    typeId_ = image.typeId;
    centres_ = image.x;

    findCells(geometry, solidFraction, forcing, type, image);
    setWeights(type);
}


void Foam::coveredCells::findCells
(
    const cellGeometry& geometry,
    const solidFractionModel& solidFraction,
    const forcingModel& forcing,
    const clumpType& type,
    const clumpImage& image
)
{
    const scalarField& radii = type.radii();
    const scalar smallest = min(radii);
    const scalar nReaches = forcing.nReaches();
    const sphereDistance distance(centres_, radii);

    DynamicList<point> nearCentres;
    DynamicList<scalar> nearRadii;

    cells_.clear();
    for (const label celli : geometry.find(image.box, nReaches))
    {
        const cellGeometry::cell& c = geometry[celli];
        if (magSqr(c.x - image.box.nearest(c.x)) > sqr(nReaches*c.reach))
        {
            continue;
        }
        const scalar d = distance(c.x);

        if (d > nReaches*c.reach)
        {
            continue;
        }

        scalar fraction = d > c.reach ? 0 : 1;
        if (mag(d) < c.reach)
        {
            nearCentres.clear();
            nearRadii.clear();
            if (solidFraction.needsSpheres())
            {
                forAll(centres_, i)
                {
                    // The others do not reach into the cell
                    if (mag(c.x - centres_[i]) < radii[i] + c.reach)
                    {
                        nearCentres.append(centres_[i]);
                        nearRadii.append(radii[i]);
                    }
                }
            }
            fraction = solidFraction.fraction
            (
                geometry, celli, d, nearCentres, nearRadii
            );
        }

        const forcingModel::surfaceInCell surface
        (
            forcing.surface(geometry, celli, d, distance)
        );

        if
        (
            fraction > SMALL
         || surface.wallConductance > 0
         || surface.centreInside
        )
        {
            if (smallest < 0.999*c.width)
            {
                FatalErrorInFunction
                    << "Clump type " << type.name() << " has "
                    << 2*smallest/c.width
                    << " mesh cells per sphere diameter (sphere radius " << smallest
                    << " m, mesh cell " << c.width << " m, at " << centres_[0]
                    << "). At least 2 are required, and 4 are recommended: refine"
                    << " the mesh." << exit(FatalError);
            }
            cells_.append
            (
                {
                    celli, surface.centreInside, surface.wallConductance,
                    c.x, c.volume, fraction, 0, 0, 0, Zero
                }
            );
        }
    }
}


void Foam::coveredCells::setWeights(const clumpType& type)
{
    const label n = type.size();
    const scalarField radiiSqr(sqr(type.radii()));

    weights_.setSize(n*cells_.size());
    slopes_ = -2/sqr(type.transitions());

    forAll(cells_, k)
    {
        const point& x = cells_[k].x;
        scalar* w = weights_.data() + n*k;

        // The largest exponent taken out: the sum is never zero
        scalar largest = -VGREAT;
        for (label i = 0; i < n; ++i)
        {
            w[i] = 0.5*slopes_[i]*(magSqr(x - centres_[i]) - radiiSqr[i]);
            largest = max(largest, w[i]);
        }

        scalar sum = 0;
        for (label i = 0; i < n; ++i)
        {
            w[i] = Foam::exp(max(w[i] - largest, scalar(-200)));
            sum += w[i];
        }

        vector mean(Zero);
        for (label i = 0; i < n; ++i)
        {
            w[i] /= sum;
            mean += w[i]*(slopes_[i]*(x - centres_[i]));
        }
        cells_[k].meanSlope = mean;
    }
}
