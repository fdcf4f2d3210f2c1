/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "freeParameters.H"
#include "checkedEntries.H"
#include "stringOps.H"

Foam::freeParameters::freeParameters
(
    const dictionary& dict,
    const dictionary& type
)
:
    list_(dict.size())
{
    const wordList names(dict.toc());
    dictionary copy(type);

    forAll(names, i)
    {
        const dictionary& d = dict.subDict(names[i]);
        parameter& p = list_[i];
        p.name = names[i];

        const word path(getEntry<word>(d, "entry"));
        for (const auto& level : stringOps::split(path, '.'))
        {
            p.entry.append(word(level.str()));
        }
        p.min = getEntry<scalar>(d, "min");
        p.max = getEntry<scalar>(d, "max");

        const word scale(getEntry<word>(d, "scale"));
        p.log = scale == "log";
        if (!p.log && scale != "linear")
        {
            FatalIOErrorInFunction(d)
                << "Entry 'scale' is " << scale << "; it must be log or linear."
                << exit(FatalIOError);
        }
        if (p.min >= p.max || (p.log && p.min <= 0))
        {
            FatalIOErrorInFunction(d)
                << "Parameter " << p.name << ": min (" << p.min
                << ") must be below max (" << p.max << ')'
                << (p.log ? " and above 0" : "")
                << exit(FatalIOError);
        }

        const scalar now = owner(copy, p).get<scalar>(p.entry.last());
        if (now < p.min || now > p.max)
        {
            FatalIOErrorInFunction(d)
                << "Parameter " << p.name << " starts from " << now
                << ", which is outside the range from " << p.min << " to "
                << p.max
                << exit(FatalIOError);
        }
    }
}


Foam::dictionary& Foam::freeParameters::owner
(
    dictionary& type,
    const parameter& p
)
{
    dictionary* d = &type;
    for (label k = 0; k < p.entry.size() - 1; ++k)
    {
        d = &d->subDict(p.entry[k]);
    }
    return *d;
}


bool Foam::freeParameters::atBound(const label i, const scalar value) const
{
    const parameter& p = list_[i];
    const scalar margin = 1e-3*(p.max - p.min);
    return
        p.log
      ? value < p.min*1.001 || value > p.max/1.001
      : value < p.min + margin || value > p.max - margin;
}


Eigen::VectorXd Foam::freeParameters::start(const dictionary& type) const
{
    dictionary copy(type);
    Eigen::VectorXd y(size());

    forAll(list_, i)
    {
        const parameter& p = list_[i];
        const scalar v = owner(copy, p).get<scalar>(p.entry.last());
        const scalar f =
            p.log
          ? Foam::log(v/p.min)/Foam::log(p.max/p.min)
          : (v - p.min)/(p.max - p.min);
        y[i] = Foam::min(Foam::max(f, scalar(0)), scalar(1));
    }
    return y;
}


Eigen::VectorXd Foam::freeParameters::point(const label k) const
{
    Eigen::VectorXd y(size());
    label base = 1;

    forAll(list_, i)
    {
        // The next prime
        for (label factor = 0; factor != base; )
        {
            ++base;
            for (factor = 2; base % factor; ++factor)
            {}
        }

        // The digits of k mirrored at the point
        y[i] = 0;
        scalar digit = 1;
        for (label rest = k; rest; rest /= base)
        {
            digit /= base;
            y[i] += digit*(rest % base);
        }
    }
    return y;
}


Foam::scalar Foam::freeParameters::value(const label i, const scalar y) const
{
    const parameter& p = list_[i];
    return
        y <= 0 ? p.min
      : y >= 1 ? p.max
      : p.log ? p.min*Foam::pow(p.max/p.min, y)
      : p.min + (p.max - p.min)*y;
}


Foam::scalar Foam::freeParameters::derivative
(
    const label i,
    const scalar y
) const
{
    const parameter& p = list_[i];
    return p.log ? value(i, y)*Foam::log(p.max/p.min) : p.max - p.min;
}


void Foam::freeParameters::set
(
    const Eigen::VectorXd& y,
    dictionary& type
) const
{
    forAll(list_, i)
    {
        owner(type, list_[i]).set
        (
            list_[i].entry.last(), value(i, y[i])
        );
    }
}
