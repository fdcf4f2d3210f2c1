/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    A load: the force F sin(2 pi f t) on every clump of a type, shared by its spheres in
    proportion to their masses.
\*---------------------------------------------------------------------------*/

#include "load.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{

class swingingForce
:
    public load
{
    const vector amplitude_;    // [N]
    const scalar frequency_;    // [1/s]

public:

    TypeName("swingingForce");

    explicit swingingForce(const dictionary& dict)
    :
        load(dict, {"amplitude", "frequency"}),
        amplitude_(getEntry<vector>(dict, "amplitude")),
        frequency_(getPositive(dict, "frequency"))
    {}

    void add(const site& clump, externalForces& ext) const override
    {
        const vector F
        (
            Foam::sin(2*constant::mathematical::pi*frequency_*clump.time())*amplitude_
        );
        ext.f += clump.type.masses()/clump.type.mass()*F;
    }
};

defineTypeNameAndDebug(swingingForce, 0);
addToRunTimeSelectionTable(load, swingingForce, dictionary);

}
