/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "writtenFiles.H"
#include "fileOperation.H"
#include "IFstream.H"
#include "IOobject.H"
#include "OSspecific.H"
#include "StringStream.H"
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

Foam::string Foam::writtenFiles::trial
(
    const fileName& folder,
    const List<double>& sizes
)
{
    string error;
    DynamicList<int> files;
    for (const double size : sizes)
    {
        std::string name(folder + "/writeTrialXXXXXX");
        const int file = mkstemp(&name[0]);
        int failure = file < 0 ? errno : 0;
        if (file >= 0)
        {
            unlink(name.c_str());
            files.append(file);
            failure = posix_fallocate(file, 0, off_t(size) + 1);
        }

        // A file system that cannot reserve space says so
        if (failure && failure != EOPNOTSUPP && failure != EINVAL)
        {
            error =
                std::string("a file of ") + std::to_string(1 + long(size)/1024)
              + " kB in " + folder + ": " + std::strerror(failure);
            break;
        }
    }
    for (const int file : files)
    {
        close(file);
    }
    return error;
}


bool Foam::writtenFiles::complete(const fileName& file)
{
    if (fileHandler().type() == "collated")
    {
        return true;
    }
    OStringStream divider;
    IOobject::writeEndDivider(divider);
    const string end(divider.str());

    IFstream stream(file);
    std::istream& is = stream.stdStream();

    // A compressed file cannot be positioned and is read completely
    is.seekg(-std::streamoff(end.size()), std::ios::end);
    is.clear();

    string tail;
    for (char c; is.get(c); )
    {
        tail += c;
        if (tail.size() > 2*end.size())
        {
            tail.erase(0, end.size());
        }
    }
    return
        tail.size() >= end.size()
     && tail.compare(tail.size() - end.size(), end.size(), end) == 0;
}


Foam::fileName Foam::writtenFiles::firstTruncated
(
    const fileName& directory,
    const double since
)
{
    for (const fileName& name : readDir(directory, fileName::FILE))
    {
        const fileName file(directory/name);
        const fileName stored(file + (isFile(file, false) ? "" : ".gz"));

        if (highResLastModified(stored) >= since && !complete(file))
        {
            return stored;
        }
    }
    for (const fileName& name : readDir(directory, fileName::DIRECTORY))
    {
        const fileName file(firstTruncated(directory/name, since));
        if (!file.empty())
        {
            return file;
        }
    }
    return fileName();
}
