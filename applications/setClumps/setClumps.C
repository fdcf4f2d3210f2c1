/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    setClumps

Group
    grpPreProcessingUtilities

Description
    Places the clumps of constant/clumpProperties, placement (a list, a lattice
    or a random packing up to the concentration of blood), tells the numbers by
    type, haematocrit and volume fraction, and writes the clumps to the start time,
    so that decomposePar can distribute them, and to VTK/clumps for ParaView.

    Clumps that cross a wall or an open patch are a fatal error. Clumps of the start
    time are replaced; those that a run has written only with the option -overwrite.

    rbcIbFoam places the clumps by itself where the start time has none.
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "deformableCloud.H"
#include "surfaceCrossing.H"
#include "timeDirectories.H"
#include "vtkClumps.H"

int main(int argc, char* argv[])
{
    argList::addNote("Place the clumps of constant/clumpProperties");
    argList::addBoolOption
    (
        "overwrite", "Replace clumps that a run has written"
    );

    #include "setRootCase.H"
    #include "createTime.H"
    timeDirectories::refuseUncopied(runTime);
    #include "createMesh.H"

    const fileName folder(runTime.timePath()/Foam::cloud::prefix/"clumps");
    if
    (
        isDir(folder) && isFile(runTime.timePath()/"uniform"/"time")
     && !args.found("overwrite")
    )
    {
        FatalErrorInFunction
            << folder << " has clumps that a run has written. Set startFrom to"
            << " startTime and startTime to 0 in controlDict, or give the"
            << " option -overwrite to replace them." << exit(FatalError);
    }

    // Under a name that no clumps are found by; the old ones go only when the
    // new ones have their places
    deformableCloud cloud(mesh, "newClumps");

    const scalar tolerance = max
    (
        0.01,
        cloud.properties().subOrEmptyDict("placement").getOrDefault<scalar>
        (
            "maxOverlap", 0
        )
    );
    const surfaceCrossing crossing
    (
        mesh, cloud.types(), cloud.ghosts(), tolerance
    );
    if (crossing.nClumps())
    {
        FatalErrorInFunction
            << crossing.nClumps() << " clumps cross a wall or an open patch; "
            << crossing.description().c_str() << exit(FatalError);
    }

    cloud.rename("clumps");
    if (isDir(folder))
    {
        rmDir(folder);
    }
    rm(runTime.timePath()/"uniform"/(cloud.name() + "Count"));
    cloud.write();
    functionObjects::vtkClumps("vtkClumps", runTime, dictionary()).write();

    Info<< "Wrote " << cloud.nClumps() << " clumps to "
        << runTime.timeName()/Foam::cloud::prefix/cloud.name() << nl
        << "End" << nl << endl;

    return 0;
}
