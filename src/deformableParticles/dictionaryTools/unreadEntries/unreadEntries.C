/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "unreadEntries.H"
#include "FlatOutput.H"
#include "HashSet.H"
#include "stringOps.H"
#include <fstream>
#include <regex>
#include <sstream>
#include <vector>

namespace
{

using namespace Foam;

//- Names after a dollar sign, and names at the top level of the file itself
struct fileWords
{
    wordHashSet referred;
    wordHashSet own;
};


void collect(const std::string& text, const std::regex& pattern, wordHashSet& names)
{
    const std::sregex_iterator end;
    for (std::sregex_iterator i(text.begin(), text.end(), pattern); i != end; ++i)
    {
        names.insert(word((*i)[1].str(), false));
    }
}


//- What stands in no dictionary of a file
std::string topLevel(const std::string& text)
{
    std::string result;
    label depth = 0;
    for (const char c : text)
    {
        depth -= c == '}';
        if (depth == 0)
        {
            result += c == '}' ? ' ' : c;
        }
        depth += c == '{';
    }
    return result;
}


//- Add the words of a file, and the references of those that it includes
void read(const fileName& file, fileWords& words, const label depth)
{
    std::ifstream is(file);
    std::ostringstream os;
    os << is.rdbuf();

    static const std::regex comments("//[^\\n]*|/\\*[^*]*\\*+([^/*][^*]*\\*+)*/");
    static const std::regex includes
    (
        "#(?:s?include|includeIfPresent|includeEtc)\\s+\"([^\"]+)\""
    );
    static const std::regex references("\\$\\{?[:.]*(\\w+)");
    static const std::regex quoted("\"[^\"]*\"");
    static const std::regex any("(\\w+)");

    // A path may contain what looks like a comment
    std::string text(os.str());
    wordHashSet paths;
    collect(text, includes, paths);
    text = std::regex_replace(text, comments, " ");

    collect(text, references, words.referred);
    if (!depth)
    {
        text = std::regex_replace(text, quoted, " ");
        text = topLevel(std::regex_replace(text, references, " "));
        collect(text, any, words.own);
    }
    for (const std::string& name : paths)
    {
        fileName path(stringOps::expand(name));
        if (!path.isAbsolute())
        {
            path = file.path()/path;
        }
        if (depth < 10)
        {
            read(path, words, depth + 1);
        }
    }
}

}


size_t Foam::spellingDistance(const std::string& a, const std::string& b)
{
    std::vector<size_t> row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j)
    {
        row[j] = j;
    }
    for (size_t i = 1; i <= a.size(); ++i)
    {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j)
        {
            const size_t change = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min(change, 1 + std::min(row[j], row[j - 1]));
        }
    }
    return row[b.size()];
}


Foam::word Foam::nearestName(const word& name, const wordList& known)
{
    word result;
    size_t least = 2 + name.size()/3;
    for (const word& other : known)
    {
        // A part of the name is like it, too
        const bool part = name.size() > 3 && other.find(name) != std::string::npos;
        const size_t d = part ? 2 : spellingDistance(name, other);
        if (d < least)
        {
            least = d;
            result = other;
        }
    }
    return result;
}


void Foam::refuseUnread
(
    const dictionary& dict,
    const word& key,
    const wordList& known
)
{
    const word meant(nearestName(key, known));
    const entry* e = dict.findEntry(key, keyType::LITERAL);
    FatalIOErrorInFunction(dict)
        << "Unknown entry '" << key << "'";
    if (e)
    {
        // Of the file that holds it, which dict may include
        FatalIOError << " (line " << e->startLineNumber() << ')';
    }
    FatalIOError
        << " in dictionary " << dict.name() << ": nothing reads it.";
    if (!meant.empty())
    {
        FatalIOError << " Did you mean '" << meant << "'?";
    }
    FatalIOError
        << nl << "Valid entries: " << flatOutput(known) << exit(FatalIOError);
}


void Foam::refuseUnread
(
    const dictionary& dict,
    const fileName& file,
    const wordList& known
)
{
    wordList unknown;
    for (const entry& e : dict)
    {
        if (!e.keyword().isPattern() && !known.found(e.keyword()))
        {
            unknown.append(e.keyword());
        }
    }
    if (unknown.empty())
    {
        return;
    }
    fileWords words;
    read(file, words, 0);
    for (const word& key : unknown)
    {
        const word meant(nearestName(key, known));
        if (words.referred.found(key))
        {
            continue;
        }
        const bool misspelt =
            !meant.empty()
         && (
                spellingDistance(key, meant) < 2 + meant.size()/8
             || (
                    words.own.found(key) && !dict.found(meant)
                 && meant.find(key) != std::string::npos
                )
            );
        if (misspelt || (words.own.found(key) && dict.isDict(key)))
        {
            refuseUnread(dict, key, known);
        }
        if (words.own.found(key))
        {
            IOWarningInFunction(dict)
                << "Nothing reads the entry '" << key << "' and nothing refers to"
                << " it" << endl;
        }
    }
}
