/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    Contact of bodies with an elastic layer of the modulus E [Pa] and the thickness h [m]:
    the pressure E d/h where the surfaces overlap by d, so that two spheres of the reduced
    radius R have the force pi R E d^2/h, from which membranes take the pressure.
\*---------------------------------------------------------------------------*/

#include "contactModel.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{

class elasticLayer
:
    public contactModel
{
    //- pi E/h [Pa/m]
    const scalar k_;

public:

    TypeName("elasticLayer");

    explicit elasticLayer(const dictionary& dict)
    :
        k_
        (
            constant::mathematical::pi
           *getPositive(dict, "modulus")/getPositive(dict, "thickness")
        )
    {
        checkEntries(dict, {"type", "modulus", "thickness"});
    }

    scalar force
    (
        const scalar d, const scalar, const scalar R, const scalar
    ) const override
    {
        return k_*R*sqr(d);
    }

    increment step
    (
        const scalar d, const scalar, const scalar, const scalar R, const scalar
    ) const override
    {
        return {k_*R*pow3(d)/3, k_*R*sqr(d), 2*k_*R*d};
    }
};

defineTypeNameAndDebug(elasticLayer, 0);
addToRunTimeSelectionTable(contactModel, elasticLayer, dictionary);

}
