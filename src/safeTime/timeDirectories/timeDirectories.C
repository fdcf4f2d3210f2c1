/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "timeDirectories.H"
#include "HashSet.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"

Foam::fileName Foam::timeDirectories::mark(const fileName& directory)
{
    return directory/"uniform"/"incomplete";
}


Foam::fileName Foam::timeDirectories::aside(const fileName& directory)
{
    return fileName(directory + ".incomplete");
}


Foam::fileNameList Foam::timeDirectories::folders
(
    const fileName& own,
    const fileName& common
)
{
    fileNameList result(1, own);
    if (Pstream::parRun())
    {
        for (const fileName& name : readDir(common, fileName::DIRECTORY))
        {
            if (name.compare(0, 10, "processors") == 0)
            {
                result.append(common/name);
            }
        }
    }
    return result;
}


Foam::wordList Foam::timeDirectories::incomplete(const fileNameList& here)
{
    wordList found;
    for (const fileName& folder : here)
    {
        for (const fileName& name : readDir(folder, fileName::DIRECTORY))
        {
            const bool isAside = name.hasExt("incomplete");
            const fileName time(isAside ? name.lessExt() : name);
            scalar value;
            if
            (
                readScalar(time, value)
             && (isAside || isFile(mark(folder/name)))
            )
            {
                found.append(word(time));
            }
        }
    }
    const auto both = [](wordList a, const wordList& b) { a.append(b); return a; };
    return wordHashSet(returnReduce(found, both)).sortedToc();
}


void Foam::timeDirectories::setAside(const fileName& directory)
{
    if (isDir(directory) && isDir(aside(directory)))
    {
        rmDir(aside(directory), true);
    }
    if (!mv(directory, aside(directory)) && isDir(directory))
    {
        FatalErrorInFunction
            << "cannot remove " << directory << exit(FatalError);
    }
}


void Foam::timeDirectories::addEmpty(const fileName& own, const fileName& common)
{
    if (!Pstream::parRun() || !isDir(own))
    {
        return;
    }
    const auto both = [](wordList a, const wordList& b) { a.append(b); return a; };
    wordList mine;
    for (const fileName& name : readDir(own, fileName::DIRECTORY))
    {
        scalar value;
        if (readScalar(name, value))
        {
            mine.append(word(name));
        }
    }
    for (const word& name : wordHashSet(returnReduce(mine, both)).sortedToc())
    {
        const fileName whole(common/name);
        if
        (
            !mine.found(name) && isFile(whole/"uniform"/"time")
         && readDir(whole, fileName::FILE).empty()
        )
        {
            mkDir(own/name);
            cp(whole/"uniform", own/name/"uniform");
        }
    }
    returnReduce(true, andOp<bool>());
}


void Foam::timeDirectories::refuseUncopied(const Time& time)
{
    const word& name = time.timeName();
    if
    (
        !isDir(time.timePath())
     && isDir(time.path()/name + ".orig")
     && isFile(time.path()/time.constant()/"transportProperties")
    )
    {
        FatalErrorInFunction
            << "There is no folder " << name << ", but " << name << ".orig in "
            << time.path() << ". Copy it first: cp -r " << name << ".orig "
            << name << exit(FatalError);
    }
}
