/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "shell.H"

namespace Foam
{
namespace clumpShapes
{
    defineTypeNameAndDebug(shell, 0);
    addToRunTimeSelectionTable(shape, shell, dictionary);
}
}


Foam::clumpShapes::shell::shell(const dictionary& dict)
{
    checkEntries(dict, {"type", "nSpheres", "shellRadius", "sphereRadius"});

    const label n = getEntry<label>(dict, "nSpheres");
    if (n != 12 && n != 42)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'nSpheres' is " << n << "; it must be 12 or 42."
            << exit(FatalIOError);
    }
    const scalar R = getPositive(dict, "shellRadius");

    // Corners of the icosahedron: cyclic permutations of (0, +-1, +-golden)
    const scalar golden = 0.5*(1 + Foam::sqrt(5.0));
    for (label axis = 0; axis < 3; ++axis)
    {
        for (label sign = 0; sign < 4; ++sign)
        {
            vector corner(Zero);
            corner[(axis + 1) % 3] = sign & 1 ? 1 : -1;
            corner[(axis + 2) % 3] = sign & 2 ? golden : -golden;
            centres_.append(corner);
        }
    }

    if (n == 42)
    {
        const pointField corners(centres_);
        forAll(corners, i)
        {
            for (label j = i + 1; j < corners.size(); ++j)
            {
                if (mag(corners[i] - corners[j]) < 2.1)
                {
                    centres_.append(0.5*(corners[i] + corners[j]));
                }
            }
        }
    }

    centres_ *= R/mag(centres_);
    radii_ = scalarField(centres_.size(), getPositive(dict, "sphereRadius"));

    // Edge lengths are 1.05 R (12), 0.55 R and 0.62 R (42); the next
    // distances are 1.7 R and 0.95 R
    const scalar neighbourDistance = (n == 12 ? 1.3 : 0.75)*R;
    forAll(centres_, i)
    {
        for (label j = i + 1; j < centres_.size(); ++j)
        {
            if (mag(centres_[i] - centres_[j]) < neighbourDistance)
            {
                bonds_.append(labelPair(i, j));
            }
        }
    }
}
