/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gapForces.H"
#include "bondKinetics.H"
#include "contactLaws.H"
#include "polyMesh.H"
#include "surfaceBonds.H"
#include "symmetryPlanes.H"
#include "wordRes.H"

Foam::gapForces::gapForces
(
    const dictionary& clumpProperties,
    const PtrList<clumpType>& types,
    const polyBoundaryMesh& patches
)
:
    types_(types),
    nTypes_(types.size()),
    nPatches_(patches.size()),
    filmActs_(false),
    viscosity_(0)
{
    if (clumpProperties.found("lubrication"))
    {
        const dictionary& dict = getDict(clumpProperties, "lubrication");
        film_ = selectModel<gapModel>(dict);
        if (!film_->resists())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'type' is " << dict.get<word>("type") << ", which is no film of"
                << " fluid: it belongs into the entry surfaceForces." << exit(FatalIOError);
        }
    }
    if (clumpProperties.found("surfaceForces"))
    {
        const dictionary& dict = getDict(clumpProperties, "surfaceForces");
        for (const word& name : dict.toc())
        {
            addLaw(name, getDict(dict, name), patches);
            if (laws_.last().law->bonds() && !bonds_.valid())
            {
                if (symmetryPlanes(patches).planes().size())
                {
                    FatalIOErrorInFunction(dict)
                        << "Entry '" << name << "' is a law of bonds, which do not form"
                        << " across the planes of symmetry of the mesh. Mesh both sides"
                        << " of the plane." << exit(FatalIOError);
                }
                bonds_.reset(new surfaceBonds(patches.mesh().time()));
            }
        }
    }
}


Foam::gapForces::~gapForces()
{}


Foam::labelList Foam::gapForces::typesOf
(
    const dictionary& dict,
    const wordList& names
) const
{
    return
        names.empty()
      ? identity(nTypes_)
      : contactLaws::typesOf(dict, names, types_);
}


void Foam::gapForces::addLaw
(
    const word& name,
    const dictionary& dict,
    const polyBoundaryMesh& patches
)
{
    autoPtr<surfaceLaw> added(new surfaceLaw);
    added->name = name;
    added->ofTypes.setSize(nTypes_*nTypes_, false);
    added->ofPatches.setSize(nTypes_*nPatches_, false);

    dictionary own(dict);
    own.remove("types");
    own.remove("patches");
    added->law = selectModel<gapModel>(own);

    if (added->law->resists())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'type' is " << dict.get<word>("type") << ", a film of fluid, which the"
            << " entry lubrication adds." << exit(FatalIOError);
    }
    const wordList names(dict.getOrDefault<wordList>("types", wordList()));
    if (dict.getOrDefault<wordRes>("patches", wordRes()).size())
    {
        for (const label patchi : contactLaws::wallsOf(dict, patches))
        {
            for (const label i : typesOf(dict, names))
            {
                added->ofPatches[i*nPatches_ + patchi] = true;
            }
        }
        checkBonds(dict, *added);
        laws_.append(added);
        return;
    }
    if (names.size() && names.size() != 2)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'types' has " << names.size() << " clump types. Without patches it"
            << " needs two, (a a) for clumps of one type among themselves; without it the"
            << " law acts between all." << exit(FatalIOError);
    }
    for (const label i : typesOf(dict, names.size() ? wordList({names[0]}) : names))
    {
        for (const label j : typesOf(dict, names.size() ? wordList({names[1]}) : names))
        {
            added->ofTypes[i*nTypes_ + j] = true;
            added->ofTypes[j*nTypes_ + i] = true;
        }
    }
    checkBonds(dict, *added);
    laws_.append(added);
}


void Foam::gapForces::checkBonds
(
    const dictionary& dict,
    const surfaceLaw& law
) const
{
    for (label k = 0; law.law->bonds() && k < law.ofTypes.size(); ++k)
    {
        const clumpType& first = types_[k/nTypes_];
        const clumpType& second = types_[k % nTypes_];
        if (law.ofTypes[k] && first.ofSpheres() && !second.ofSpheres())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'type' is " << dict.get<word>("type") << ", which forms bonds"
                << " among clumps of spheres and among others, but would act between "
                << first.name() << " and " << second.name() << ". Valid entries of"
                << " 'types': (" << first.name() << ' ' << first.name() << ") or ("
                << second.name() << ' ' << second.name() << "), one law for each"
                << exit(FatalIOError);
        }
    }
}


const Foam::bondKinetics* Foam::gapForces::kinetics(const word& law) const
{
    for (const surfaceLaw& candidate : laws_)
    {
        if (candidate.name == law)
        {
            return candidate.law->bonds();
        }
    }
    return nullptr;
}


Foam::DynamicList<Foam::gapForces::namedKinetics>
Foam::gapForces::kineticsAt(const place& where) const
{
    DynamicList<namedKinetics> result;
    for (const surfaceLaw& law : laws_)
    {
        if (law.law->bonds() && acts(law, where))
        {
            result.append(namedKinetics(law.name, law.law->bonds()));
        }
    }
    return result;
}


bool Foam::gapForces::acts(const surfaceLaw& law, const place& where) const
{
    const label i = types_[where.first].whole(where.first);
    return
        where.atWall
      ? law.ofPatches[i*nPatches_ + where.second]
      : law.ofTypes[i*nTypes_ + types_[where.second].whole(where.second)];
}


Foam::scalar Foam::gapForces::lawRange(const scalar cellWidth) const
{
    scalar result = 0;
    for (const surfaceLaw& law : laws_)
    {
        for (const bool atWall : {false, true})
        {
            result = max(result, law.law->range(cellWidth, atWall));
        }
    }

    // The gap between the spheres that a bond joins is no longer than it is
    return bonds_.valid() ? max(result, 1.01*bonds_->longest()) : result;
}


Foam::scalar Foam::gapForces::range
(
    const scalar cellWidth,
    const bool atWall
) const
{
    return max
    (
        lawRange(cellWidth), filmActs_ ? film_->range(cellWidth, atWall) : 0
    );
}


Foam::contactModel::increment Foam::gapForces::potential
(
    const scalar gap,
    const gapModel::radii& R,
    const place& where
) const
{
    contactModel::increment result{0, 0, 0};
    for (const surfaceLaw& law : laws_)
    {
        if (acts(law, where))
        {
            result += law.law->step(gap, gap, 1, R, medium(where));
        }
    }
    return result;
}


Foam::contactModel::increment Foam::gapForces::step
(
    const scalar gap,
    const scalar start,
    const scalar dt,
    const gapModel::radii& R,
    const place& where
) const
{
    contactModel::increment result(potential(gap, R, where));
    if (filmActs_)
    {
        result += film_->step(gap, start, dt, R, medium(where));
    }
    return result;
}


Foam::contactModel::pressure Foam::gapForces::surfacePressure
(
    const scalar gap,
    const scalar start,
    const scalar dt,
    const scalar R,
    const place& where
) const
{
    contactModel::pressure result{0, 0, 0};
    for (const surfaceLaw& law : laws_)
    {
        if (acts(law, where))
        {
            const scalar range = law.law->range(where.cellWidth, where.atWall);
            result += law.law->surfacePressure
            (
                gap, start, dt, R, {viscosity_, range, 0}
            );
        }
    }
    return result;
}
