/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpSource.H"
#include "error.H"

namespace Foam
{
    defineTypeNameAndDebug(clumpSource, 0);
    defineRunTimeSelectionTable(clumpSource, cloud);
}


Foam::autoPtr<Foam::clumpSource> Foam::clumpSource::New
(
    const word& cloudName,
    const dictionary& clumpProperties,
    const site& s
)
{
    if (!cloudConstructorTablePtr_ || cloudConstructorTablePtr_->empty())
    {
        FatalErrorInFunction
            << "No library that places clumps is loaded. Link libclumpPlacement, or add"
            << " it to the entry 'libs' of system/controlDict." << exit(FatalError);
    }
    return cloudConstructorTablePtr_->cbegin().val()(cloudName, clumpProperties, s);
}
