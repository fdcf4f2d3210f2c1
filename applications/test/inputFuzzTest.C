/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    Mutated input: whatever constant/clumpProperties and the clumps of the start
    time hold, reading them ends well or in a fatal error. Anything else ends
    this program, and the input that did it is still in the case.

    The case holds, in fuzz, the dictionaries to mutate, and in fuzz/clumps*
    folders of clumps that go with its own dictionary. FUZZ_SEED is the number
    of the first input, FUZZ_SECONDS how long to go on; cases/fuzzTest runs it.
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "deformableCloud.H"
#include "OSspecific.H"
#include <unistd.h>
#include <chrono>
#include <fstream>
#include <random>
#include <regex>

using namespace Foam;

namespace
{

std::string contentOf(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(is), {});
}


void write(const fileName& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}


class mutator
{
    std::mt19937 random_;

    //- Tokens of all dictionaries, and some that do not belong there.
    //  No sizes beyond a million: OpenFOAM's lists believe them
    std::vector<std::string> pool_
    {
        "-1", "0", "1", "2", "3", "0.5", "1e-300", "1e-41", "1e-6", "1e30",
        "1e300", "1e999", "nan", "-1e-6", "1000000", "-2147483648", "(", ")",
        "{", "}", ";", "()", "(0 0 0)", "\"", "$types", "$..", "\".*\"",
        "[0 1 0 0 0 0 0]", "/*", "//"
    };

    size_t below(const size_t n) { return n ? random_() % n : 0; }

    const std::string& any() { return pool_[below(pool_.size())]; }

    static std::vector<std::string> tokensOf(const std::string& text)
    {
        static const std::regex token("\\s+|[\\w.+-]+|[^\\w\\s]");
        std::vector<std::string> tokens;
        for
        (
            std::sregex_iterator i(text.begin(), text.end(), token), end;
            i != end;
            ++i
        )
        {
            tokens.push_back(i->str());
        }
        return tokens;
    }

    void changeToken(std::string& text)
    {
        std::vector<std::string> t(tokensOf(text));
        if (t.empty())
        {
            return;
        }
        const size_t i = below(t.size()), j = below(t.size());
        const auto first = t.begin() + i;
        switch (below(7))
        {
            case 0: t.erase(first); break;
            case 1: t.insert(first, t[j]); break;
            case 2: t[i] = any(); break;
            case 3: t.insert(first, ' ' + any() + ' '); break;
            case 4: std::swap(t[i], t[j]); break;
            case 5: t.erase(first, first + below(std::min<size_t>(30, t.size() - i))); break;
            case 6: t[i] += any(); break;
        }
        text.clear();
        for (const std::string& word : t)
        {
            text += word;
        }
    }

    void changeByte(std::string& text)
    {
        const size_t i = below(text.size());
        switch (below(4))
        {
            case 0: text.erase(i, 1); break;
            case 1: text.insert(i, 1, char(below(256))); break;
            case 2: if (i < text.size()) text[i] = char(below(256)); break;
            case 3: if (!below(10)) text.resize(i); break;
        }
    }


public:

    explicit mutator(const std::vector<std::string>& texts)
    {
        for (const std::string& text : texts)
        {
            for (const std::string& token : tokensOf(text))
            {
                if (token.find_first_not_of(" \n\t") != std::string::npos)
                {
                    pool_.push_back(token);
                }
            }
        }
    }

    void seed(const unsigned n) { random_.seed(n); }

    size_t choose(const size_t n) { return below(n); }

    //- One to four changes after the header
    std::string operator()(const std::string& text)
    {
        const size_t end = text.find('}');
        const size_t start = below(20) && end < text.size() ? end + 1 : 0;
        std::string body(text.substr(start));
        for (size_t n = 1 + below(4); n; --n)
        {
            below(3) ? changeToken(body) : changeByte(body);
        }
        return text.substr(0, start) + body;
    }
};

}


TEST_CASE("fuzz: reading ends well or in a fatal error", "[.][fuzz][serial]")
{
    const fileName clumps("0/lagrangian/clumps");
    const fileName properties("constant/clumpProperties");
    const std::string own(contentOf(properties));

    std::vector<std::string> dictionaries(1, own);
    for (const fileName& name : readDir("fuzz", fileName::FILE))
    {
        dictionaries.push_back(contentOf("fuzz"/name));
    }

    std::vector<std::map<std::string, std::string>> states;
    for (const fileName& folder : readDir("fuzz", fileName::DIRECTORY))
    {
        states.emplace_back();
        for (const fileName& name : readDir("fuzz"/folder, fileName::FILE))
        {
            states.back()[name] = contentOf("fuzz"/folder/name);
        }
    }
    REQUIRE(dictionaries.size() > 1);
    REQUIRE(states.size() > 0);

    mutator mutate(dictionaries);
    const auto start = std::chrono::steady_clock::now();
    const std::chrono::duration<double> limit(std::stod(getEnv("FUZZ_SECONDS")));
    const unsigned firstSeed = std::stoul(getEnv("FUZZ_SEED"));
    unsigned seed = firstSeed;
    label accepted = 0;

    const int verbosity = messageStream::level;
    messageStream::level = 0;

    for (; std::chrono::steady_clock::now() - start < limit; ++seed)
    {
        mutate.seed(seed);
        rmDir(clumps);

        if (mutate.choose(2))
        {
            write(properties, mutate(dictionaries[mutate.choose(dictionaries.size())]));
        }
        else
        {
            auto state = states[mutate.choose(states.size())];
            auto file = std::next(state.begin(), mutate.choose(state.size()));
            file->second = mutate(file->second);

            write(properties, own);
            mkDir(clumps);
            for (const auto& f : state)
            {
                write(clumps/f.first, f.second);
            }
        }
        write("fuzz.seed", std::to_string(seed));

        // A signal ends a reading that takes longer
        alarm(10);
        try
        {
            const deformableCloud cloud(testMesh());
            ++accepted;
        }
        catch (const Foam::error&)
        {}
        alarm(0);
    }

    messageStream::level = verbosity;
    Info<< "Inputs " << firstSeed << " to " << seed - 1 << ": " << accepted
        << " accepted, " << seed - firstSeed - accepted << " refused" << endl;
    CHECK(accepted > 0);
    CHECK(seed - firstSeed > unsigned(accepted));
}
