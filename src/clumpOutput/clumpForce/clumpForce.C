/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpForce.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpForce, 0);
    addToRunTimeSelectionTable(functionObject, clumpForce, dictionary);
}
}


Foam::functionObjects::clumpForce::clumpForce
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    clumpTable(name, runTime, dict, typeName)
{
    read(dict);
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpForce::header() const
{
    return
        tableHeader("Force of the fluid on each clump")
       .addVector("F", "N").addVector("T", "N.m")
       .addVector("", "m").addVector("U", "m/s")
       .add("drag", "N").add("lift", "N")
       .explain("Fx Fy Fz Tx Ty Tz", "force of the fluid without that of the pressure at"
            " rest (buoyancy), and its torque about the centre of mass")
       .explain("x y z Ux Uy Uz", "position and velocity of the centre of mass")
       .explain("drag lift", "force along flow and gradient. The nodes of a membrane have"
            " no inertia: F balances loads, weight and contacts");
}


Foam::string Foam::functionObjects::clumpForce::row
(
    const clumpParcel& p,
    const clumpType& type
) const
{
    const point centre(p.state().centre(type));
    vector torque(sum(p.fluidTorques()));
    forAll(p.fluidForces(), i)
    {
        torque += (p.state().x[i] - centre) ^ p.fluidForces()[i];
    }

    const vector force(sum(p.fluidForces()));
    return
        columns({force, torque, p.unwrappedCentre(type), p.state().velocity(type)})
      + columns({force & flow(), force & gradient()});
}
