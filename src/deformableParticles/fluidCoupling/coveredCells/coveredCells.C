/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "coveredCells.H"
#include "sphereUnion.H"

void Foam::coveredCells::find
(
    const cellGeometry& geometry,
    const solidFractionModel& solidFraction,
    const forcingModel& forcing,
    const clumpType& type,
    const clumpImage& image
)
{
    typeId = image.typeId;
    centres = image.x;

    const fvMesh& mesh = geometry.mesh();
    const scalarField& radii = type.radii();
    const scalar smallest = min(radii);
    const scalar nReaches = forcing.nReaches();
    DynamicList<point> nearCentres;
    DynamicList<scalar> nearRadii;

    for (const label celli : geometry.find(image.box, nReaches))
    {
        const point& x = mesh.cellCentres()[celli];
        const scalar reach = geometry.reach(celli);
        if (magSqr(x - image.box.nearest(x)) > sqr(nReaches*reach))
        {
            continue;
        }
        const scalar d = sphereUnion::distance(x, image.x, radii);

        if (d > nReaches*reach)
        {
            continue;
        }

        scalar fraction = d > reach ? 0 : 1;
        if (mag(d) < reach)
        {
            nearCentres.clear();
            nearRadii.clear();
            forAll(image.x, i)
            {
                // The others do not reach into the cell
                if (mag(x - image.x[i]) < radii[i] + reach)
                {
                    nearCentres.append(image.x[i]);
                    nearRadii.append(radii[i]);
                }
            }
            fraction = solidFraction.fraction
            (
                mesh, celli, d, nearCentres, nearRadii
            );
        }

        const forcingModel::surfaceInCell surface
        (
            forcing.surface(geometry, celli, image.x, radii)
        );

        if
        (
            fraction > SMALL
         || surface.wallConductance > 0
         || surface.centreInside
        )
        {
            const scalar dx = geometry.width(celli);
            if (smallest < 0.999*dx)
            {
                FatalErrorInFunction
                    << "Clump type " << type.name() << " has " << 2*smallest/dx
                    << " mesh cells per sphere diameter (sphere radius " << smallest
                    << " m, mesh cell " << dx << " m, at " << image.x[0]
                    << "). At least 2 are required, and 4 are recommended: refine"
                    << " the mesh." << exit(FatalError);
            }
            cells.append(celli);
            lambda.append(fraction);
            centreInside.append(surface.centreInside);
            wallConductance.append(surface.wallConductance);
        }
    }
    share.setSize(cells.size());
}


void Foam::coveredCells::setWeights
(
    const fvMesh& mesh,
    const clumpType& type,
    const clumpImage& image
)
{
    const label n = type.size();

    weights.setSize(n*cells.size());
    gradWeights.setSize(n*cells.size());
    scalarField exponent(n);

    forAll(cells, k)
    {
        const point& x = mesh.cellCentres()[cells[k]];
        scalar* w = &weights[n*k];
        vector* gradW = &gradWeights[n*k];

        for (label i = 0; i < n; ++i)
        {
            exponent[i] = -magSqr(x - image.x[i])/sqr(type.radii()[i]);
        }

        // The largest exponent taken out: the sum is never zero
        const scalar largest = max(exponent);
        scalar sum = 0;
        for (label i = 0; i < n; ++i)
        {
            w[i] = Foam::exp(max(exponent[i] - largest, scalar(-200)));
            sum += w[i];
        }

        vector mean(Zero);
        for (label i = 0; i < n; ++i)
        {
            w[i] /= sum;
            gradW[i] = -2/sqr(type.radii()[i])*(x - image.x[i]);
            mean += w[i]*gradW[i];
        }
        for (label i = 0; i < n; ++i)
        {
            gradW[i] = w[i]*(gradW[i] - mean);
        }
    }
}
