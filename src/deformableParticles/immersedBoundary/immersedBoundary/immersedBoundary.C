/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "immersedBoundary.H"
#include "sphereUnion.H"
#include "fvmSup.H"
#include "zeroGradientFvPatchFields.H"

Foam::immersedBoundary::immersedBoundary
(
    const fvMesh& mesh,
    const PtrList<clumpType>& types,
    const dictionary& dict
)
:
    mesh_(mesh),
    types_(types),
    solidFractionModel_
    (
        selectModel<solidFractionModel>(dict.subDict("solidFraction"))
    ),
    forcingModel_(selectModel<forcingModel>(dict.subDict("forcing"))),
    forceModel_
    (
        selectModel<hydrodynamicForceModel>(dict.subDict("hydrodynamicForce"))
    ),
    dilates_(dict.get<bool>("interiorDilation")),
    solidFraction_
    (
        IOobject
        (
            "solidFraction", mesh.time().timeName(), mesh,
            IOobject::NO_READ, IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    solidVelocity_
    (
        IOobject("solidVelocity", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero)
    ),
    strength_
    (
        IOobject("forcingStrength", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero)
    ),
    dilation_
    (
        IOobject("interiorDilation", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero)
    ),
    closed_(false),
    meshChanged_(false)
{
    setReaches();
}


void Foam::immersedBoundary::setReaches()
{
    cellWidth_ = Foam::cbrt(mesh_.V().field());
    cellWidths_ = symmTensorField(mesh_.nCells(), Zero);
    cellReach_ = scalarField(mesh_.nCells(), Zero);
    sumLambda_ = scalarField(mesh_.nCells(), Zero);
    sumRadius_ = scalarField(mesh_.nCells(), Zero);
    sumNormal_ = vectorField(mesh_.nCells(), Zero);

    const labelListList& cellPoints = mesh_.cellPoints();
    forAll(cellReach_, celli)
    {
        for (const label pointi : cellPoints[celli])
        {
            const vector y(mesh_.points()[pointi] - mesh_.cellCentres()[celli]);
            cellReach_[celli] = max(cellReach_[celli], mag(y));
            cellWidths_[celli] += 4*sqr(y)/cellPoints[celli].size();
        }
    }

    largestReach_ = cellReach_.empty() ? 0 : max(cellReach_);

    // Demand-driven, made by all processors together
    mesh_.tetBasePtIs();

    // Cells are found by their centres
    const treeBoundBox box(mesh_.cellCentres());
    tree_.reset
    (
        new indexedOctree<treeDataPoint>
        (
            treeDataPoint(mesh_.cellCentres()),
            treeBoundBox
            (
                box.min() - 1e-4*mag(box.span())*vector::one,
                box.max() + 1e-4*mag(box.span())*vector::one
            ),
            10,
            10,
            1
        )
    );
}


void Foam::immersedBoundary::findCover
(
    const clumpImage& image,
    cover& c
) const
{
    const clumpType& type = types_[image.typeId];
    const scalar smallest = min(type.radii());
    DynamicList<point> nearCentres;
    DynamicList<scalar> nearRadii;

    const vector margin(largestReach_*vector::one);
    const treeBoundBox box(image.box.min() - margin, image.box.max() + margin);

    for (const label celli : tree_->findBox(box))
    {
        const point& x = mesh_.cellCentres()[celli];
        const scalar reach = cellReach_[celli];
        if (magSqr(x - image.box.nearest(x)) > sqr(reach))
        {
            continue;
        }
        const scalar d = sphereUnion::distance(x, image.x, type.radii());

        if (d > reach)
        {
            continue;
        }

        scalar lambda = 1;
        if (d > -reach)
        {
            nearCentres.clear();
            nearRadii.clear();
            forAll(image.x, i)
            {
                // The others do not reach into the cell
                if (mag(x - image.x[i]) < type.radii()[i] + reach)
                {
                    nearCentres.append(image.x[i]);
                    nearRadii.append(type.radii()[i]);
                }
            }
            lambda = solidFractionModel_->fraction
            (
                mesh_, celli, d, nearCentres, nearRadii
            );
        }

        if (lambda > SMALL)
        {
            const scalar dx = cellWidth_[celli];
            if (smallest < 0.999*dx)
            {
                FatalErrorInFunction
                    << "Clump type " << type.name() << ": the sphere radius "
                    << smallest << " at " << image.x[0] << " is below the "
                    << "cell width " << dx << " (D/dx = " << 2*smallest/dx
                    << "): refine the mesh until D/dx is 2 at least, 4 for "
                    << "accuracy" << exit(FatalError);
            }
            c.cells.append(celli);
            c.lambda.append(lambda);
        }
    }
}


void Foam::immersedBoundary::setWeights
(
    const clumpImage& image,
    cover& c
) const
{
    const clumpType& type = types_[image.typeId];
    const label n = type.size();

    c.weights.setSize(n*c.cells.size());
    c.gradWeights.setSize(n*c.cells.size());
    scalarField exponent(n);

    forAll(c.cells, k)
    {
        const point& x = mesh_.cellCentres()[c.cells[k]];
        scalar* w = &c.weights[n*k];
        vector* gradW = &c.gradWeights[n*k];

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


Foam::scalar Foam::immersedBoundary::widthAcross(const label celli) const
{
    const vector n(sumNormal_[celli]/sumLambda_[celli]);
    return Foam::sqrt
    (
        (n & (cellWidths_[celli] & n)) + (1 - magSqr(n))*sqr(cellWidth_[celli])
    );
}


void Foam::immersedBoundary::clearCovered()
{
    for (const cover& c : covers_)
    {
        for (const label celli : c.cells)
        {
            solidFraction_[celli] = 0;
            solidVelocity_[celli] = Zero;
            strength_[celli] = 0;
            sumLambda_[celli] = 0;
            sumRadius_[celli] = 0;
            sumNormal_[celli] = Zero;
        }
    }
}


void Foam::immersedBoundary::checkResolution
(
    const UList<clumpImage>& images
) const
{
    for (const clumpImage& image : images)
    {
        cover c;
        findCover(image, c);
    }
}


void Foam::immersedBoundary::update
(
    const UList<clumpImage>& images,
    const volScalarField& nu,
    const bool closed
)
{
    closed_ = closed;
    if (meshChanged_)
    {
        // The fields were mapped with the mesh: every cell may hold a rest
        meshChanged_ = false;
        solidFraction_ = dimensionedScalar(dimless, Zero);
        solidVelocity_ = dimensionedVector(dimVelocity, Zero);
        strength_ = dimensionedScalar(dimless/dimTime, Zero);
    }
    else
    {
        clearCovered();
    }
    covers_ = List<cover>(images.size());

    forAll(images, a)
    {
        cover& c = covers_[a];
        findCover(images[a], c);
        setWeights(images[a], c);

        const scalarField& radii = types_[images[a].typeId].radii();
        const label n = radii.size();

        forAll(c.cells, k)
        {
            const label celli = c.cells[k];
            sumLambda_[celli] += c.lambda[k];
            for (label i = 0; i < n; ++i)
            {
                const scalar share = c.lambda[k]*c.weights[n*k + i];
                const vector y(mesh_.cellCentres()[celli] - images[a].x[i]);
                sumRadius_[celli] += share*radii[i];
                sumNormal_[celli] += share*y/max(mag(y), SMALL*radii[i]);
            }
        }
    }

    const scalar dt = mesh_.time().deltaTValue();

    for (const cover& c : covers_)
    {
        for (const label celli : c.cells)
        {
            solidFraction_[celli] = min(sumLambda_[celli], scalar(1));
            strength_[celli] = forcingModel_->strength
            (
                solidFraction_[celli],
                dt,
                nu[celli],
                widthAcross(celli),
                sumRadius_[celli]/sumLambda_[celli]
            );
        }
    }

    impose(images);
}


void Foam::immersedBoundary::meshChanged()
{
    // At once: the tree refers to the cell centres, which are others now
    meshChanged_ = true;
    setReaches();
}


void Foam::immersedBoundary::setCloseness(const UList<clumpImage>& images)
{
    if (!closeness_.valid())
    {
        closeness_.reset
        (
            new volScalarField
            (
                IOobject("clumpCloseness", mesh_.time().timeName(), mesh_),
                mesh_,
                dimensionedScalar(dimless, Zero)
            )
        );
    }

    scalarField& closeness = closeness_->primitiveFieldRef();
    closeness = 0;

    for (const clumpImage& image : images)
    {
        const scalarField& radii = types_[image.typeId].radii();
        const scalar r = min(radii);

        treeBoundBox box(image.box);
        box.min() -= r*vector::one;
        box.max() += r*vector::one;

        for (const label celli : tree_->findBox(box))
        {
            const scalar d = sphereUnion::distance
            (
                mesh_.cellCentres()[celli], image.x, radii
            );
            closeness[celli] = max(closeness[celli], 1 - d/r);
        }
    }
}


void Foam::immersedBoundary::impose(const UList<clumpImage>& images)
{
    for (const cover& c : covers_)
    {
        for (const label celli : c.cells)
        {
            solidVelocity_[celli] = Zero;
        }
    }
    if (dilates_)
    {
        dilation_ = dimensionedScalar(dilation_.dimensions(), Zero);
    }

    forAll(images, a)
    {
        const clumpImage& image = images[a];
        const cover& c = covers_[a];
        const label n = image.x.size();

        forAll(c.cells, k)
        {
            const label celli = c.cells[k];
            const point& x = mesh_.cellCentres()[celli];
            const scalar share = c.lambda[k]/sumLambda_[celli];

            for (label i = 0; i < n; ++i)
            {
                const vector u(image.u[i] + (image.spin[i] ^ (x - image.x[i])));
                solidVelocity_[celli] += share*c.weights[n*k + i]*u;

                if (dilates_)
                {
                    dilation_[celli] +=
                        solidFraction_[celli]*share
                       *(c.gradWeights[n*k + i] & u);
                }
            }
        }
    }

    if (dilates_ && closed_)
    {
        dilation_.primitiveFieldRef() -=
            gSum(mesh_.V()*dilation_.primitiveField())/gSum(mesh_.V());
    }
}


Foam::tmp<Foam::fvVectorMatrix> Foam::immersedBoundary::forcing
(
    const volVectorField& U
) const
{
    return strength_*solidVelocity_ - fvm::Sp(strength_, U);
}


void Foam::immersedBoundary::integrate
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu,
    const scalar rho,
    UList<clumpImage>& images
)
{
    const hydrodynamicForceModel::flow flow
    {
        U, p, nu, rho, solidFraction_, solidVelocity_, strength_
    };
    forceModel_->prepare(flow);

    const scalar pMean =
        dilates_ && closed_
      ? gSum(mesh_.V()*p.primitiveField())/gSum(mesh_.V())
      : 0;

    forAll(images, a)
    {
        clumpImage& image = images[a];
        const cover& c = covers_[a];
        const label n = image.x.size();

        image.force = Zero;
        image.torque = Zero;

        forAll(c.cells, k)
        {
            const label celli = c.cells[k];
            const point& x = mesh_.cellCentres()[celli];
            const scalar share = c.lambda[k]/sumLambda_[celli];
            const scalar V = mesh_.V()[celli];
            const vector F(V*share*(*forceModel_)(flow, celli));
            const scalar P =
                dilates_
              ? V*share*solidFraction_[celli]*rho*(p[celli] - pMean)
              : 0;

            for (label i = 0; i < n; ++i)
            {
                const vector g
                (
                    c.weights[n*k + i]*F - P*c.gradWeights[n*k + i]
                );
                image.force[i] += g;
                image.torque[i] += (x - image.x[i]) ^ g;
            }
        }
    }
}


Foam::vector Foam::immersedBoundary::forceOnFluid
(
    const volVectorField& U,
    const scalar rho
) const
{
    return gSum
    (
        rho*mesh_.V()*strength_.primitiveField()
       *(solidVelocity_.primitiveField() - U.primitiveField())
    );
}
