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
    density_(getPositive(dict, "density")),
    restVolume_(0),
    fixed_(false)
{
    checkEntries
    (
        dict,
        {
            "shape", "density", "massModel", "motion", "nominalVolume",
            "bondModel", "dampingModel", "conservationModel",
            "conservationModels"
        }
    );

    const auto geometry(clumpShapes::shape::New(getDict(dict, "shape")));
    centres_ = geometry->centres();
    radii_ = geometry->radii();

    const word motion(dict.get<word>("motion"));
    if (motion != "free" && motion != "fixed")
    {
        FatalIOErrorInLookup
        (
            dict, "motion", motion,
            (HashTable<label>({{"free", 0}, {"fixed", 1}}))
        )   << exit(FatalIOError);
    }
    fixed_ = motion == "fixed";

    setMasses(dict);

    // That of spheres far too small may be zero, with massModel fullSpheres
    nominalVolume_ =
        dict.found("nominalVolume")
      ? getPositive(dict, "nominalVolume") : volume_;

    reach_ = max(mag(centres_) + radii_);

    setBonds(geometry->bonds(), dict);

    setConservation(dict);
}


void Foam::clumpType::setConservation(const dictionary& dict)
{
    const auto add = [&](const dictionary& d)
    {
        auto model(selectModel<conservationModel>(d, centres_, radii_));
        if (model->active())
        {
            conservation_.append(model.ptr());
        }
    };

    if (dict.found("conservationModel"))
    {
        if (dict.found("conservationModels"))
        {
            FatalIOErrorInFunction(dict)
                << "Give either conservationModel or conservationModels"
                << exit(FatalIOError);
        }
        add(getDict(dict, "conservationModel"));
    }
    else if (dict.found("conservationModels"))
    {
        const dictionary& models = getDict(dict, "conservationModels");
        for (const word& name : models.toc())
        {
            add(getDict(models, name));
        }
    }
}


void Foam::clumpType::setMasses(const dictionary& dict)
{
    const word massModel(dict.get<word>("massModel"));

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
                << "Entry 'shape': spheres of " << min(radii_) << " m, up to "
                << max(mag(centres_)) << " m from the origin, are too small for"
                << " their volume to be told from zero" << exit(FatalIOError);
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

    centres_ -= sum(masses_*centres_)/sum(masses_);
    vectorField grad(size());
    restVolume_ = sphereUnion::volume(centres_, radii_, grad);
}


Foam::scalar Foam::clumpType::relativeVolume(const pointField& x) const
{
    if (size() == 1)
    {
        return 1;
    }
    vectorField grad(size());
    return sphereUnion::volume(x, radii_, grad)/restVolume_;
}


void Foam::clumpType::setBonds
(
    const List<labelPair>& pairs,
    const dictionary& dict
)
{
    pattern_ = sparsityPattern(size(), pairs);

    if (pairs.empty())
    {
        return;
    }

    bondModel_ = selectModel<bondModel>(getDict(dict, "bondModel"));
    dampingModel_ = selectModel<dampingModel>(getDict(dict, "dampingModel"));

    bonds_.setSize(pairs.size());

    forAll(pairs, b)
    {
        const label i = pairs[b].first();
        const label j = pairs[b].second();
        const vector d(centres_[j] - centres_[i]);
        const scalar length = mag(d);

        if (length < SMALL*max(radii_[i], radii_[j]))
        {
            FatalIOErrorInFunction(dict)
                << "Bond " << b << " joins spheres " << i << " and " << j
                << " at the same place" << exit(FatalIOError);
        }

        const bondCoefficients k
        (
            bondModel_->stiffness(length, 0.5*(radii_[i] + radii_[j]))
        );

        bonds_[b] =
        {
            i, j, d/length, length, k,
            dampingModel_->coefficients
            (
                k,
                0.5*(masses_[i] + masses_[j]),
                0.5*(inertias_[i] + inertias_[j])
            ),
            0.5*(radii_[i] + radii_[j])
        };
    }
}
