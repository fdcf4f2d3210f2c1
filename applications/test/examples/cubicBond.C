/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    A bond that stiffens with its strain e = a/l: N = K_n a (1 + s e^2). s is the entry
    cubic [-]. As a model in a library of your own, see doc/extending.md.
\*---------------------------------------------------------------------------*/

#include "bondModel.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

class cubicBond
:
    public bondModel
{
    const scalar cubic_;

public:

    TypeName("cubicBond");

    explicit cubicBond(const dictionary& dict)
    :
        bondModel(dict, {"cubic"}),
        cubic_(getPositive(dict, "cubic"))
    {}

    //- Elongation a [m] of a bond of length l [m] and normal stiffness Kn [N/m]
    axialResponse axial
    (
        const scalar a, const scalar l, const scalar Kn
    ) const override
    {
        const scalar s = cubic_*sqr(a/l);
        return {Kn*a*(1 + s), Kn*(1 + 3*s), 0.5*Kn*sqr(a)*(1 + 0.5*s)};
    }
};

defineTypeNameAndDebug(cubicBond, 0);
addToRunTimeSelectionTable(bondModel, cubicBond, dictionary);

}
