/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    How the mesh sees a clump: a solid fraction that goes from one to zero over a mesh cell
    of the width h without a kink, 1/2 - 3/4 s + 1/4 s^3 with s = 2 d/h within -1 to 1 and
    the distance d of the centre of the mesh cell from the surface.
\*---------------------------------------------------------------------------*/

#include "solidFractionModel.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

class smoothFraction
:
    public solidFractionModel
{
public:

    TypeName("smoothFraction");

    explicit smoothFraction(const dictionary& dict)
    {
        checkEntries(dict, {"type"});
    }

    //- The distance is enough
    bool needsSpheres() const override { return false; }

    scalar fraction
    (
        const cellGeometry& geometry,
        const label celli,
        const scalar distance,
        const UList<point>&,
        const UList<scalar>&
    ) const override
    {
        const scalar h = geometry[celli].width;
        const scalar s = min(max(2*distance/h, scalar(-1)), scalar(1));
        return 0.5 - 0.75*s + 0.25*pow3(s);
    }
};

defineTypeNameAndDebug(smoothFraction, 0);
addToRunTimeSelectionTable(solidFractionModel, smoothFraction, dictionary);

}
