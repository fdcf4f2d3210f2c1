/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "momentumBalance.H"
#include "deformableCloud.H"
#include "volFields.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(momentumBalance, 0);
    addToRunTimeSelectionTable(functionObject, momentumBalance, dictionary);
}
}


Foam::functionObjects::momentumBalance::momentumBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, typeName, dict)
{
    read(dict);
    if (Pstream::master())
    {
        file()
            << "# Forces on clumps and fluid" << nl
            << "# time [s]\tFx Fy Fz on clumps [N]\tFx Fy Fz on fluid [N]"
            << "\t|sum|/sum of magnitudes" << endl;
    }
}


bool Foam::functionObjects::momentumBalance::read(const dictionary& dict)
{
    refuseMisspelt(dict, {"cloud"});
    cloudName_ = deformableCloud::find(mesh_, dict).name();
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::momentumBalance::write()
{
    const auto& cloud = mesh_.lookupObject<deformableCloud>(cloudName_);
    if (!cloud.coupled())
    {
        return true;
    }

    vector onClumps(Zero);
    scalar size = 0;
    for (const clumpParcel& p : cloud)
    {
        onClumps += sum(p.fluidForces());
        size += sum(mag(p.fluidForces()));
    }
    reduce(onClumps, sumOp<vector>());
    reduce(size, sumOp<scalar>());

    const vector onFluid = cloud.boundary().forceOnFluid
    (
        mesh_.lookupObject<volVectorField>("U"), cloud.fluidDensity()
    );

    if (Pstream::master())
    {
        file() << time_.timeOutputValue();
        for (const vector& F : {onClumps, onFluid})
        {
            file() << '\t' << F.x() << '\t' << F.y() << '\t' << F.z();
        }
        file() << '\t' << mag(onClumps + onFluid)/max(size, VSMALL) << endl;
    }

    return true;
}
