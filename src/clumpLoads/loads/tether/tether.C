/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tether.H"

namespace Foam
{
namespace loads
{
    defineTypeNameAndDebug(tether, 0);
    addToRunTimeSelectionTable(load, tether, dictionary);
}
}


Foam::loads::tether::tether(const dictionary& dict)
:
    load(dict, {"sphere", "anchor", "stiffness"}),
    sphere_(getEntry<label>(dict, "sphere")),
    anchor_(getFinite<point>(dict, "anchor")),
    stiffness_(getPositive(dict, "stiffness"))
{}


void Foam::loads::tether::check
(
    const dictionary& dict,
    const label nSpheres
) const
{
    checkSpheres(dict, "sphere", labelList(1, sphere_), nSpheres);
}


void Foam::loads::tether::add
(
    const site& clump,
    externalForces& ext
) const
{
    const label i = clump.type.sphere(sphere_);
    if (i >= 0)
    {
        ext.f[i] -= stiffness_*(clump.x[i] - anchor_);
        ext.k[i] += stiffness_*symmTensor::I;
    }
}
