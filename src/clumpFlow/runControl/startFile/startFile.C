/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "startFile.H"
#include "ignoreOverflow.H"
#include "Time.H"

Foam::startFile::startFile(const word& name, const Time& time)
:
    IOdictionary
    (
        // No floating point trap while it is read
        (ignoreOverflow(), IOobject
        (
            name, time.constant(), time, IOobject::MUST_READ_IF_MODIFIED,
            IOobject::NO_WRITE
        ))
    )
{}


bool Foam::startFile::readIfModified()
{
    if (modified())
    {
        fileName changed(name());
        for (const label watch : watchIndices())
        {
            if (fileHandler().getState(watch) != fileMonitor::UNMODIFIED)
            {
                changed = fileHandler().getFile(watch);
            }
            fileHandler().setUnmodified(watch);
        }
        Info<< "--> " << changed << " has changed. The run goes on with what it read of "
            << instance()/name() << " at its start; the next start reads the file again"
            << nl << endl;
    }
    return false;
}
