/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "load.H"

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
