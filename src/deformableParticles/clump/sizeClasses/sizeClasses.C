/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sizeClasses.H"
#include "checkedEntries.H"
#include "clumpType.H"
#include "mathematicalConstants.H"
#include <cmath>

namespace
{

using namespace Foam;

//- The part of a normal distribution of mean zero and deviation one below z
scalar normalBelow(const scalar z)
{
    return 0.5*std::erfc(-z/std::sqrt(scalar(2)));
}


//- The entry of a class: that of all sizes, scaled
dictionary scaled
(
    const dictionary& entry,
    const word& family,
    const scalar factor,
    const scalar fraction
)
{
    dictionary result(entry);
    result.remove("sizes");
    setExact(result, "scale", factor);
    setExact(result, "share", fraction);
    result.set("classOf", family);
    for (const word key : {"nominalVolume", "mass"})
    {
        if (entry.found(key))
        {
            setExact(result, key, pow3(factor)*getPositive(entry, key));
        }
    }
    if (entry.found("inertia"))
    {
        List<scalar> moments(getFiniteList<scalar>(entry, "inertia"));
        for (scalar& J : moments)
        {
            J *= pow5(factor);
        }
        setExact(result, "inertia", moments);
    }
    return result;
}


//- Radius [m] of the sphere that has the volume of the shape of an entry
scalar volumeRadius(const word& name, const dictionary& entry)
{
    for (const char* key : {"scale", "classOf", "share"})
    {
        if (entry.found(key))
        {
            FatalIOErrorInFunction(entry)
                << "Clump type " << name << " has the entries 'sizes' and '" << key
                << "'; the classes of sizes set it themselves." << exit(FatalIOError);
        }
    }
    if (entry.subOrEmptyDict("bondModel").found("rigidities"))
    {
        FatalIOErrorInFunction(entry)
            << "Clump type " << name << " has 'sizes' and a bondModel with rigidities,"
            << " which are those of one size: give youngModulus, shearModulus and"
            << " multipliers." << exit(FatalIOError);
    }
    dictionary single(entry);
    single.remove("sizes");
    const scalar V = clumpType(name, single).volume();
    return Foam::cbrt(0.75*V/constant::mathematical::pi);
}

}


Foam::sizeClasses::sizeClasses(const dictionary& dict)
{
    const HashTable<label> choices({{"lognormal", 0}, {"list", 1}});
    const word distribution(getEntry<word>(dict, "distribution"));
    if (!choices.found(distribution))
    {
        FatalIOErrorInLookup(dict, "distribution", distribution, choices)
            << exit(FatalIOError);
    }
    if (choices[distribution] == 0)
    {
        setLognormal(dict);
    }
    else
    {
        setList(dict);
    }
}


void Foam::sizeClasses::setLognormal(const dictionary& dict)
{
    checkEntries(dict, {"distribution", "mean", "deviation", "number"});
    const scalar mean = getPositive(dict, "mean");
    const scalar deviation = getPositive(dict, "deviation");
    const label n = getNumberOrDefault(dict, "number", 8, 2, 100);
    if (deviation > 2*mean)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'deviation' is " << deviation << "; it must not be above twice the"
            << " mean, " << 2*mean << '.' << exit(FatalIOError);
    }
    const scalar s = std::sqrt(std::log1p(sqr(deviation/mean)));
    const scalar middle = mean*std::exp(-0.5*sqr(s));

    // Boundaries of the classes in deviations of ln r from its mean
    const scalar first = -2.5;
    const scalar width = (5 + 3*s)/n;
    radii_.setSize(n);
    fractions_.setSize(n);
    for (label k = 0; k < n; ++k)
    {
        const scalar low = k > 0 ? first + k*width : -GREAT;
        const scalar high = k < n - 1 ? first + (k + 1)*width : GREAT;

        // Of the upper half from above, so that no digits are lost
        const auto between = [&](const scalar shift)
        {
            const scalar a = low - shift;
            const scalar b = high - shift;
            return
                a > 0
              ? normalBelow(-a) - normalBelow(-b)
              : normalBelow(b) - normalBelow(a);
        };
        fractions_[k] = between(0);
        radii_[k] =
            middle*std::exp(1.5*sqr(s))*Foam::cbrt(between(3*s)/fractions_[k]);
    }
}


void Foam::sizeClasses::setList(const dictionary& dict)
{
    checkEntries(dict, {"distribution", "radii", "fractions"});
    radii_ = getFiniteList<scalar>(dict, "radii");
    fractions_ = getFiniteList<scalar>(dict, "fractions");
    if (radii_.empty() || radii_.size() != fractions_.size())
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'radii' and 'fractions' need one fraction for every radius;"
            << " there are " << radii_.size() << " radii and " << fractions_.size()
            << " fractions." << exit(FatalIOError);
    }
    forAll(radii_, k)
    {
        if (radii_[k] < smallestEntry || (k && radii_[k] <= radii_[k - 1]))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'radii' is " << radii_ << "; they must be above zero and each"
                << " larger than the one before." << exit(FatalIOError);
        }
    }
    if (min(fractions_) <= 0 || mag(sum(fractions_) - 1) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'fractions' is " << fractions_ << "; they must be above zero and"
            << " together make 1, not " << sum(fractions_) << '.' << exit(FatalIOError);
    }
}


Foam::dictionary Foam::sizeClasses::expanded(const dictionary& types)
{
    dictionary result(types);
    result.clear();
    for (const entry& e : types)
    {
        if (!e.isDict() || !e.dict().found("sizes"))
        {
            result.add(e);
            continue;
        }
        const sizeClasses classes(getDict(e.dict(), "sizes"));
        const scalar r = volumeRadius(e.keyword(), e.dict());
        forAll(classes.radii(), k)
        {
            const word name(e.keyword() + '_' + Foam::name(k + 1));
            if (types.found(name))
            {
                FatalIOErrorInFunction(types)
                    << "Clump type " << name << " is that of a class of the sizes of "
                    << e.keyword() << ": choose another name." << exit(FatalIOError);
            }
            result.add
            (
                name,
                scaled
                (
                    e.dict(), e.keyword(), classes.radii()[k]/r,
                    classes.fractions()[k]
                )
            );
        }
    }
    return result;
}
