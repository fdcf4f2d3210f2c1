/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "unionVolume.H"
#include "sphereUnion.H"

namespace Foam
{
namespace conservationModels
{
    defineTypeNameAndDebug(unionVolume, 0);
    addToRunTimeSelectionTable(conservationModel, unionVolume, dictionary);
}
}


Foam::conservationModels::unionVolume::unionVolume
(
    const dictionary& dict,
    const pointField& centres,
    const scalarField& radii
)
:
    volumeModulus_(getPositive(dict, "volumeModulus")),
    radii_(radii),
    volume0_(0)
{
    checkEntries(dict, {"type", "volumeModulus"});

    forAll(centres, i)
    {
        forAll(centres, j)
        {
            const scalar d2 = magSqr(centres[j] - centres[i]);
            if (j != i && d2 + sqr(radii[i]) <= sqr(radii[j]))
            {
                FatalIOErrorInFunction(dict)
                    << "conservationModel unionVolume: the centre of sphere "
                    << i << " lies too deep inside sphere " << j
                    << "; increase their distance."
                    << exit(FatalIOError);
            }
        }
    }

    vectorField grad(centres.size());
    volume0_ = sphereUnion::smoothVolume(centres, radii_, grad);
}


Foam::scalar Foam::conservationModels::unionVolume::deviation
(
    const pointField& x,
    vectorField& grad
) const
{
    return sphereUnion::smoothVolume(x, radii_, grad) - volume0_;
}
