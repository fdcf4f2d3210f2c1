/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "filledSurface.H"
#include "EdgeMap.H"
#include <Eigen/SparseCholesky>
#include <vector>

namespace
{

using namespace Foam;

//- An icosahedron whose triangles are divided
struct dividedIcosahedron
:
    public clumpShapes::surfaceShape
{
    explicit dividedIcosahedron(const label n) { setIcosphere(n); }
};

//- The edges of a tetrahedron, by its corners
const label edges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

//- Of the octahedron inside: edges whose middles are opposite to each other, and the four
//  others around them
const label diagonals[3][6] =
{
    {0, 5, 1, 2, 4, 3}, {1, 4, 0, 2, 5, 3}, {2, 3, 0, 1, 5, 4}
};

}


Foam::filledSurface::filledSurface
(
    const List<triFace>& triangles,
    const label nSurfaceNodes,
    const dictionary& dict
)
:
    nSurface_(nSurfaceNodes)
{
    labelList numbers;
    const label nDivisions = divisions(triangles, dict, numbers);

    // The corners of the icosahedron, and the centre behind the nodes of the surface
    const dividedIcosahedron coarsest(0);
    DynamicList<point> x(nSurface_ + 1);
    x.setSize(nSurface_ + 1, Zero);
    forAll(coarsest.centres(), i)
    {
        x[i] = coarsest.centres()[i];
    }
    tetrahedra_.setSize(coarsest.triangles().size());
    forAll(tetrahedra_, n)
    {
        const triFace& t = coarsest.triangles()[n];
        tetrahedra_[n] = tetrahedron({nSurface_, t[0], t[1], t[2]});
    }
    for (label n = 0; n < nDivisions; ++n)
    {
        divide
        (
            dividedIcosahedron(n).triangles(), dividedIcosahedron(n + 1).triangles(), x
        );
    }
    setSphere(dividedIcosahedron(nDivisions), pointField(x));

    for (tetrahedron& t : tetrahedra_)
    {
        for (label& i : t)
        {
            i = i < nSurface_ ? numbers[i] : i;
        }
    }
    const pointField surface(SubField<point>(sphere_, nSurface_));
    forAll(surface, i)
    {
        sphere_[numbers[i]] = surface[i];
    }
}


Foam::label Foam::filledSurface::divisions
(
    const List<triFace>& triangles,
    const dictionary& dict,
    labelList& numbers
) const
{
    for (label n = 1; n <= clumpShapes::surfaceShape::maxSubdivisions; ++n)
    {
        const dividedIcosahedron sphere(n);
        numbers = labelList(sphere.centres().size(), -1);
        bool same =
            numbers.size() == nSurface_ && sphere.triangles().size() == triangles.size();
        for (label m = 0; same && m < triangles.size(); ++m)
        {
            forAll(triangles[m], k)
            {
                label& number = numbers[sphere.triangles()[m][k]];
                number = number < 0 ? triangles[m][k] : number;
                same = same && number == triangles[m][k];
            }
        }
        if (same)
        {
            return n;
        }
    }
    FatalIOErrorInFunction(dict)
        << "A surface of " << nSurface_ << " nodes and " << triangles.size()
        << " triangles cannot be filled. Valid here: icosphere, and the surface of a file"
        << " with the triangles of an icosphere of 42, 162 or 642 nodes in their order."
        << exit(FatalIOError);
    return -1;
}


