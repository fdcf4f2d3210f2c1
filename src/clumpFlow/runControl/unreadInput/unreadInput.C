/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "unreadInput.H"
#include "fvMesh.H"
#include "OSspecific.H"
#include "Time.H"
#include <fstream>
#include <iterator>

namespace
{

using namespace Foam;

//- Files that are read and not kept
const wordHashSet readAtOnce
({
    "clumpProperties", "dynamicMeshDict", "fvOptions", "g", "MRFProperties",
    "transportProperties", "turbulenceProperties"
});


//- All that the dictionaries of a folder say
string textOf(const fileName& folder)
{
    string result;
    for (const fileName& name : readDir(folder, fileName::FILE))
    {
        std::ifstream file(folder/name);
        result.append
        (
            std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()
        );
    }
    return result;
}

}


void Foam::unreadInput::tell(const fvMesh& mesh)
{
    const Time& time = mesh.time();
    const fileName start(time.path()/Time::timeName(time.startTime().value()));
    if (!Pstream::master() || isDir(start/"uniform"))
    {
        return;
    }
    const fileName constant(time.globalPath()/time.constant());
    const fileName system(time.globalPath()/time.system());
    const string text(textOf(constant) + textOf(system));

    DynamicList<fileName> unread;
    for (const fileName& folder : {start, constant})
    {
        for (const word name : readDir(folder, fileName::FILE))
        {
            if
            (
                !readAtOnce.found(name)
             && !mesh.foundObject<regIOobject>(name)
             && !time.foundObject<regIOobject>(name)
             && text.find('"' + name + '"') == string::npos
             && text.find('/' + name + '"') == string::npos
            )
            {
                unread.append(folder.name()/name);
            }
        }
    }
    if (unread.size())
    {
        Info<< "Not read, and without effect: " << unread[0].c_str();
        for (label n = 1; n < unread.size(); ++n)
        {
            Info<< ", " << unread[n].c_str();
        }
        Info<< nl << endl;
    }
}
