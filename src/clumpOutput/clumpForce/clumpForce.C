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
       .explain("Fx Fy Fz Tx Ty Tz", "force of the fluid outside in the last step, without"
            " that of the pressure at rest (buoyancy), and its torque about the centre of"
            " mass")
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
    const vector& force = p.surfaceForce();
    return
        columns
        ({
            force, p.surfaceTorque(), p.unwrappedCentre(type), p.state().velocity(type)
        })
      + columns({force & flow(), force & gradient()});
}
