/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "drivingGradient.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntries.H"
#include "fvOptions.H"
#include "meanVelocityGradient.H"
#include "volFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(drivingGradient, 0);
    addToRunTimeSelectionTable(functionObject, drivingGradient, dictionary);
}
}


Foam::functionObjects::drivingGradient::drivingGradient
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    table_(mesh_, name, typeName)
{
    read(dict);
}


bool Foam::functionObjects::drivingGradient::read(const dictionary& dict)
{
    checkEntries(dict, {}, functionObjectEntries());
    return fvMeshFunctionObject::read(dict) && table_.read(dict);
}


bool Foam::functionObjects::drivingGradient::write()
{
    if (functionObject::postProcess)
    {
        Info<< name() << ": the gradient is known in the run only; no table is written"
            << endl;
        return true;
    }
    const auto* U = mesh_.findObject<volVectorField>("U");
    if (!U)
    {
        FatalErrorInFunction
            << name() << ": there is no fluid whose gradient could be written"
            << exit(FatalError);
    }

    const scalarField& V = mesh_.V();
    vector G(Zero);
    PtrList<fv::option>& options = fv::options::New(mesh_);
    for (fv::option& option : options)
    {
        if (isA<fv::meanVelocityGradient>(option) && option.isActive())
        {
            const auto& source = refCast<const fv::meanVelocityGradient>(option);
            for (const label celli : source.cells())
            {
                G += V[celli]*source.gradient();
            }
        }
    }
    const scalar volume = gSum(V);
    const vector mean(gSum(V*U->primitiveField())/volume);
    reduce(G, sumOp<vector>());
    G /= volume;

    if (Pstream::master())
    {
        tableHeader header("Gradient that holds the mean velocity");
        header
           .add("time", "s").addVector("G", "m/s2").addVector("U", "m/s")
           .explain("time", "end of the step")
           .explain("Gx Gy Gz", "gradient, an acceleration; times the density of the fluid,"
                " the pressure drop per length")
           .explain("Ux Uy Uz", "mean velocity of fluid and clumps in the mesh; times the area"
                " of a straight duct, the volume flux");
        table_.open(header)
            << time_.timeOutputValue() << '\t'
            << G.x() << '\t' << G.y() << '\t' << G.z() << '\t'
            << mean.x() << '\t' << mean.y() << '\t' << mean.z() << nl;
        table_.flush();
    }
    return true;
}
