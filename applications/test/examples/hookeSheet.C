/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    A strain law of a membrane: Hooke's law for the strain of Green and Lagrange, with the
    shear modulus Gs [N/m] and Poisson's ratio nu [-] of the surface,
    \verbatim
        W = Gs (E:E + nu/(1 - nu) tr(E)^2) = Gs/4 (I1^2/(1 - nu) + 2 I1 - 2 I2)
    \endverbatim
    by the invariants of triangleElasticity.
\*---------------------------------------------------------------------------*/

#include "triangleElasticity.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

class hookeSheet
:
    public triangleElasticity
{
    const scalar half_;
    const scalar factor_;

public:

    TypeName("hookeSheet");

    hookeSheet
    (
        const dictionary& dict, const closedSurface& surface, const pointField& x0
    )
    :
        triangleElasticity(surface, x0),
        half_(0.5*getPositive(dict, "shearModulus")),
        factor_(1/(1 - getBetween(dict, "poissonRatio", 0, 0.9)))
    {
        checkEntries(dict, {"type", "shearModulus", "poissonRatio"});
    }

    response law(const scalar I1, const scalar I2) const override
    {
        return
        {
            half_*(0.5*factor_*sqr(I1) + I1 - I2),
            half_*(factor_*I1 + 1), -half_, half_*factor_, 0, 0
        };
    }
};

defineTypeNameAndDebug(hookeSheet, 0);
addToRunTimeSelectionTable(membraneModel, hookeSheet, dictionary);

}