void Foam::filledSurface::divide
(
    const List<triFace>& coarse,
    const List<triFace>& fine,
    DynamicList<point>& x
)
{
    // On the surface the fine triangles have the numbers of the middles
    EdgeMap<label> middles(8*tetrahedra_.size());
    forAll(coarse, n)
    {
        const triFace& t = coarse[n];
        const triFace& inner = fine[4*n + 3];
        forAll(t, k)
        {
            const edge e(t[k], t[t.fcIndex(k)]);
            middles.insert(e, inner[k]);
            x[inner[k]] = 0.5*(x[e.first()] + x[e.second()]);
        }
    }

    List<tetrahedron> finer(8*tetrahedra_.size());
    label nFiner = 0;
    const auto append = [&](const label a, const label b, const label c, const label d)
    {
        tetrahedron t({a, b, c, d});
        if (volume(t, x) < 0)
        {
            Swap(t[2], t[3]);
        }
        finer[nFiner++] = t;
    };
    for (const tetrahedron& t : tetrahedra_)
    {
        FixedList<label, 6> m;
        forAll(m, k)
        {
            const edge e(t[edges[k][0]], t[edges[k][1]]);
            if (middles.insert(e, x.size()))
            {
                x.append(0.5*(x[e.first()] + x[e.second()]));
            }
            m[k] = middles[e];
        }
        append(t[0], m[0], m[1], m[2]);
        append(m[0], t[1], m[3], m[4]);
        append(m[1], m[3], t[2], m[5]);
        append(m[2], m[4], m[5], t[3]);

        label shortest = 0;
        scalar least = GREAT;
        for (label k = 0; k < 3; ++k)
        {
            const scalar length = mag(x[m[diagonals[k][0]]] - x[m[diagonals[k][1]]]);
            if (length < (1 - 1e-6)*least)
            {
                least = length;
                shortest = k;
            }
        }
        const label* d = diagonals[shortest];
        for (label k = 0; k < 4; ++k)
        {
            append(m[d[0]], m[d[1]], m[d[2 + k]], m[d[2 + (k + 1) % 4]]);
        }
    }
    tetrahedra_.transfer(finer);
}


void Foam::filledSurface::setSphere
(
    const clumpShapes::surfaceShape& surface,
    const pointField& x
)
{
    const pointField& ends = surface.centres();
    sphere_ = x;
    forAll(x, i)
    {
        // The triangle in which the line ends: that with no negative weight
        scalar best = -GREAT;
        for (const triFace& t : surface.triangles())
        {
            const vector& a = x[t[0]];
            const vector& b = x[t[1]];
            const vector& c = x[t[2]];
            const vector w
            (
                vector(x[i] & (b ^ c), x[i] & (c ^ a), x[i] & (a ^ b))/(a & (b ^ c))
            );
            if (cmptMin(w) > best + 1e-9)
            {
                best = cmptMin(w);
                sphere_[i] = w[0]*ends[t[0]] + w[1]*ends[t[1]] + w[2]*ends[t[2]];
            }
        }
    }
}


Foam::pointField Foam::filledSurface::nodes(const pointField& surface) const
{
    // The displacement from the sphere is found, with that of the surface known
    const label n = nNodes() - nSurface_;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right(Eigen::MatrixXd::Zero(n, 3));
    for (const tetrahedron& t : tetrahedra_)
    {
        // Gradients of the linear functions that are one at a corner
        FixedList<vector, 4> g;
        const scalar V = volume(t, sphere_);
        for (label k = 0; k < 3; ++k)
        {
            const vector a(sphere_[t[1 + (k + 1) % 3]] - sphere_[t[0]]);
            const vector b(sphere_[t[1 + (k + 2) % 3]] - sphere_[t[0]]);
            g[k + 1] = (a ^ b)/(6*V);
        }
        g[0] = -g[1] - g[2] - g[3];
        for (label a = 0; a < 4; ++a)
        {
            const label i = t[a] - nSurface_;
            for (label b = 0; i >= 0 && b < 4; ++b)
            {
                const scalar k = V*(g[a] & g[b]);
                const label j = t[b];
                if (j >= nSurface_)
                {
                    entries.emplace_back(i, j - nSurface_, k);
                    continue;
                }
                for (direction d = 0; d < 3; ++d)
                {
                    right(i, d) -= k*(surface[j][d] - sphere_[j][d]);
                }
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    const Eigen::MatrixXd moved(factors.solve(right));

    pointField result(sphere_);
    forAll(result, i)
    {
        if (i < nSurface_)
        {
            result[i] = surface[i];
            continue;
        }
        for (direction d = 0; d < 3; ++d)
        {
            result[i][d] += moved(i - nSurface_, d);
        }
    }
    return result;
}


Foam::scalar Foam::filledSurface::volume
(
    const tetrahedron& t,
    const UList<point>& x
)
{
    const point& o = x[t[0]];
    return ((x[t[1]] - o) & ((x[t[2]] - o) ^ (x[t[3]] - o)))/6;
}


Foam::scalar Foam::filledSurface::quality
(
    const tetrahedron& t,
    const UList<point>& x
)
{
    scalar squares = 0;
    for (const auto& e : edges)
    {
        squares += magSqr(x[t[e[1]]] - x[t[e[0]]]);
    }
    return 12*Foam::cbrt(sqr(3*max(volume(t, x), scalar(0))))/squares;
}
