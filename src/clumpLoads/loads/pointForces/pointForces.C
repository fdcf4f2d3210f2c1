/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pointForces.H"

namespace Foam
{
namespace loads
{
    defineTypeNameAndDebug(pointForces, 0);
    addToRunTimeSelectionTable(load, pointForces, dictionary);
}
}


Foam::loads::pointForces::pointForces(const dictionary& dict)
:
    load(dict, {"spheres", "forces", "torques", "factor", "factorCoeffs"}),
    spheres_(getEntry<labelList>(dict, "spheres")),
    forces_(getFiniteList<vector>(dict, "forces")),
    torques_(getFiniteList<vector>(dict, "torques")),
    factor_(Function1<scalar>::New("factor", dict))
{
    if
    (
        spheres_.empty()
     || forces_.size() != spheres_.size()
     || torques_.size() != spheres_.size()
    )
    {
        FatalIOErrorInFunction(dict)
            << "pointForces needs at least one sphere, and one force and one"
            << " torque for every sphere; there are " << spheres_.size()
            << " spheres, " << forces_.size() << " forces and "
            << torques_.size() << " torques."
            << exit(FatalIOError);
    }
}


void Foam::loads::pointForces::check
(
    const dictionary& dict,
    const label nSpheres
) const
{
    checkSpheres(dict, "spheres", spheres_, nSpheres);
}


void Foam::loads::pointForces::add
(
    const site& clump,
    externalForces& ext
) const
{
    const scalar f = factor_->value(clump.time());

    forAll(spheres_, k)
    {
        const label i = clump.type.sphere(spheres_[k]);
        if (i >= 0)
        {
            ext.f[i] += f*forces_[k];
            ext.t[i] += f*torques_[k];
        }
    }
}
