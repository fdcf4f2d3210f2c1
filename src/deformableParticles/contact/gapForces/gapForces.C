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
    added->ofTypes = boolList(nTypes_*nTypes_, false);
    added->ofPatches = boolList(nTypes_*nPatches_, false);

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


bool Foam::gapForces::acts
(
    const surfaceLaw& law,
    const label first,
    const label second,
    const bool atWall
) const
{
    const label i = types_[first].whole(first);
    return
        atWall
      ? law.ofPatches[i*nPatches_ + second]
      : law.ofTypes[i*nTypes_ + types_[second].whole(second)];
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
    const scalar cellWidth,
    const bool atWall,
    const label first,
    const label second
) const
{
    contactModel::increment result{0, 0, 0};
    for (const surfaceLaw& law : laws_)
    {
        if (acts(law, first, second, atWall))
        {
            const auto w(law.law->step(gap, gap, 1, R, {viscosity_, cellWidth, atWall}));
            result.energy += w.energy;
            result.force += w.force;
            result.stiffness += w.stiffness;
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
    const scalar cellWidth,
    const bool atWall,
    const label first,
    const label second
) const
{
    contactModel::increment result
    (
        potential(gap, R, cellWidth, atWall, first, second)
    );
    if (filmActs_)
    {
        const auto w(film_->step(gap, start, dt, R, {viscosity_, cellWidth, atWall}));
        result.energy += w.energy;
        result.force += w.force;
        result.stiffness += w.stiffness;
    }
    return result;
}


Foam::contactModel::pressure Foam::gapForces::surfacePressure
(
    const scalar gap,
    const scalar start,
    const scalar dt,
    const scalar R,
    const scalar cellWidth,
    const bool atWall,
    const label first,
    const label second
) const
{
    contactModel::pressure result{0, 0, 0};
    for (const surfaceLaw& law : laws_)
    {
        if (acts(law, first, second, atWall))
        {
            const auto p = law.law->surfacePressure
            (
                gap, start, dt, R,
                {viscosity_, law.law->range(cellWidth, atWall), 0}
            );
            result.energy += p.energy;
            result.value += p.value;
            result.stiffness += p.stiffness;
        }
    }
    return result;
}
