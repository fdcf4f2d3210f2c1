/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rotatingField.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace loads
{
    defineTypeNameAndDebug(rotatingField, 0);
    addToRunTimeSelectionTable(load, rotatingField, dictionary);
}
}


Foam::loads::rotatingField::rotatingField(const dictionary& dict)
:
    load(dict, {"field", "axis", "frequency", "charge", "moment"}),
    field_(getFinite<vector>(dict, "field")),
    axis_(getFiniteOrDefault<vector>(dict, "axis", vector(0, 0, 1))),
    frequency_(getFiniteOrDefault<scalar>(dict, "frequency", 0)),
    charge_(getFiniteOrDefault<scalar>(dict, "charge", 0)),
    moment_(getFiniteOrDefault<vector>(dict, "moment", Zero))
{
    if (mag(field_) == 0 || mag(axis_) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'field' " << field_ << " and 'axis' " << axis_
            << " must not be zero." << exit(FatalIOError);
    }
    if (charge_ == 0 && mag(moment_) == 0)
    {
        FatalIOErrorInFunction(dict)
            << "rotatingField needs a 'charge' or a 'moment' that is not zero."
            << exit(FatalIOError);
    }
    axis_ /= mag(axis_);
}


void Foam::loads::rotatingField::add(const site& clump, externalForces& ext) const
{
    const scalar angle =
        constant::mathematical::twoPi*frequency_*clump.time();
    const vector B(quaternion(axis_, angle).transform(field_));

    const scalarField fractions
    (
        clump.type.part()*clump.type.volumes()/sum(clump.type.volumes())
    );
    forAll(fractions, i)
    {
        const vector m(clump.state.q[i].transform(moment_));
        ext.f[i] += fractions[i]*charge_*B;
        ext.t[i] += fractions[i]*(m ^ B);
    }
}
