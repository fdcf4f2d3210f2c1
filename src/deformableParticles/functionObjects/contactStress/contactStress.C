/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactStress.H"
#include "addToRunTimeSelectionTable.H"
#include "FixedList.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(contactStress, 0);
    addToRunTimeSelectionTable(functionObject, contactStress, dictionary);
}
}


namespace
{

using namespace Foam;

typedef FixedList<scalar, 8> totals;

//- Sums of the first six values, largest of the others
struct combine
{
    totals operator()(const totals& a, const totals& b) const
    {
        totals result(a);
        for (label k = 0; k < totals::size(); ++k)
        {
            result[k] = k < 6 ? a[k] + b[k] : max(a[k], b[k]);
        }
        return result;
    }
};

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
       .add("flow", "Pa").add("gradient", "Pa").add("vorticity", "Pa");
}


bool Foam::functionObjects::contactStress::write()
{
    const contactSummary& own = cloud().contacts();
    const vector& e = axes().flow;
    const vector& g = axes().gradient;
    const vector& w = axes().vorticity;
    const tensor& S = own.virial;

    totals values
    ({
        own.number, sum(mesh_.V().field()),
        0.5*((e & S & g) + (g & S & e)), e & S & e, g & S & g, w & S & w,
        own.deepest, own.deepestOfWall
    });
    reduce(values, combine());

    if (Pstream::master())
    {
        const scalar V = values[1];
        writeRow
        ({
            values[0], values[6], values[7],
            -values[2]/V, -values[3]/V, -values[4]/V, -values[5]/V
        });
    }

    return true;
}
