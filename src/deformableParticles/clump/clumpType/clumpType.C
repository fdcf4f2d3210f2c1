/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpType.H"
#include "massDistribution.H"
#include "sphereUnion.H"
#include "mathematicalConstants.H"
#include <Eigen/Eigenvalues>

namespace
{

using namespace Foam;

//- Ascending numbers in words: 0-3+7
word ranges(const labelUList& numbers)
{
    string result;
    for (label from = 0; from < numbers.size(); )
    {
        label to = from;
        while (to + 1 < numbers.size() && numbers[to + 1] == numbers[to] + 1)
        {
            ++to;
        }
        result += (from ? "+" : "") + Foam::name(numbers[from]);
        if (to > from)
        {
            result += '-' + Foam::name(numbers[to]);
        }
        from = to + 1;
    }
    return word(result, false);
}

//- The entry inertia: the moments about the axes of the shape, or all six components
symmTensor givenInertia(const dictionary& dict)
{
    const List<scalar> v(getFiniteList<scalar>(dict, "inertia"));
    if (v.size() != 3 && v.size() != 6)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'inertia' has " << v.size() << " numbers; give the three moments"
            << " of inertia about the axes of the shape, (xx yy zz), or the tensor (xx"
            << " xy xz yy yz zz), in kg m2." << exit(FatalIOError);
    }
    const symmTensor J
    (
        v.size() == 3
      ? symmTensor(v[0], 0, 0, v[1], 0, v[2])
      : symmTensor(v[0], v[1], v[2], v[3], v[4], v[5])
    );
    const scalar size = max(mag(J.xx()), max(mag(J.yy()), mag(J.zz())));
    Eigen::Vector3d p(Eigen::Vector3d::Constant(-1));
    if (size >= smallestEntry)
    {
        const symmTensor j(J/size);
        Eigen::Matrix3d m;
        m << j.xx(), j.xy(), j.xz(), j.xy(), j.yy(), j.yz(), j.xz(), j.yz(), j.zz();
        p = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>
        (
            m, Eigen::EigenvaluesOnly
        ).eigenvalues();
    }
    if (!(p[0] > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'inertia' is " << v << "; the moments of inertia of a body are"
            << " above zero about every axis [kg m2]." << exit(FatalIOError);
    }
    if (!(p[2] <= (1 + 1e-6)*(p[0] + p[1])))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'inertia' has the principal moments " << size*p[0] << ", "
            << size*p[1] << " and " << size*p[2] << " kg m2. None can exceed the sum of"
            << " the others: no body has such moments." << exit(FatalIOError);
    }
    return J;
}

}


Foam::clumpType::clumpType(const word& name, const dictionary& dict)
:
    name_(name),
    family_(dict.getOrDefault<word>("classOf", name)),
    share_(getBetweenOrDefault(dict, "share", 1, 0, 1)),
    gyration_(0.4),
    smoothVolume_(0),
    fixed_(false),
    viscosityRatio_(1),
    halfWidth_(0),
    whole_(-1),
    part_(1)
{
    const auto geometry(clumpShapes::shape::New(getDict(dict, "shape")));
    kind_ = geometry->kind();
    const scalar scale = getPositiveOrDefault(dict, "scale", 1);
    centres_ = scale*geometry->centres();
    radii_ = scale*geometry->radii();
    pairs_ = geometry->bonds();
    if (geometry->triangles().size())
    {
        // Further centres are those of nodes inside
        label last = 0;
        for (const triFace& t : geometry->triangles())
        {
            last = max(last, max(t[0], max(t[1], t[2])));
        }
        const pointField nodes
        (
            SubField<point>(centres_, min(last + 1, centres_.size()))
        );
        surface_.reset(new closedSurface(nodes, geometry->triangles(), dict));
    }
    if (ofSpheres())
    {
        // The last four are those of clumpBonds
        checkEntries
        (
            dict,
            {
                "shape", "density", "massModel", "mass", "inertia", "motion",
                "nominalVolume", "scale", "classOf", "share", "bondModel",
                "dampingModel", "conservationModel", "conservationModels"
            }
        );
    }

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

    if (hasTriangles())
    {
        setSurfaceMasses(getPositive(dict, "density"));
        viscosityRatio_ = getBetweenOrDefault(dict, "viscosityRatio", 1, 0.01, 100);
    }
    else
    {
        bodyMoments moments(geometry->moments());
        moments.scale(scale);
        setMasses(dict, moments);
    }

    // With massModel fullSpheres the volume may underflow to zero
    nominalVolume_ =
        dict.found("nominalVolume")
      ? getPositive(dict, "nominalVolume") : volume_;

    reach_ = max(mag(centres_) + radii_);
    if (ofSpheres())
    {
        setTransitions();
    }
}


Foam::clumpType::clumpType
(
    const clumpType& whole,
    const label wholeType,
    const labelUList& spheres
)
:
    name_(whole.name_ + '.' + ranges(spheres)),
    family_(whole.family_),
    share_(0),
    kind_(whole.kind_),
    centres_(whole.centres_, spheres),
    radii_(whole.radii_, spheres),
    gyration_(whole.gyration_),
    masses_(whole.masses_, spheres),
    inertias_(whole.inertias_, spheres),
    volumes_(whole.volumes_, spheres),
    fixed_(whole.fixed_),
    viscosityRatio_(1),
    dragRadii_(whole.dragRadii_, spheres),
    bodyRadii_(whole.bodyRadii_, spheres),
    halfWidth_(min(radii_)),
    whole_(wholeType),
    spheres_(spheres)
{
    for (const label b : bondsOf(whole))
    {
        pairs_.append
        (
            labelPair(sphere(whole.pairs_[b].first()), sphere(whole.pairs_[b].second()))
        );
    }
    volume_ = sum(volumes_);
    part_ = volume_/max(whole.volume_, VSMALL);
    nominalVolume_ =
        whole.nominalVolume_ == whole.volume_
      ? volume_ : whole.nominalRatio()*volume_;

    centres_ -= sum(masses_*centres_)/sum(masses_);
    reach_ = max(mag(centres_) + radii_);
    vectorField grad(size());
    smoothVolume_ = sphereUnion::smoothVolume(centres_, radii_, grad);
    setTransitions();
}


