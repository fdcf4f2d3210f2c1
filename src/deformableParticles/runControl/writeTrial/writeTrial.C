/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "writeTrial.H"
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <vector>

Foam::string Foam::writeTrial::attempt
(
    const fileName& folder,
    const List<double>& sizes
)
{
    string error;
    std::vector<int> files;
    for (const double size : sizes)
    {
        std::string name(folder + "/writeTrialXXXXXX");
        const int file = mkstemp(&name[0]);
        int failure = file < 0 ? errno : 0;
        if (file >= 0)
        {
            unlink(name.c_str());
            files.push_back(file);
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
