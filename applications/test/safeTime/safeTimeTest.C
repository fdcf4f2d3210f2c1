/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "IOobject.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "timeDirectories.H"
#include "writtenFiles.H"

using namespace Foam;

namespace
{

//- A folder of the case for one test
fileName emptyFolder(const word& name)
{
    const fileName folder(testTime().path()/name);
    rmDir(folder, true);
    mkDir(folder);
    return folder;
}


void write(const fileName& file, const bool complete)
{
    mkDir(file.path());
    OFstream os(file);
    os << "value 1;" << nl;
    if (complete)
    {
        IOobject::writeEndDivider(os);
    }
}

}


TEST_CASE("writtenFiles: truncated files are found", "[safeTime][serial]")
{
    const fileName folder(emptyFolder("writtenFilesTest"));
    CHECK(writtenFiles::firstTruncated(folder).empty());

    write(folder/"whole", true);
    CHECK(writtenFiles::complete(folder/"whole"));
    CHECK(writtenFiles::firstTruncated(folder).empty());

    const fileName part(folder/"below"/"part");
    write(part, false);
    CHECK_FALSE(writtenFiles::complete(part));
    CHECK(writtenFiles::firstTruncated(folder) == part);
    CHECK(writtenFiles::firstTruncated(folder, highResLastModified(part) + 1).empty());
    rmDir(folder, true);
}


TEST_CASE("writtenFiles: a trial leaves nothing", "[safeTime][serial]")
{
    const fileName folder(emptyFolder("trialTest"));
    CHECK(writtenFiles::trial(folder, {1e3, 1e6}).empty());
    CHECK_FALSE(writtenFiles::trial(folder/"missing", {1e3}).empty());
    CHECK_FALSE(writtenFiles::trial(folder, {1e3, 1e18}).empty());
    CHECK(readDir(folder, fileName::FILE).empty());
    rmDir(folder, true);
}


TEST_CASE("timeDirectories: incomplete ones are found", "[safeTime][serial]")
{
    using namespace timeDirectories;

    const fileName folder(emptyFolder("timeDirectoriesTest"));
    for (const word& name : wordList({"0.1", "0.2", "0.3", "constant"}))
    {
        mkDir(folder/name/"uniform");
    }
    CHECK(incomplete({folder}).empty());

    write(mark(folder/"0.2"), true);
    write(mark(folder/"constant"), true);
    setAside(folder/"0.3");
    CHECK_FALSE(isDir(folder/"0.3"));
    CHECK(incomplete({folder}) == wordList({"0.2", "0.3"}));
    rmDir(folder, true);
}
