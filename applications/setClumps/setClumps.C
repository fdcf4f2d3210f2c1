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
    or a random packing to a haematocrit), tells haematocrit and volume fraction,
    and writes them to the start time, so that decomposePar can share them out
    and ParaView can show them. Clumps already there are replaced.

    rbcIbFoam places the clumps by itself where the start time has none.
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "deformableCloud.H"

int main(int argc, char* argv[])
{
    argList::addNote("Place the clumps of constant/clumpProperties");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    // Under a name that no clumps are found by; the old ones go only when the
    // new ones have their places
    deformableCloud cloud(mesh, "newClumps");
    cloud.rename("clumps");
    rmDir(runTime.timePath()/Foam::cloud::prefix/cloud.name());
    rm(runTime.timePath()/"uniform"/(cloud.name() + "Count"));
    cloud.write();

    Info<< "Wrote " << cloud.nClumps() << " clumps to "
        << runTime.timeName()/Foam::cloud::prefix/cloud.name() << nl
        << "End" << nl << endl;

    return 0;
}
