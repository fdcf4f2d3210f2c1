/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fit.H"
#include "boundedLeastSquares.H"
#include "SortableList.H"
#include <utility>
#include <vector>

Foam::fit::fit
(
    const mechanicalTest& test,
    const measurement& data,
    const freeParameters& parameters,
    const dictionary& type,
    const PtrList<dictionary>& variants
)
:
    test_(test),
    data_(data),
    parameters_(parameters),
    type_(type),
    variants_(variants),
    norm_(2),
    nCalls_(0),
    nRejected_(0)
{}


Foam::dictionary Foam::fit::type
(
    const Eigen::VectorXd& y,
    const label variant
) const
{
    dictionary result(type_);
    if (variant >= 0 && variant < variants_.size())
    {
        result.merge(variants_[variant]);
    }
    parameters_.set(y, result);
    return result;
}


Foam::string Foam::fit::refusal
(
    const Eigen::VectorXd& y,
    Eigen::VectorXd& z
) const
{
    string result;
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
    try
    {
        z = evaluate(y);
    }
    catch (const error& e)
    {
        result = e.message();
        z = Eigen::VectorXd();
    }
    FatalError.throwExceptions(false);
    FatalIOError.throwExceptions(false);
    return result;
}


Foam::string Foam::fit::blamed(const Eigen::VectorXd& y) const
{
    const Eigen::VectorXd given(parameters_.start(type_));
    string alone, together;
    for (label i = 0; i < parameters_.size(); ++i)
    {
        if (y[i] == given[i])
        {
            continue;
        }
        const string name
        (
            ' ' + parameters_.name(i) + ' '
          + Foam::name(parameters_.value(i, y[i]))
        );
        together += name;
        Eigen::VectorXd other(y), z;
        other[i] = given[i];
        if (refusal(other, z).empty())
        {
            alone += name;
        }
    }
    return alone.empty() ? together : alone;
}


Eigen::VectorXd Foam::fit::residuals(const Eigen::VectorXd& y) const
{
    Eigen::VectorXd z;
    const string message(refusal(y, z));
    if (!message.empty() && !nRejected_++)
    {
        refusal_ = "with" + blamed(y) + ": " + message;
    }
    return z;
}


Eigen::VectorXd Foam::fit::evaluate(const Eigen::VectorXd& y) const
{
    const label n = data_.points().size();
    Eigen::VectorXd z(nVariants()*n);

    for (label v = 0; v < nVariants(); ++v)
    {
        const List<scalarField> model
        (
            test_.predict(type(y, v), data_.abscissas())
        );
        ++nCalls_;

        for (label k = 0; k < n; ++k)
        {
            const measurement::point& p = data_.points()[k];
            const scalar m = model[p.quantity][p.abscissa];

            // Not found: worse than any point
            z[v*n + k] = m < 0.1*GREAT ? (m - p.value)/p.error : 1e3;
        }
    }
    return z;
}


Eigen::VectorXd Foam::fit::part
(
    const Eigen::VectorXd& z,
    const bool heldOut
) const
{
    const label n = data_.points().size();
    Eigen::VectorXd result(z.size());
    label count = 0;
    for (label k = 0; k < z.size(); ++k)
    {
        if (data_.points()[k % n].heldOut == heldOut)
        {
            result[count++] = z[k];
        }
    }
    return result.head(count);
}


Eigen::VectorXd Foam::fit::values(const Eigen::VectorXd& y) const
{
    Eigen::VectorXd f(part(residuals(y), false));
    for (int k = 0; k < f.size(); ++k)
    {
        f[k] = Foam::sign(f[k])*Foam::pow(mag(f[k]), 0.5*norm_);
    }
    return f;
}


Foam::scalar Foam::fit::minimise(Eigen::VectorXd& y, const scalar norm)
{
    norm_ = norm;
    const boundedLeastSquares solver
    (
        [this](const Eigen::VectorXd& x){ return values(x); }, 1e-6, 200
    );
    return solver.minimise(y);
}


Foam::List<Eigen::VectorXd> Foam::fit::starts(const label n)
{
    List<Eigen::VectorXd> result(n);
    result[0] = parameters_.start(type_);

    norm_ = 2;
    SortableList<scalar> sums(10*(n - 1));
    forAll(sums, k)
    {
        const Eigen::VectorXd f(values(parameters_.point(k + 1)));
        sums[k] = f.size() ? f.squaredNorm() : GREAT;
    }
    sums.sort();
    for (label s = 1; s < n; ++s)
    {
        result[s] = parameters_.point(sums.indices()[s - 1] + 1);
    }
    return result;
}


Eigen::VectorXd Foam::fit::run(const scalar norm, const label nStarts)
{
    if (!parameters_.size())
    {
        return Eigen::VectorXd();
    }

    Eigen::VectorXd best;
    scalar lowest = GREAT;
    std::vector<std::pair<Eigen::VectorXd, scalar>> seen;

    Info<< nl << "start" << tab << "RMS" << tab << "largest |z|" << nl;
    const List<Eigen::VectorXd> all(starts(nStarts));
    forAll(all, s)
    {
        Eigen::VectorXd y(all[s]);
        scalar sum = minimise(y, 2);
        if (sum >= GREAT)
        {
            Info<< s << tab << "not admissible" << nl;
            continue;
        }
        bool met = false;
        for (const auto& other : seen)
        {
            met =
                met
             || (
                    (y - other.first).lpNorm<Eigen::Infinity>() < 0.1
                 && mag(sum - other.second) < 1e-3*sum
                );
        }
        if (met)
        {
            Info<< s << tab << "same as an earlier start" << nl;
            continue;
        }
        seen.push_back(std::make_pair(y, sum));

        for (scalar p = 4; p < norm; p *= 2)
        {
            minimise(y, p);
        }
        if (norm > 2)
        {
            sum = minimise(y, norm);
        }
        if (sum < lowest)
        {
            lowest = sum;
            best = y;
        }

        const Eigen::VectorXd z(part(residuals(y), false));
        Info<< s << tab << z.norm()/Foam::sqrt(scalar(z.size())) << tab
            << z.cwiseAbs().maxCoeff() << endl;
    }
    if (!best.size())
    {
        FatalErrorInFunction
            << "None of the starts is admissible; the first error was "
            << refusal_.c_str() << exit(FatalError);
    }
    return best;
}


Foam::scalarField Foam::fit::uncertainties(const Eigen::VectorXd& y)
{
    scalarField result(parameters_.size());
    if (result.size())
    {
        norm_ = 2;
        Eigen::MatrixXd J
        (
            boundedLeastSquares
            (
                [this](const Eigen::VectorXd& x){ return values(x); }, 0, 0
            ).jacobian(y, values(y))
        );

        // By the values, relative; one at its bound is held there
        scalarField scale(result.size());
        forAll(scale, i)
        {
            const scalar value = parameters_.value(i, y[i]);
            scale[i] = parameters_.derivative(i, y[i]);
            J.col(i) *=
                parameters_.atBound(i, value) ? 0 : mag(value)/scale[i];
            scale[i] = mag(value);
        }

        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinV);
        const Eigen::VectorXd& sigma = svd.singularValues();
        forAll(result, i)
        {
            scalar variance = 0;
            for (label k = 0; k < sigma.size(); ++k)
            {
                if (sigma[k] > 1e-10*sigma[0])
                {
                    variance += sqr(svd.matrixV()(i, k)/sigma[k]);
                }
            }
            result[i] = scale[i]*Foam::sqrt(variance);
        }
    }
    return result;
}
