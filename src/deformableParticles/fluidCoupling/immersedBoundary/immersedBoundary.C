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
        selectModel<solidFractionModel>(getDict(dict, "solidFraction"))
    ),
    forcingModel_(selectModel<forcingModel>(getDict(dict, "forcing"))),
    forceModel_
    (
        selectModel<hydrodynamicForceModel>(getDict(dict, "hydrodynamicForce"))
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
    geometry_(mesh),
    meshChanged_(false)
{
    checkEntries
    (
        dict,
        {"solidFraction", "forcing", "hydrodynamicForce", "interiorDilation"}
    );
    allocate();
}


void Foam::immersedBoundary::allocate()
{
    const label n = mesh_.nCells();
    sumLambda_ = scalarField(n, Zero);
    sumShare_ = scalarField(n, Zero);
    sumRadius_ = scalarField(n, Zero);
    sumNormal_ = vectorField(n, Zero);
}


Foam::scalar Foam::immersedBoundary::solidPart
(
    const coveredCells& c,
    const label k
) const
{
    const label celli = c.cells[k];
    return
        solidFraction_[celli]*c.lambda[k]/max(sumLambda_[celli], VSMALL);
}


void Foam::immersedBoundary::clearCovered()
{
    for (const coveredCells& c : covers_)
    {
        for (const label celli : c.cells)
        {
            solidFraction_[celli] = 0;
            solidVelocity_[celli] = Zero;
            strength_[celli] = 0;
            sumLambda_[celli] = 0;
            sumShare_[celli] = 0;
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
        coveredCells c;
        c.find
        (
            geometry_, *solidFractionModel_, *forcingModel_,
            types_[image.typeId], image
        );
    }
}


void Foam::immersedBoundary::addFractions
(
    const clumpImage& image,
    const coveredCells& c
)
{
    const scalarField& radii = types_[image.typeId].radii();
    const label n = radii.size();

    forAll(c.cells, k)
    {
        const label celli = c.cells[k];
        sumLambda_[celli] += c.lambda[k];
        solidFraction_[celli] = min(sumLambda_[celli], scalar(1));

        // Radius and normal of a smeared surface
        for (label i = 0; i < n && !forcingModel_->usesDistance(); ++i)
        {
            const scalar part = c.lambda[k]*c.weights[n*k + i];
            const vector y(mesh_.cellCentres()[celli] - image.x[i]);
            sumRadius_[celli] += part*radii[i];
            sumNormal_[celli] += part*y/max(mag(y), SMALL*radii[i]);
        }
    }
}


void Foam::immersedBoundary::setStrengths
(
    const UList<clumpImage>& images,
    const volScalarField& nu
)
{
    const bool usesDistance = forcingModel_->usesDistance();
    const scalar dt = mesh_.time().deltaTValue();

    forAll(images, a)
    {
        coveredCells& c = covers_[a];
        const scalarField& radii = types_[images[a].typeId].radii();
        const label n = radii.size();

        forAll(c.cells, k)
        {
            const label celli = c.cells[k];
            forcingModel::cell cell
            {
                solidFraction_[celli], dt, nu[celli], geometry_.width(celli),
                0, c.distance[k], c.wallConductance[k]
            };

            if (usesDistance)
            {
                for (label i = 0; i < n; ++i)
                {
                    cell.radius += c.weights[n*k + i]*radii[i];
                }
                c.share[k] = forcingModel_->strength(cell);
                strength_[celli] += c.share[k];
            }
            else
            {
                const scalar sum = sumLambda_[celli];
                cell.radius = sumRadius_[celli]/sum;
                cell.dx = geometry_.widthAlong(celli, sumNormal_[celli]/sum);
                strength_[celli] = forcingModel_->strength(cell);
            }
            sumShare_[celli] += c.share[k];
        }
    }
}


void Foam::immersedBoundary::update
(
    UList<clumpImage>& images,
    const volScalarField& nu
)
{
    if (meshChanged_)
    {
        // The fields were mapped with the mesh: every cell may hold a rest
        meshChanged_ = false;
        solidFraction_ = dimensionedScalar(dimless, Zero);
        solidVelocity_ = dimensionedVector(dimVelocity, Zero);
        strength_ = dimensionedScalar(dimless/dimTime, Zero);
        covers_.clear();
    }
    else
    {
        clearCovered();
    }
    covers_.setSize(images.size());

    forAll(images, a)
    {
        coveredCells& c = covers_[a];
        if (!c.covers(images[a]))
        {
            const clumpType& type = types_[images[a].typeId];
            c = coveredCells();
            c.find
            (
                geometry_, *solidFractionModel_, *forcingModel_, type,
                images[a]
            );
            c.setWeights(geometry_.mesh(), type, images[a]);
        }
        addFractions(images[a], c);
    }
    setStrengths(images, nu);
    if (dilates_)
    {
        setDilations(images);
    }
}


void Foam::immersedBoundary::setDilations(UList<clumpImage>& images) const
{
    forAll(images, a)
    {
        clumpImage& image = images[a];
        const coveredCells& c = covers_[a];
        const label n = image.x.size();

        forAll(c.cells, k)
        {
            const label celli = c.cells[k];
            const point& x = mesh_.cellCentres()[celli];
            const scalar V = mesh_.V()[celli]*solidPart(c, k);

            for (label i = 0; i < n; ++i)
            {
                const vector g(V*c.gradWeights[n*k + i]);
                image.dilation.g[i] += g;
                image.dilation.h[i] += (x - image.x[i]) ^ g;
            }
        }
    }
}


void Foam::immersedBoundary::sampleVelocity
(
    const volVectorField& U,
    UList<clumpImage>& images
) const
{
    forAll(images, a)
    {
        clumpImage& image = images[a];
        const coveredCells& c = covers_[a];
        const label n = image.x.size();

        forAll(c.cells, k)
        {
            const label celli = c.cells[k];
            const scalar V = mesh_.V()[celli]*solidPart(c, k);

            for (label i = 0; i < n; ++i)
            {
                image.force[i] += V*c.weights[n*k + i]*U[celli];
                image.torque[i] += V*c.weights[n*k + i]*vector::one;
            }
        }
    }
}


void Foam::immersedBoundary::meshChanged()
{
    // At once: the tree refers to the cell centres, which are others now
    meshChanged_ = true;
    geometry_.update();
    allocate();
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

        boundBox box(image.box);
        box.min() -= r*vector::one;
        box.max() += r*vector::one;

        for (const label celli : geometry_.find(box, 0))
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
    for (const coveredCells& c : covers_)
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
        const coveredCells& c = covers_[a];
        const label n = image.x.size();

        forAll(c.cells, k)
        {
            const label celli = c.cells[k];
            const point& x = mesh_.cellCentres()[celli];
            const scalar share = c.share[k]/max(sumShare_[celli], VSMALL);
            const scalar part = solidPart(c, k);

            for (label i = 0; i < n; ++i)
            {
                const vector u(image.u[i] + (image.omega[i] ^ (x - image.x[i])));
                solidVelocity_[celli] += share*c.weights[n*k + i]*u;

                if (dilates_)
                {
                    dilation_[celli] += part*(c.gradWeights[n*k + i] & u);
                }
            }
        }
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

    forAll(images, a)
    {
        clumpImage& image = images[a];
        const coveredCells& c = covers_[a];
        const label n = image.x.size();

        image.force = Zero;
        image.torque = Zero;

        forAll(c.cells, k)
        {
            const label celli = c.cells[k];
            const point& x = mesh_.cellCentres()[celli];
            const scalar share = c.share[k]/max(sumShare_[celli], VSMALL);
            const scalar V = mesh_.V()[celli];
            const vector F(V*share*(*forceModel_)(flow, celli));
            const scalar P =
                dilates_
              ? V*solidPart(c, k)*rho*p[celli]
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
