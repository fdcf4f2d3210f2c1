/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tableFile.H"
#include "functionObject.H"

Foam::Ostream& Foam::functionObjects::tableFile::open
(
    const tableHeader& header
)
{
    if (writeToFile() && !filePtr_.valid())
    {
        resetFile(fileName_);
        // writeFile pads the first word
        file().width(0);
        if (functionObject::postProcess)
        {
            file() << "# Written by rbcIbFoam -postProcess" << nl;
        }
        header.write(file());
    }
    return file();
}


void Foam::functionObjects::tableFile::flush()
{
    if (writeToFile())
    {
        file().flush();
        if (!file().good())
        {
            FatalErrorInFunction
                << "cannot write " << file().name() << exit(FatalError);
        }
    }
}
