/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpType.H"
#include "sphereUnion.H"
#include "mathematicalConstants.H"

Foam::clumpType::clumpType(const word& name, const dictionary& dict)
:
    name_(name),
    family_(dict.getOrDefault<word>("classOf", name)),
    share_(getBetweenOrDefault(dict, "share", 1, 0, 1)),
    density_(getPositive(dict, "density")),
    smoothVolume_(0),
    fixed_(false),
    viscosityRatio_(1),
    halfWidth_(0)
{
    const auto geometry(clumpShapes::shape::New(getDict(dict, "shape")));
    const scalar scale = getPositiveOrDefault(dict, "scale", 1);
    centres_ = scale*geometry->centres();
    radii_ = scale*geometry->radii();
    pairs_ = geometry->bonds();
    if (geometry->triangles().size())
    {
        surface_.reset
        (
            new closedSurface(centres_, geometry->triangles(), dict)
        );
    }
    check(dict);

    const word motion(dict.getOrDefault<word>("motion", "free"));
    if (motion != "free" && motion != "fixed")
    {
        FatalIOErrorInLookup
        (
            dict, "motion", motion,
            (HashTable<label>({{"free", 0}, {"fixed", 1}}))
        )   << exit(FatalIOError);
    }
    fixed_ = motion == "fixed";

    if (hasSurface())
    {
        setSurfaceMasses();
        viscosityRatio_ = getBetweenOrDefault(dict, "viscosityRatio", 1, 0.01, 100);
    }
    else
    {
        setMasses(dict);
    }

    // With massModel fullSpheres the volume may underflow to zero
    nominalVolume_ =
        dict.found("nominalVolume")
      ? getPositive(dict, "nominalVolume") : volume_;

    reach_ = max(mag(centres_) + radii_);
    if (!hasSurface())
    {
        setTransitions();
    }
}


void Foam::clumpType::check(const dictionary& dict) const
{
    if (!hasSurface())
    {
        // The last four are those of clumpBonds
        checkEntries
        (
            dict,
            {
                "shape", "density", "massModel", "motion", "nominalVolume", "scale",
                "classOf", "share", "bondModel", "dampingModel", "conservationModel",
                "conservationModels"
            }
        );
        return;
    }

    for
    (
        const word key :
        {
            "bondModel", "dampingModel", "conservationModel",
            "conservationModels", "massModel"
        }
    )
    {
        if (dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "': the shape of the type is a surface, whose"
                << " nodes are held together by the entry 'membrane'."
                << exit(FatalIOError);
        }
    }

    // The last two are those of membraneMechanics and surfaceImmersion
    checkEntries
    (
        dict,
        {
            "shape", "density", "motion", "nominalVolume", "scale", "classOf",
            "share", "viscosityRatio", "membrane", "kernel"
        }
    );

    if (dict.getOrDefault<word>("motion", "free") == "fixed")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'motion': a membrane moves with the fluid and cannot be fixed."
            << exit(FatalIOError);
    }
}


void Foam::clumpType::setSurfaceMasses()
{
    volume_ = surface_->volume(centres_);
    const scalar area = surface_->area(centres_);
    const scalarField share(surface_->nodeAreas(centres_)/area);

    masses_ = density_*volume_*share;
    volumes_ = volume_*share;
    inertias_ = scalarField(size(), Zero);
    centres_ -= sum(share*centres_);
    smoothVolume_ = volume_;

    halfWidth_ = 3*volume_/area;
    dragRadii_ = 4*area*share/(3*constant::mathematical::pi*halfWidth_);
    bodyRadii_ = scalarField(size(), halfWidth_);
    transitions_ = radii_;
}


void Foam::clumpType::setMasses(const dictionary& dict)
{
    const word massModel(dict.getOrDefault<word>("massModel", "union"));

    volume_ = sphereUnion::volume(centres_, radii_);

    const scalarField cubes(pow3(radii_));
    const scalar spheres = constant::mathematical::pi*4.0/3.0*sum(cubes);

    scalar V = 0;
    if (massModel == "union")
    {
        V = volume_;
        if (!(V > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'shape': the spheres (radius " << min(radii_)
                << " m) are too small for their distance from the origin ("
                << max(mag(centres_)) << " m) to compute their volume."
                << exit(FatalIOError);
        }
    }
    else if (massModel == "fullSpheres")
    {
        V = spheres;
    }
    else
    {
        FatalIOErrorInLookup
        (
            dict, "massModel", massModel,
            (HashTable<label>({{"union", 0}, {"fullSpheres", 1}}))
        )   << exit(FatalIOError);
    }

    masses_ = density_*V*cubes/sum(cubes);
    volumes_ = volume_*cubes/sum(cubes);
    inertias_ = 0.4*masses_*sqr(radii_);
    dragRadii_ = radii_;
    bodyRadii_ = radii_;
    halfWidth_ = min(radii_);

    centres_ -= sum(masses_*centres_)/sum(masses_);
    vectorField grad(size());
    smoothVolume_ = sphereUnion::smoothVolume(centres_, radii_, grad);
}


void Foam::clumpType::setTransitions()
{
    transitions_ = radii_;
    forAll(radii_, i)
    {
        // Distance of the nearest centre over the sum of the radii
        scalar nearest = VGREAT;
        forAll(radii_, j)
        {
            if (j != i)
            {
                nearest = min
                (
                    nearest,
                    mag(centres_[i] - centres_[j])/(radii_[i] + radii_[j])
                );
            }
        }
        transitions_[i] *= min(max(2.5 - 2*nearest, 0.5), 1.0);
    }
}


Foam::scalar Foam::clumpType::relativeVolume(const pointField& x) const
{
    if (size() == 1)
    {
        return 1;
    }
    if (hasSurface())
    {
        return surface_->volume(x)/volume_;
    }
    vectorField grad(size());
    return sphereUnion::smoothVolume(x, radii_, grad)/smoothVolume_;
}


Foam::scalarField Foam::clumpType::excessMasses
(
    const scalar rho,
    const pointField& x
) const
{
    const scalarField excess(masses_ - rho*volumes_*relativeVolume(x));
    return
        nominalVolume_ == volume_
      ? excess : scalarField(nominalVolume_/max(volume_, VSMALL)*excess);
}
