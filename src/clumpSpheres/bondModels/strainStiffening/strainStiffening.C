/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "strainStiffening.H"
#include "timoshenko.H"

namespace Foam
{
namespace bondModels
{
    defineTypeNameAndDebug(strainStiffening, 0);
    addToRunTimeSelectionTable(bondModel, strainStiffening, dictionary);
}
}


Foam::bondModels::strainStiffening::strainStiffening(const dictionary& dict)
:
    bondModel(dict, {"stiffening", "residualBending"}),
    b_(getNonNegative(dict, "stiffening")),
    residualBending_(dict.getOrDefault<bool>("residualBending", false))
{}


Foam::bondCoefficients Foam::bondModels::strainStiffening::stiffness
(
    const scalar length,
    const scalar radius
) const
{
    const bondCoefficients k(bondModel::stiffness(length, radius));
    return residualBending_ ? timoshenko::inSeries(k, length) : k;
}


Foam::scalar Foam::bondModels::strainStiffening::force
(
    const scalar a,
    const scalar length
) const
{
    return a*Foam::exp(b_*a/(length + a));
}


Foam::bondModel::axialResponse Foam::bondModels::strainStiffening::axial
(
    const scalar a,
    const scalar length,
    const scalar Kn
) const
{
    if (a <= 0)
    {
        return bondModel::axial(a, length, Kn);
    }

    // Gauss-Legendre with five points
    static const scalar node[5] =
    {
        0.046910077030668, 0.230765344947158, 0.5,
        0.769234655052842, 0.953089922969332
    };
    static const scalar weight[5] =
    {
        0.118463442528095, 0.239314335249683, 0.284444444444444,
        0.239314335249683, 0.118463442528095
    };

    // In intervals of l_b, 2 l_b, 4 l_b, ... because the curvature of the law
    // decreases with the elongation
    scalar energy = 0;
    scalar low = 0;
    while (low < a)
    {
        const scalar width = min(low + length, a - low);
        for (label g = 0; g < 5; ++g)
        {
            energy += weight[g]*width*force(low + node[g]*width, length);
        }
        low += width;
    }

    const scalar growth = Foam::exp(b_*a/(length + a));

    return
    {
        Kn*a*growth,
        Kn*growth*(1 + b_*a*length/sqr(length + a)),
        Kn*energy
    };
}
