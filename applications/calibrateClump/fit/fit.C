/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fit.H"
#include <unsupported/Eigen/NonLinearOptimization>

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
    nCalls_(0)
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


int Foam::fit::values() const
{
    // The solver wants as many values as parameters at least
    return max(nVariants()*data_.points().size(), parameters_.size());
}


Eigen::VectorXd Foam::fit::residuals(const Eigen::VectorXd& y) const
{
    const label n = data_.points().size();
    Eigen::VectorXd z(Eigen::VectorXd::Zero(values()));

    for (label v = 0; v < nVariants(); ++v)
    {
        const clumpType clump("fit", type(y, v));
        const List<scalarField> model
        (
            test_.predict(clump, data_.abscissas())
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


int Foam::fit::operator()(const Eigen::VectorXd& y, Eigen::VectorXd& f) const
{
    f = residuals(y);
    for (int k = 0; k < f.size(); ++k)
    {
        f[k] = Foam::sign(f[k])*Foam::pow(mag(f[k]), 0.5*norm_);
    }
    return 0;
}


int Foam::fit::df(const Eigen::VectorXd& y, Eigen::MatrixXd& J) const
{
    // Central differences: the equilibria are exact to 1e-10
    const scalar h = 1e-4;
    Eigen::VectorXd plus(values()), minus(values());

    for (int i = 0; i < inputs(); ++i)
    {
        Eigen::VectorXd moved(y);
        moved[i] = y[i] + h;
        operator()(moved, plus);
        moved[i] = y[i] - h;
        operator()(moved, minus);
        J.col(i) = (plus - minus)/(2*h);
    }
    return 0;
}


void Foam::fit::minimise(Eigen::VectorXd& y) const
{
    fit problem(*this);
    Eigen::LevenbergMarquardt<fit> solver(problem);
    solver.parameters.maxfev = 200;
    solver.parameters.ftol = 1e-8;
    solver.parameters.xtol = 1e-8;
    solver.minimize(y);
    nCalls_ = problem.nCalls_;
}


Eigen::VectorXd Foam::fit::run(const scalar norm)
{
    Eigen::VectorXd y(parameters_.start(type_));
    if (parameters_.size())
    {
        for (norm_ = 2; norm_ < norm; norm_ *= 2)
        {
            minimise(y);
        }
        norm_ = norm;
        minimise(y);
    }
    return y;
}


Foam::scalarField Foam::fit::uncertainties(const Eigen::VectorXd& y)
{
    scalarField result(parameters_.size());
    if (result.size())
    {
        norm_ = 2;
        Eigen::MatrixXd J(values(), inputs());
        df(y, J);

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
