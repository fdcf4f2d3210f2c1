/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    An energy of a membrane: a tension s [N/m] that does not depend on the area A, as that
    of a drop: E = s A.
\*---------------------------------------------------------------------------*/

#include "surfaceArea.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

class constantTension
:
    public membraneModel
{
    const closedSurface& surface_;
    const scalar tension_;

public:

    TypeName("constantTension");

    constantTension
    (
        const dictionary& dict, const closedSurface& surface, const pointField&
    )
    :
        surface_(surface),
        tension_(getPositive(dict, "tension"))
    {
        checkEntries(dict, {"type", "tension"});
    }

    scalar add
    (
        const pointField& x, vectorField& gradient, membraneTangent* tangent
    ) const override
    {
        gradient += tension_*surface_.areaGradient(x);
        if (tangent)
        {
            membraneModels::surfaceArea::addStretch(surface_, x, tension_, *tangent);
        }
        return tension_*surface_.area(x);
    }
};

defineTypeNameAndDebug(constantTension, 0);
addToRunTimeSelectionTable(membraneModel, constantTension, dictionary);

}
