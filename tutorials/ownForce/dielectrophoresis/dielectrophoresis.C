/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "dielectrophoresis.H"
#include "fvcGrad.H"
#include "fvmLaplacian.H"

namespace Foam
{
namespace loads
{
    defineTypeNameAndDebug(dielectrophoresis, 0);
    addToRunTimeSelectionTable(load, dielectrophoresis, dictionary);
}
}


Foam::loads::dielectrophoresis::dielectrophoresis(const dictionary& dict)
:
    // The base class reads type and clumpType, and refuses misspelt entries
    load(dict, {"permittivity", "factor"}),
    permittivity_(getPositive(dict, "permittivity")),
    factor_(getBetween(dict, "factor", -0.5, 1))
{}


Foam::tmp<Foam::volVectorField> Foam::loads::dielectrophoresis::field
(
    const fvMesh& mesh
) const
{
    if (!gradient_.valid())
    {
        volScalarField phi
        (
            IOobject
            (
                "potential",
                mesh.time().findInstance(mesh.dbDir(), "potential"),
                mesh,
                IOobject::MUST_READ
            ),
            mesh
        );
        fvScalarMatrix(fvm::laplacian(phi)).solve();
        const volVectorField E("E", -fvc::grad(phi));
        gradient_.reset(fvc::grad(magSqr(E)).ptr());
    }
    return tmp<volVectorField>(*gradient_);
}


void Foam::loads::dielectrophoresis::add
(
    const site& clump,
    externalForces& ext
) const
{
    // clump.field is the field above at the centres of the spheres
    ext.f += 1.5*permittivity_*factor_*clump.type.volumes()*clump.field;
}
