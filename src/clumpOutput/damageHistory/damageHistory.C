/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "damageHistory.H"
#include "stateList.H"

Foam::functionObjects::damageHistory::damageHistory
(
    const label id,
    const clumpType& type,
    const label nModels
)
:
    typeId(id),
    models(nModels, scalarField(type.size(), Zero))
{}


Foam::functionObjects::damageHistory::damageHistory
(
    stateReader& state,
    const label id
)
:
    typeId(id),
    stress(state.number()),
    deformation(state.number()),
    arealStrain(state.number()),
    models(label(state.number()))
{
    const label n = label(state.number());
    for (scalarField& h : models)
    {
        h.setSize(n);
        for (scalar& value : h)
        {
            value = state.number();
        }
    }
}


void Foam::functionObjects::damageHistory::append(DynamicList<scalar>& state) const
{
    state.append(stress);
    state.append(deformation);
    state.append(arealStrain);
    state.append(models.size());
    state.append(models.empty() ? 0 : models[0].size());
    for (const scalarField& h : models)
    {
        state.append(h);
    }
}


Foam::functionObjects::damageHistory
Foam::functionObjects::damageHistory::ofPiece
(
    const label pieceId,
    const clumpType& piece,
    const clumpType& before
) const
{
    damageHistory result(*this);
    result.typeId = pieceId;
    forAll(models, m)
    {
        result.models[m] = scalarField(piece.size(), Zero);
        forAll(result.models[m], i)
        {
            const label k = before.sphere(piece.numberInWhole(i));
            if (k >= 0 && k < models[m].size())
            {
                result.models[m][i] = models[m][k];
            }
        }
    }
    return result;
}


void Foam::functionObjects::damageHistory::select(const labelUList& numbers)
{
    const label n = models.empty() ? 0 : models[0].size();
    List<scalarField> selected(numbers.size());
    forAll(numbers, m)
    {
        selected[m] =
            numbers[m] >= 0 ? models[numbers[m]] : scalarField(n, Zero);
    }
    models.transfer(selected);
}
