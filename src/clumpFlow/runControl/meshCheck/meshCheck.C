/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "meshCheck.H"
#include "globalMeshData.H"
#include "Time.H"

void Foam::meshCheck::check(const polyMesh& mesh)
{
    const dictionary& control = mesh.time().controlDict();
    if (!control.getOrDefault("checkMesh", true))
    {
        return;
    }
    string wrong;
    const auto add = [&](const bool fails, const char* what)
    {
        if (fails)
        {
            wrong += (wrong.empty() ? "" : ", ") + string(what);
        }
    };
    add(mesh.checkClosedCells(false), "open mesh cells");
    add(mesh.checkFaceAreas(false), "faces without area");
    add(mesh.checkCellVolumes(false), "mesh cells with a volume of zero or below");

    // OpenFOAM's own limit is a volume in m3, which no mesh of micrometres reaches
    const scalarField& V = mesh.cellVolumes();
    const scalar mean = gSum(mag(V))/max(mesh.globalData().nTotalCells(), label(1));
    add
    (
        mesh.checkFacePyramids(false, -1e-9*mean),
        "faces whose mesh cell is inverted or whose normal points the wrong way"
    );
    if (wrong.size())
    {
        FatalErrorInFunction
            << "No flow can be solved on the mesh "
            << mesh.pointsInstance()/mesh.meshDir() << ", which has " << wrong.c_str()
            << '.' << nl << "    checkMesh lists them. 'checkMesh no;' in"
            << " system/controlDict uses the mesh nevertheless." << exit(FatalError);
    }
}
