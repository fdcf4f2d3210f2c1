/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "enclosedArea.H"

namespace Foam
{
namespace conservationModels
{
    defineTypeNameAndDebug(enclosedArea, 0);
    addToRunTimeSelectionTable(conservationModel, enclosedArea, dictionary);
}
}


Foam::conservationModels::enclosedArea::enclosedArea
(
    const dictionary& dict,
    const pointField& centres,
    const scalarField&
)
:
    areaModulus_(getPositive(dict, "areaModulus")),
    area0_(0)
{
    checkEntries(dict, {"type", "areaModulus"});

    vectorField grad(centres.size());
    area0_ = deviation(centres, grad);

    if (area0_ <= VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "conservationModel enclosedArea: the sphere centres do not"
            << " enclose an area." << exit(FatalIOError);
    }
}


Foam::scalar Foam::conservationModels::enclosedArea::deviation
(
    const pointField& x,
    vectorField& grad
) const
{
    // Relative to the first point: no cancellation far from the origin
    vector area(Zero);
    forAll(x, i)
    {
        area += 0.5*((x[i] - x[0]) ^ (x[x.fcIndex(i)] - x[0]));
    }

    const scalar A = mag(area);
    const vector n(A > VSMALL ? area/A : vector::zero);

    forAll(x, i)
    {
        grad[i] = 0.5*((x[x.fcIndex(i)] - x[x.rcIndex(i)]) ^ n);
    }

    return A - area0_;
}
