/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "checkedEntries.H"
#include "dimensionedScalar.H"
#include "messageStream.H"
#include "unreadEntries.H"

namespace
{

using namespace Foam;

//- The value when it lies from low to high, else fatal with the rule
template<class Type>
Type checked
(
    const dictionary& dict,
    const word& key,
    const Type value,
    const Type low,
    const Type high,
    const string& rule
)
{
    if (value < low || value > high)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' is " << value << "; it must be "
            << rule.c_str() << exit(FatalIOError);
    }
    return value;
}


scalar positive(const dictionary& dict, const word& key, const scalar value)
{
    return checked
    (
        dict, key, value, smallestEntry, largestEntry,
        "above 0 (1e-40 to 1e40)"
    );
}


scalar nonNegative(const dictionary& dict, const word& key, const scalar value)
{
    return checked
    (
        dict, key, value, scalar(0), largestEntry, "0 or above (up to 1e40)"
    );
}


template<class Type>
Type between
(
    const dictionary& dict, const word& key, const Type low, const Type high
)
{
    return checked
    (
        dict, key, getEntry<Type>(dict, key), low, high,
        "from " + Foam::name(low) + " to " + Foam::name(high)
    );
}

}


void Foam::refuseMisspelt(const dictionary& dict, const wordList& known)
{
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();
        if (key.isPattern() || known.found(key))
        {
            continue;
        }
        for (const word& meant : known)
        {
            // Beside the entry that is meant, one letter is enough
            if
            (
                spellingDistance(key, meant)
              < (dict.found(meant) ? 2 : 2 + meant.size()/8)
            )
            {
                refuseUnread(dict, key, known);
            }
        }
    }
}


void Foam::refuseMissing(const dictionary& dict, const word& key)
{
    if (!dict.found(key))
    {
        refuseMisspelt(dict, wordList(1, key));
    }
}


void Foam::checkEntries
(
    const dictionary& dict,
    const wordList& known,
    const wordList& derived
)
{
    wordList valid(known);
    valid.append(derived);
    for (const entry& e : dict)
    {
        if (!e.keyword().isPattern() && !valid.found(e.keyword()))
        {
            refuseUnread(dict, e.keyword(), valid);
        }
    }
}


void Foam::warnOfFormerName
(
    const dictionary& dict,
    const word& former,
    const word& present
)
{
    IOWarningInFunction(dict)
        << "The name '" << former << "' has been replaced by '" << present
        << "'; please change it" << endl;
}


Foam::dictionary Foam::withPresentNames
(
    const dictionary& dict,
    const HashTable<word>& presentNames
)
{
    dictionary result(dict);
    forAllConstIters(presentNames, name)
    {
        if (dict.found(name.key()) && dict.found(name.val()))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << name.key() << "' is the former name of '"
                << name.val() << "', which is given, too. Remove it."
                << exit(FatalIOError);
        }
        if (dict.found(name.key()))
        {
            warnOfFormerName(dict, name.key(), name.val());
            result.changeKeyword(name.key(), name.val());
        }
    }
    return result;
}


Foam::dictionary Foam::withoutRemoved
(
    const dictionary& dict,
    const wordList& removed
)
{
    dictionary result(dict);
    for (const word& name : removed)
    {
        if (result.remove(name))
        {
            IOWarningInFunction(dict)
                << "The entry '" << name << "' has no effect any more; please"
                << " remove it" << endl;
        }
    }
    return result;
}


const Foam::wordList& Foam::functionObjectEntries()
{
    static const wordList names
    {
        "type", "libs", "functionObjectLibs", "region", "subRegion", "enabled",
        "log", "useNamePrefix", "errors", "timeStart", "timeEnd",
        "executeControl", "executeInterval", "writeControl", "writeInterval",
        "outputControl", "outputInterval", "triggerStart", "triggerEnd",
        "controlMode", "deltaTCoeff", "nStepsToStartTimeChange",
        "writePrecision", "writeToFile", "useUserTime"
    };
    return names;
}


