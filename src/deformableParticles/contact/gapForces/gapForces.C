/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gapForces.H"
#include "contactLaws.H"
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
        film_ = selectModel<gapModel>(getDict(clumpProperties, "lubrication"));
    }
    if (clumpProperties.found("surfaceForces"))
    {
        const dictionary& dict = getDict(clumpProperties, "surfaceForces");
        for (const word& name : dict.toc())
        {
            addLaw(getDict(dict, name), patches);
        }
    }
}


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
    const dictionary& dict,
    const polyBoundaryMesh& patches
)
{
    autoPtr<surfaceLaw> added(new surfaceLaw);
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
    laws_.append(added);
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
    return result;
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
