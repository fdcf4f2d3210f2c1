/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "immersedBoundary.H"
#include "foamCompat.H"
#include "sphereUnion.H"
#include "fvmSup.H"
#include "zeroGradientFvPatchFields.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- Radius [m] of a sphere of the volume of a clump
scalar volumeRadius(const clumpType& type)
{
    return Foam::cbrt(0.75*type.volume()/constant::mathematical::pi);
}

}

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
    dilates_(dict.getOrDefault("interiorDilation", true)),
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
    meshChanged_(false),
    follows_(true)
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
    nForcing_ = labelList(n, Zero);
    sumForcingWeights_ = scalarField(n, Zero);
    sumFriction_ = scalarField(n, Zero);
    frictionVelocity_ = vectorField(n, Zero);
}


void Foam::immersedBoundary::clearCovered()
{
    for (const coveredCells& c : covered_)
    {
        for (const coveredCell& cell : c.cells())
        {
            const label celli = cell.celli;
            solidFraction_[celli] = 0;
            solidVelocity_[celli] = Zero;
            strength_[celli] = 0;
            dilation_[celli] = 0;
            sumLambda_[celli] = 0;
            nForcing_[celli] = 0;
            sumForcingWeights_[celli] = 0;
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
        coveredBy(image);
    }
}


Foam::coveredCells Foam::immersedBoundary::coveredBy(const clumpImage& image) const
{
    coveredCells result;
    if (types_[image.typeId].ofSpheres())
    {
        result.update
        (
            geometry_, *solidFractionModel_, *forcingModel_,
            types_[image.typeId], image
        );
    }
    return result;
}


void Foam::immersedBoundary::addFractions(const coveredCells& c)
{
    for (const coveredCell& cell : c.cells())
    {
        scalar& sum = sumLambda_[cell.celli];
        sum += c.fadeFactor()*cell.lambda;
        solidFraction_[cell.celli] = min(sum, scalar(1));
        nForcing_[cell.celli] += cell.forced();
    }
}


void Foam::immersedBoundary::setSqueezed()
{
    for (coveredCells& c : covered_)
    {
        for (coveredCell& cell : c.cells())
        {
            cell.squeezed =
                nForcing_[cell.celli] > 1 || geometry_[cell.celli].atWall;
        }
    }
}


void Foam::immersedBoundary::setStrengths(const volScalarField& nu)
{
    for (coveredCells& c : covered_)
    {
        forcingModel_->setStrength
        (
            geometry_,
            types_[c.typeId()].radii(),
            solidFraction_,
            nu,
            mesh_.time().deltaTValue(),
            follows_,
            c,
            strength_
        );
        for (coveredCell& cell : c.cells())
        {
            const label celli = cell.celli;
            sumForcingWeights_[celli] += cell.forcingWeight;
            cell.solid =
                solidFraction_[celli]*c.fadeFactor()*cell.lambda
               /max(sumLambda_[celli], VSMALL);
        }
    }
}


void Foam::immersedBoundary::fade(const volScalarField& nu)
{
    bool whole = true;
    for (const coveredCells& c : covered_)
    {
        whole = whole && (c.fadeFactor() == 1 || c.cells().empty());
    }
    if (whole)
    {
        return;
    }

    // Weights become strengths, which add up
    for (coveredCells& c : covered_)
    {
        const scalar phi = c.fadeFactor();
        const scalar kappa = 4.5/sqr(volumeRadius(types_[c.typeId()]));
        for (coveredCell& cell : c.cells())
        {
            const label celli = cell.celli;
            const scalar S =
                strength_[celli]*cell.forcingWeight
               /max(sumForcingWeights_[celli], VSMALL);
            const scalar porous = phi*kappa*nu[celli];
            cell.forcingWeight =
                S*porous/(porous + (1 - phi)*S)
               *(cell.lambda + (1 - cell.lambda)*pow4(phi));
        }
    }
    for (const coveredCells& c : covered_)
    {
        for (const coveredCell& cell : c.cells())
        {
            strength_[cell.celli] = 0;
        }
    }
    for (const coveredCells& c : covered_)
    {
        for (const coveredCell& cell : c.cells())
        {
            strength_[cell.celli] += cell.forcingWeight;
            sumForcingWeights_[cell.celli] = strength_[cell.celli];
        }
    }
}


void Foam::immersedBoundary::setFriction(const volScalarField& nu)
{
    for (coveredCells& c : covered_)
    {
        for (coveredCell& cell : c.cells())
        {
            const label celli = cell.celli;
            const scalar fraction =
                cell.forcingWeight/max(sumForcingWeights_[celli], VSMALL);
            cell.friction =
                fraction < 1
              ? min
                (
                    fraction*strength_[celli],
                    4*nu[celli]/sqr(geometry_[celli].width)
                )
              : 0;
        }
    }
}


void Foam::immersedBoundary::setForcing(const volScalarField& nu)
{
    for (const coveredCells& c : covered_)
    {
        for (const coveredCell& cell : c.cells())
        {
            strength_[cell.celli] = 0;
            sumForcingWeights_[cell.celli] = 0;
        }
    }
    setStrengths(nu);
    fade(nu);
    setFriction(nu);
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
        dilation_ = dimensionedScalar(dimless/dimTime, Zero);
        covered_.clearStorage();
    }
    else
    {
        clearCovered();
    }
    covered_.setSize(images.size());

    forAll(images, a)
    {
        if (!types_[images[a].typeId].ofSpheres())
        {
            covered_[a].clear(images[a].typeId);
            continue;
        }
        covered_[a].update
        (
            geometry_, *solidFractionModel_, *forcingModel_,
            types_[images[a].typeId], images[a]
        );
        addFractions(covered_[a]);
    }
    setSqueezed();
    setForcing(nu);
    setSolidVolumes(images);
    if (dilates_)
    {
        setConstraints(images);
    }
}


void Foam::immersedBoundary::meshChanged()
{
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
        const scalar r = types_[image.typeId].halfWidth();

        for (const label celli : geometry_.find(grown(image.box, r), 0))
        {
            const scalar d = sphereUnion::distance
            (
                mesh_.cellCentres()[celli], image.x, radii
            );
            closeness[celli] = max(closeness[celli], 1 - d/r);
        }
    }
}
