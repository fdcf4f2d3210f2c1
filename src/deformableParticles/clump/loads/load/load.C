/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "load.H"
#include "fieldAtSpheres.H"
#include "fvcGrad.H"

namespace Foam
{
    defineTypeNameAndDebug(load, 0);
    defineRunTimeSelectionTable(load, dictionary);
}


void Foam::load::checkSpheres
(
    const dictionary& dict,
    const word& entry,
    const labelUList& spheres,
    const label nSpheres
) const
{
    if (min(spheres) < 0 || max(spheres) >= nSpheres)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << entry << "' is " << spheres
            << "; clump type " << clumpType_ << " has the spheres 0 to "
            << nSpheres - 1 << '.' << exit(FatalIOError);
    }
}


Foam::tmp<Foam::volVectorField> Foam::load::field(const fvMesh&) const
{
    return tmp<volVectorField>();
}


void Foam::load::sample(const fvMesh& mesh, ghostExchange& ghosts)
{
    values_.setSize(ghosts.nOwn());
    const tmp<volVectorField> sampled(field(mesh));
    if (!sampled.valid())
    {
        return;
    }
    const tmp<volTensorField> gradient(fvc::grad(sampled()));
    setFieldAtSpheres(sampled(), gradient(), ghosts.images());
    ghosts.returnForces();

    forAll(values_, i)
    {
        const imageForces& sums = ghosts.images()[i].fluid;
        values_[i] = sums.f/max(sums.t.component(vector::X), scalar(1));
    }
}