Foam::labelList Foam::clumpType::bondsOf(const clumpType& whole) const
{
    DynamicList<label> result;
    forAll(whole.pairs_, b)
    {
        if
        (
            sphere(whole.numberInWhole(whole.pairs_[b].first())) >= 0
         && sphere(whole.numberInWhole(whole.pairs_[b].second())) >= 0
        )
        {
            result.append(b);
        }
    }
    return labelList(result);
}


void Foam::clumpType::setSurfaceMasses(const scalar density)
{
    volume_ = surface_->volume(centres_);
    const scalar area = surface_->area(centres_);
    const scalarField fractions(surface_->nodeAreas(centres_)/area);

    masses_ = density*volume_*fractions;
    volumes_ = volume_*fractions;
    inertias_ = scalarField(size(), Zero);
    centres_ -= sum(fractions*centres_);
    smoothVolume_ = volume_;

    halfWidth_ = 3*volume_/area;
    dragRadii_ = 4*area*fractions/(3*constant::mathematical::pi*halfWidth_);

    // A node inside has the resistance of an area: its share of the volume over R
    for (label i = surface_->nNodes(); i < size(); ++i)
    {
        dragRadii_[i] =
            4*volume_/(3*constant::mathematical::pi*size()*sqr(halfWidth_));
    }
    bodyRadii_ = scalarField(size(), halfWidth_);
    transitions_ = radii_;
}


Foam::scalar Foam::clumpType::givenMass
(
    const dictionary& dict,
    const scalar spheres
) const
{
    const word massModel(dict.getOrDefault<word>("massModel", "union"));
    if (massModel != "union" && massModel != "fullSpheres")
    {
        FatalIOErrorInLookup
        (
            dict, "massModel", massModel,
            (HashTable<label>({{"union", 0}, {"fullSpheres", 1}}))
        )   << exit(FatalIOError);
    }
    if (dict.found("mass"))
    {
        for (const word key : {"density", "massModel", "nominalVolume"})
        {
            if (dict.found(key))
            {
                FatalIOErrorInFunction(dict)
                    << "Entries 'mass' and '" << key << "': the mass of a clump that"
                    << " has the entry 'mass' does not follow from anything else. Remove"
                    << " one of them." << exit(FatalIOError);
            }
        }
    }
    const bool full = massModel == "fullSpheres";
    if (!full && !(volume_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shape': the spheres (radius " << min(radii_)
            << " m) are too small for their distance from the origin ("
            << max(mag(centres_)) << " m) to compute their volume."
            << exit(FatalIOError);
    }
    return
        dict.found("mass")
      ? getPositive(dict, "mass")
      : getPositive(dict, "density")*(full ? spheres : volume_);
}


void Foam::clumpType::setMasses
(
    const dictionary& dict,
    const bodyMoments& ofShape
)
{
    bodyMoments body(sphereUnion::moments(centres_, radii_));
    volume_ = body.volume;
    if (ofShape.volume > 0)
    {
        body = ofShape;
        volume_ = body.volume;
    }
    const scalarField cubes(pow3(radii_));
    const scalar mass = givenMass(dict, constant::mathematical::pi*4.0/3.0*sum(cubes));
    scalarField fractions(cubes/sum(cubes));

    // Neither full spheres nor those that stand for something larger are the body
    const bool isBody =
        dict.getOrDefault<word>("massModel", "union") == "union"
     && (ofShape.volume > 0 || !dict.found("nominalVolume"));
    if (isBody)
    {
        const massDistribution ofBody
        (
            centres_, radii_, body.centre, body.inertia()/body.volume, body.accuracy
        );
        fractions = ofBody.masses();
        gyration_ = sum(ofBody.inertias())/sum(fractions*sqr(radii_));
    }
    masses_ = mass*fractions;
    inertias_ = gyration_*masses_*sqr(radii_);
    volumes_ = volume_*fractions;
    if (dict.found("inertia"))
    {
        setInertia(dict, mass, isBody ? body.centre : sum(fractions*centres_));
    }

    dragRadii_ = radii_;
    bodyRadii_ = radii_;
    halfWidth_ = min(radii_);

    centres_ -= sum(masses_*centres_)/sum(masses_);
    vectorField grad(size());
    smoothVolume_ = sphereUnion::smoothVolume(centres_, radii_, grad);
}


void Foam::clumpType::setInertia
(
    const dictionary& dict,
    const scalar mass,
    const point& centre
)
{
    const massDistribution given
    (
        centres_, radii_, centre, givenInertia(dict)/mass, 0
    );
    if (given.error() > 0.01)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'inertia': with the mass of " << mass << " kg, spheres at these"
            << " places have a moment of inertia that differs by "
            << 100*given.error() << " % from it about some axis, whatever their masses"
            << " are. Give the moments of a body of this shape, or a shape of more"
            << " spheres." << exit(FatalIOError);
    }
    masses_ = mass*given.masses();
    inertias_ = mass*given.inertias();
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
    if (hasTriangles())
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
    return nominalRatio()*(masses_ - rho*volumes_*relativeVolume(x));
}
