/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceSpacing.H"

Foam::scalar Foam::surfaceSpacing::narrowest
(
    const Cloud<clumpParcel>& clumps,
    const PtrList<clumpType>& types
)
{
    const scalarField& V = clumps.pMesh().cellVolumes();
    scalar width = GREAT;
    for (const clumpParcel& p : clumps)
    {
        if (types[p.typeId()].hasTriangles())
        {
            width = min(width, Foam::cbrt(V[p.cell()]));
        }
    }
    return returnReduce(width, minOp<scalar>());
}
