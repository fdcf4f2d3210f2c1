/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gapForces.H"

const Foam::wordList& Foam::gapForces::entries()
{
    static const wordList names({"lubrication", "aggregation"});
    return names;
}


Foam::gapForces::gapForces(const dictionary& clumpProperties)
:
    viscosity_(0)
{
    for (const word& name : entries())
    {
        if (clumpProperties.found(name))
        {
            const dictionary& dict = getDict(clumpProperties, name);
            names_.append(name);
            models_.append(selectModel<gapModel>(dict));
            active_.append(false);
        }
    }
}


const Foam::gapModel* Foam::gapForces::model(const word& entry) const
{
    forAll(names_, k)
    {
        if (names_[k] == entry)
        {
            return &models_[k];
        }
    }
    return nullptr;
}


void Foam::gapForces::setActive(const word& entry, const bool on)
{
    forAll(names_, k)
    {
        if (names_[k] == entry)
        {
            active_[k] = on;
        }
    }
}


bool Foam::gapForces::active(const bool atWalls) const
{
    forAll(models_, k)
    {
        if (active_[k] && (!atWalls || models_[k].atWalls()))
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::gapForces::range
(
    const scalar cellWidth,
    const bool atWalls
) const
{
    scalar result = 0;
    forAll(models_, k)
    {
        if (active_[k] && (!atWalls || models_[k].atWalls()))
        {
            result = max(result, models_[k].range(cellWidth));
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
    const bool atWall
) const
{
    contactModel::increment result = {0, 0, 0};
    forAll(models_, k)
    {
        if (active_[k] && (!atWall || models_[k].atWalls()))
        {
            const contactModel::increment w = models_[k].step
            (
                gap, start, dt, R, {viscosity_, cellWidth}
            );
            result.energy += w.energy;
            result.force += w.force;
            result.stiffness += w.stiffness;
        }
    }
    return result;
}
