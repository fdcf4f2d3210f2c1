/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneFactors.H"
#include <algorithm>
#include <set>

Foam::membraneTangent::membraneTangent
(
    const closedSurface& surface,
    const label neighbourOrder,
    const labelListList& more
)
:
    lower_
    (
        3*max(surface.nNodes(), more.size()), 3*max(surface.nNodes(), more.size())
    ),
    later_(lower_.cols()/3)
{
    const label n = later_.size();
    labelListList around(surface.nodesAround(neighbourOrder));
    around.setSize(n);
    forAll(more, i)
    {
        std::set<label> nodes({i});
        nodes.insert(around[i].begin(), around[i].end());
        nodes.insert(more[i].begin(), more[i].end());
        around[i] = labelList(nodes.begin(), nodes.end());
    }
    std::vector<int> counts(3*n);
    for (label i = 0; i < n; ++i)
    {
        const labelList& nodes = around[i];
        later_[i] = labelList
        (
            std::lower_bound(nodes.begin(), nodes.end(), i), nodes.end()
        );
        for (label c = 0; c < 3; ++c)
        {
            counts[3*i + c] = 3*later_[i].size() - c;
        }
    }

    lower_.reserve(counts);
    for (label j = 0; j < n; ++j)
    {
        for (label c = 0; c < 3; ++c)
        {
            for (const label i : later_[j])
            {
                for (label r = i == j ? c : 0; r < 3; ++r)
                {
                    lower_.insert(3*i + r, 3*j + c) = 0;
                }
            }
        }
    }
    lower_.makeCompressed();
}


void Foam::membraneTangent::clear(const scalar concave)
{
    concave_ = concave;
    std::fill(lower_.valuePtr(), lower_.valuePtr() + lower_.nonZeros(), 0.0);
    products_.clear();
}


void Foam::membraneTangent::add
(
    const label i,
    const label j,
    const Eigen::Matrix3d& block
)
{
    // The columns of a node begin with its diagonal block
    const labelList& nodes = later_[j];
    const label place =
        std::lower_bound(nodes.begin(), nodes.end(), i) - nodes.begin();
    for (label c = 0; c < 3; ++c)
    {
        double* column = lower_.valuePtr() + lower_.outerIndexPtr()[3*j + c] - c;
        for (label r = place ? 0 : c; r < 3; ++r)
        {
            column[3*place + r] += block(r, c);
        }
    }
}


void Foam::membraneTangent::addPressure
(
    const closedSurface& surface,
    const UList<vector>& x,
    const scalar p
)
{
    for (const triFace& t : surface.triangles())
    {
        forAll(t, k)
        {
            // A sixth of the triple product of the corners: d_i.(d_j x r)
            const label i = t[k];
            const label j = t[t.fcIndex(k)];
            const vector r(-p/6*(x[t[t.rcIndex(k)]] - x[0]));
            Eigen::Matrix3d block;
            block <<
                0, r.z(), -r.y(),
                -r.z(), 0, r.x(),
                r.y(), -r.x(), 0;
            if (i > j)
            {
                add(i, j, block);
            }
            else
            {
                add(j, i, block.transpose());
            }
        }
    }
}


void Foam::membraneTangent::addProduct(const scalar k, const vectorField& v)
{
    products_.push_back({k, asVector(v)});
}


bool Foam::membraneTangent::solve
(
    const Eigen::VectorXd& r,
    const membraneFactors& factors,
    Eigen::VectorXd& x
) const
{
    constexpr label most = 25;
    constexpr scalar tolerance = 1e-2;

    // With the residual, and its norm in the preconditioner. Where x is known, that of r is
    // about r.x
    Eigen::VectorXd residual(r);
    const scalar known = x.size() ? x.dot(r) : 0;
    if (known > 0)
    {
        residual -= times(x);
    }
    else
    {
        x.setZero(r.size());
    }
    Eigen::VectorXd z(factors.solve(residual));
    Eigen::VectorXd p(z);
    scalar norm = residual.dot(z);
    const scalar allowed = sqr(tolerance)*(known > 0 ? known : norm);
    for (label n = 0; n < most && norm > allowed; ++n)
    {
        const Eigen::VectorXd Hp(times(p));
        const scalar curvature = p.dot(Hp);
        if (!(curvature > 0))
        {
            break;
        }
        x += norm/curvature*p;
        residual -= norm/curvature*Hp;
        z = factors.solve(residual);
        const scalar last = norm;
        norm = residual.dot(z);
        p = z + norm/last*p;
    }
    if (!(norm <= allowed))
    {
        x.resize(0);
        return false;
    }
    return true;
}


Eigen::VectorXd Foam::membraneTangent::times(const Eigen::VectorXd& v) const
{
    Eigen::VectorXd result(lower_.selfadjointView<Eigen::Lower>()*v);
    for (const membraneProduct& term : products_)
    {
        result += term.k*term.v.dot(v)*term.v;
    }
    return result;
}