void Foam::refuseSkippedSteps(const dictionary& dict)
{
    const word control(dict.getOrDefault<word>("executeControl", "timeStep"));
    const label interval = dict.getOrDefault<label>("executeInterval", 1);
    if (control != "timeStep" || interval > 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << (control != "timeStep" ? "executeControl" : "executeInterval")
            << "' leaves out steps, which would be missing in what is integrated over"
            << " time. Remove executeControl and executeInterval; writeControl and"
            << " writeInterval say how often a table gets a row." << exit(FatalIOError);
    }
}


const Foam::wordList& Foam::fvOptionEntries()
{
    static const wordList names
    {
        "type", "active", "log", "timeStart", "duration", "selectionMode",
        "cellSet", "cellZone", "points", "fields"
    };
    return names;
}


Foam::List<Foam::dictionary> Foam::getDictList
(
    const dictionary& dict,
    const word& key
)
{
    const string rule
    (
        "Entry '" + key + "' must be a list of dictionaries: " + key
      + " ( { ... } { ... } );"
    );
    refuseMissing(dict, key);
    if (dict.findDict(key))
    {
        FatalIOErrorInFunction(dict) << rule.c_str() << exit(FatalIOError);
    }

    // Outside of all braces there is nothing but the parentheses of the list,
    // and perhaps its length before them
    label braces = 0;
    for (const token& t : dict.lookup(key))
    {
        if (t == token::BEGIN_BLOCK)
        {
            ++braces;
        }
        else if (t == token::END_BLOCK)
        {
            --braces;
        }
        else if
        (
            braces == 0
         && !t.isLabel() && t != token::BEGIN_LIST && t != token::END_LIST
        )
        {
            FatalIOErrorInFunction(dict)
                << rule.c_str() << " Found " << t << exit(FatalIOError);
        }
    }
    return getEntry<List<dictionary>>(dict, key);
}


const Foam::dictionary& Foam::getDict(const dictionary& dict, const word& key)
{
    if (dict.found(key) && !dict.findDict(key))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' must be a dictionary: " << key
            << " { ... }" << exit(FatalIOError);
    }
    refuseMissing(dict, key);
    return dict.subDict(key);
}


Foam::scalar Foam::getPositive(const dictionary& dict, const word& key)
{
    return positive(dict, key, getEntry<scalar>(dict, key));
}


Foam::scalar Foam::getPositiveOrDefault
(
    const dictionary& dict,
    const word& key,
    const scalar value
)
{
    return positive(dict, key, dict.getOrDefault<scalar>(key, value));
}


Foam::scalar Foam::getPositive
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions
)
{
    const dimensionedScalar value(key, dict);
    if (value.dimensions() != dimensions && value.dimensions() != dimless)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' has the dimensions "
            << value.dimensions() << "; they must be " << dimensions
            << exit(FatalIOError);
    }
    return positive(dict, key, value.value());
}


Foam::scalar Foam::getNonNegative(const dictionary& dict, const word& key)
{
    return nonNegative(dict, key, getEntry<scalar>(dict, key));
}


Foam::scalar Foam::getNonNegativeOrDefault
(
    const dictionary& dict,
    const word& key,
    const scalar value
)
{
    return nonNegative(dict, key, dict.getOrDefault<scalar>(key, value));
}


Foam::scalar Foam::getBetween
(
    const dictionary& dict,
    const word& key,
    const scalar low,
    const scalar high
)
{
    return between(dict, key, low, high);
}


Foam::scalar Foam::getBetweenOrDefault
(
    const dictionary& dict,
    const word& key,
    const scalar value,
    const scalar low,
    const scalar high
)
{
    return dict.found(key) ? getBetween(dict, key, low, high) : value;
}


Foam::label Foam::getNumber
(
    const dictionary& dict,
    const word& key,
    const label low,
    const label high
)
{
    return between(dict, key, low, high);
}


Foam::label Foam::getNumberOrDefault
(
    const dictionary& dict,
    const word& key,
    const label value,
    const label low,
    const label high
)
{
    return dict.found(key) ? between(dict, key, low, high) : value;
}
