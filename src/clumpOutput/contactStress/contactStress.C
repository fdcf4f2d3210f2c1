/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStress.H"
#include "addToRunTimeSelectionTable.H"
#include "clumpMotion.H"
#include "foamCompat.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(contactStress, 0);
    addToRunTimeSelectionTable(functionObject, contactStress, dictionary);
}
}


Foam::functionObjects::contactStress::contactStress
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    suspensionTable(name, runTime, dict, typeName)
{
    read(dict);
}


Foam::functionObjects::tableHeader
Foam::functionObjects::contactStress::header() const
{
    return
        tableHeader("Contacts of clumps")
       .add("contacts").add("deepest").add("wall").add("shear", "Pa")
       .add("flow", "Pa").add("gradient", "Pa").add("vorticity", "Pa")
       .explain("time contacts", "number of pairs of spheres of two clumps that touch")
       .explain("deepest wall", "deepest overlap of two clumps, and with a wall, over the"
            " radius of the smaller sphere")
       .explain("shear", "component flow-gradient of the stress that contacts transfer")
       .explain("flow gradient vorticity", "its normal components; pressure is negative");
}


bool Foam::functionObjects::contactStress::write()
{
    if (functionObject::postProcess)
    {
        Info<< name() << ": the contacts of a step are known in the run only; no"
            << " table is written" << endl;
        return true;
    }
    const contactSummary& own = cloud().motion().contacts();
    const vector& e = axes().flow;
    const vector& g = axes().gradient;
    const vector& w = axes().vorticity;
    const tensor& S = own.virial;

    scalarList sums
    ({
        own.number, sum(mesh_.V().field()),
        0.5*((e & S & g) + (g & S & e)), e & S & e, g & S & g, w & S & w
    });
    scalarList deepest({own.deepest, own.deepestOfWall});
    reduceList(sums, plusEqOp<scalar>());
    reduceList(deepest, maxEqOp<scalar>());

    if (Pstream::master())
    {
        const scalar V = sums[1];
        writeRow
        ({
            sums[0], deepest[0], deepest[1],
            -sums[2]/V, -sums[3]/V, -sums[4]/V, -sums[5]/V
        });
    }

    return true;
}
