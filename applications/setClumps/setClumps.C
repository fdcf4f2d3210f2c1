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

    It also writes the field clumpWork, the work of each mesh cell and of the clumps
    whose centres it has, for the entry weightField of decomposeParDict (see
    clumpWork). -cellsPerSphere <n> is the work of a sphere in mesh cells that
    rbcIbFoam prints at the end of a run, default 30. With -work the clumps of the
    start time remain, and only this field is written.

    rbcIbFoam places the clumps by itself where the start time has none.

    With -template <name> it only writes constant/clumpProperties with a single clump
    into a case that has none (see caseTemplate): a cell of
    $WM_PROJECT_USER_DIR/etc/cells, for example healthy, or a bead, with
    -diameter <d> [m].
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "caseTemplate.H"
#include "clumpWork.H"
#include "deformableCloud.H"
#include "meshCheck.H"
#include "surfaceCrossing.H"
#include "timeDirectories.H"
#include "vtkClumps.H"

namespace
{

//- Write the field, and tell its largest value
void writeWork(const deformableCloud& cloud, const scalar cellsPerSphere)
{
    const clumpWork work(cloud, cellsPerSphere);
    const tmp<volScalarField> tfield(work.field());
    tfield().write();
    if (Pstream::parRun())
    {
        work.print(Info);
    }
    Info<< "Wrote the work of the mesh cells, " << gSum(tfield().primitiveField())
        << " with the clumps, to " << tfield().time().timeName()/tfield().name() << nl;
}


void addOptions()
{
    argList::addNote("Place the clumps of constant/clumpProperties");
    argList::addBoolOption
    (
        "overwrite",
        "Replace clumps that a run has written, or with -template clumpProperties"
    );
    argList::addOption
    (
        "template",
        "name",
        "Write a constant/clumpProperties with a clump: healthy, bead, ..."
    );
    argList::addOption("diameter", "m", "Of the template bead");
    argList::addBoolOption
    (
        "work",
        "Only write the field clumpWork, of the clumps of the start time"
    );
    argList::addOption
    (
        "cellsPerSphere", "n", "Work of a sphere in clumpWork, default 30"
    );
}


void writeTemplate(const fvMesh& mesh, const argList& args)
{
    if (Pstream::parRun())
    {
        FatalErrorInFunction
            << "The option -template is for one processor."
            << exit(FatalError);
    }
    caseTemplate
    (
        mesh, args.get<word>("template"), args.getOrDefault<scalar>("diameter", 0)
    ).write(args.found("overwrite"));
}


//- The option -cellsPerSphere
scalar workOfSphere(const argList& args)
{
    const scalar cellsPerSphere = args.getOrDefault<scalar>
    (
        "cellsPerSphere", clumpWork::usualCellsPerSphere
    );
    if (!(cellsPerSphere >= 0 && cellsPerSphere < GREAT))
    {
        FatalErrorInFunction
            << "-cellsPerSphere must not be negative: " << cellsPerSphere
            << exit(FatalError);
    }
    return cellsPerSphere;
}


//- Fatal where clumps cross a wall or an open patch
void refuseCrossing(const deformableCloud& cloud)
{
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
        cloud.mesh(), cloud.types(), cloud.ghosts(), tolerance
    );
    if (crossing.nClumps())
    {
        FatalErrorInFunction
            << crossing.nClumps() << " clumps cross a wall or an open patch; "
            << crossing.description().c_str() << exit(FatalError);
    }
}

}


int main(int argc, char* argv[])
{
    addOptions();
    #include "setRootCase.H"
    #include "createTime.H"
    timeDirectories::refuseUncopied(runTime);
    #include "createMesh.H"
    meshCheck::check(mesh);

    if (args.found("template"))
    {
        writeTemplate(mesh, args);
        return 0;
    }
    if (args.found("diameter"))
    {
        FatalErrorInFunction
            << "The option -diameter belongs to -template bead." << exit(FatalError);
    }

    const scalar cellsPerSphere = workOfSphere(args);
    const fileName folder(runTime.timePath()/Foam::cloud::prefix/"clumps");
    if (args.found("work"))
    {
        if (!returnReduce(isDir(folder), orOp<bool>()))
        {
            FatalErrorInFunction
                << "There are no clumps in " << folder
                << "; setClumps without -work places them." << exit(FatalError);
        }
        writeWork(deformableCloud(mesh), cellsPerSphere);
        Info<< "End" << nl << endl;
        return 0;
    }
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

    refuseCrossing(cloud);

    cloud.rename("clumps");
    if (isDir(folder))
    {
        rmDir(folder);
    }
    rm(runTime.timePath()/"uniform"/(cloud.name() + "Count"));
    cloud.write();
    writeWork(cloud, cellsPerSphere);
    functionObjects::vtkClumps("vtkClumps", runTime, dictionary()).write();

    Info<< "Wrote " << cloud.nClumps() << " clumps to "
        << runTime.timeName()/Foam::cloud::prefix/cloud.name() << nl
        << "End" << nl << endl;

    return 0;
}
