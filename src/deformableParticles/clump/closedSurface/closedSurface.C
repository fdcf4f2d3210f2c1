/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "closedSurface.H"
#include "error.H"
#include "HashTable.H"
#include "labelPair.H"
#include <set>

namespace
{

using namespace Foam;

//- Area vector of a triangle [m2]
vector areaVector(const triFace& t, const pointField& x)
{
    return 0.5*((x[t[1]] - x[t[0]]) ^ (x[t[2]] - x[t[0]]));
}

}


Foam::closedSurface::closedSurface
(
    const pointField& x,
    const List<triFace>& triangles,
    const dictionary& dict
)
:
    triangles_(triangles),
    nNodes_(x.size())
{
    boolList used(nNodes_, false);
    forAll(triangles_, n)
    {
        const triFace& t = triangles_[n];
        for (const label i : t)
        {
            if (i < 0 || i >= nNodes_)
            {
                FatalIOErrorInFunction(dict)
                    << "Triangle " << n << " of the surface has a node " << i
                    << "; the nodes are 0 to " << nNodes_ - 1 << '.'
                    << exit(FatalIOError);
            }
            used[i] = true;
        }
        if (!(mag(areaVector(t, x)) > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Triangle " << n << " of the surface, " << t
                << ", has no area." << exit(FatalIOError);
        }
    }
    const label loose = used.find(false);
    if (loose >= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Node " << loose << " of the surface belongs to no triangle."
            << exit(FatalIOError);
    }
    setHinges(dict);
    refuseParts(dict);

    if (volume(x) < 0)
    {
        for (triFace& t : triangles_)
        {
            t.flip();
        }
        setHinges(dict);
    }
}


void Foam::closedSurface::setHinges(const dictionary& dict)
{
    // The node opposite to every directed edge
    HashTable<label, labelPair, labelPair::Hash<>> opposite(4*triangles_.size());
    for (const triFace& t : triangles_)
    {
        forAll(t, k)
        {
            const labelPair directed(t[k], t[t.fcIndex(k)]);
            if (!opposite.insert(directed, t[t.rcIndex(k)]))
            {
                FatalIOErrorInFunction(dict)
                    << "The edge " << directed << " of the surface belongs to two"
                    << " triangles in the same direction. The surface must be"
                    << " closed, with its triangles oriented alike."
                    << exit(FatalIOError);
            }
        }
    }

    hinges_.clear();
    DynamicList<hinge> hinges(3*triangles_.size()/2);
    for (const triFace& t : triangles_)
    {
        forAll(t, k)
        {
            const label i = t[k];
            const label j = t[t.fcIndex(k)];
            const auto other = opposite.cfind(labelPair(j, i));
            if (!other.found())
            {
                FatalIOErrorInFunction(dict)
                    << "The edge " << labelPair(i, j) << " of the surface belongs"
                    << " to one triangle only. The surface must be closed."
                    << exit(FatalIOError);
            }
            if (i < j)
            {
                hinges.append({i, j, t[t.rcIndex(k)], *other});
            }
        }
    }
    hinges_.transfer(hinges);
}


void Foam::closedSurface::refuseParts(const dictionary& dict) const
{
    boolList reached(nNodes_, false);
    reached[0] = true;
    bool more = true;
    while (more)
    {
        more = false;
        for (const hinge& h : hinges_)
        {
            if (reached[h.i] != reached[h.j])
            {
                reached[h.i] = reached[h.j] = true;
                more = true;
            }
        }
    }
    const label other = reached.find(false);
    if (other >= 0)
    {
        FatalIOErrorInFunction(dict)
            << "The surface has several parts: no edges lead from node 0 to node "
            << other << ". Give every closed surface a clump type of its own."
            << exit(FatalIOError);
    }
}


Foam::labelListList Foam::closedSurface::nodesAround(const label nEdges) const
{
    labelListList around(nNodes_);
    for (const hinge& h : hinges_)
    {
        around[h.i].append(h.j);
        around[h.j].append(h.i);
    }
    labelListList result(nNodes_);
    forAll(result, i)
    {
        std::set<label> nodes({i});
        for (const label j : around[i])
        {
            nodes.insert(j);
            if (nEdges > 1)
            {
                nodes.insert(around[j].begin(), around[j].end());
            }
        }
        result[i] = labelList(nodes.begin(), nodes.end());
    }
    return result;
}


Foam::scalar Foam::closedSurface::area(const pointField& x) const
{
    scalar A = 0;
    for (const triFace& t : triangles_)
    {
        A += mag(areaVector(t, x));
    }
    return A;
}


Foam::FixedList<Foam::vector, 3> Foam::closedSurface::areaGradient
(
    const triFace& t,
    const pointField& x
)
{
    const vector S((x[t[1]] - x[t[0]]) ^ (x[t[2]] - x[t[0]]));
    const vector n(S/mag(S));
    FixedList<vector, 3> result;
    forAll(t, k)
    {
        result[k] = 0.5*(n ^ (x[t[t.rcIndex(k)]] - x[t[t.fcIndex(k)]]));
    }
    return result;
}


Foam::vectorField Foam::closedSurface::areaGradient(const pointField& x) const
{
    vectorField result(x.size(), Zero);
    for (const triFace& t : triangles_)
    {
        const FixedList<vector, 3> g(areaGradient(t, x));
        forAll(t, k)
        {
            result[t[k]] += g[k];
        }
    }
    return result;
}


Foam::scalar Foam::closedSurface::volume(const pointField& x) const
{
    // Relative to a node: no cancellation far from the origin
    scalar V = 0;
    for (const triFace& t : triangles_)
    {
        V += (x[t[0]] - x[0]) & areaVector(t, x);
    }
    return V/3;
}


Foam::vectorField Foam::closedSurface::areaVectors(const pointField& x) const
{
    vectorField g(x.size(), Zero);
    for (const triFace& t : triangles_)
    {
        const vector S(areaVector(t, x)/3);
        for (const label i : t)
        {
            g[i] += S;
        }
    }
    return g;
}


Foam::scalarField Foam::closedSurface::nodeAreas(const pointField& x) const
{
    scalarField a(x.size(), Zero);
    for (const triFace& t : triangles_)
    {
        const scalar third = mag(areaVector(t, x))/3;
        for (const label i : t)
        {
            a[i] += third;
        }
    }
    return a;
}


Foam::scalarField Foam::closedSurface::divergence
(
    const pointField& x,
    const vectorField& v
) const
{
    // The integral over the area of a triangle is that of the flux across its edges
    scalarField integrals(x.size(), Zero);
    for (const triFace& t : triangles_)
    {
        const vector n(t.areaNormal(x)/max(mag(t.areaNormal(x)), VSMALL));
        scalar flux = 0;
        forAll(t, k)
        {
            const vector edge(x[t[t.fcIndex(k)]] - x[t[k]]);
            flux += 0.5*(v[t[k]] + v[t[t.fcIndex(k)]]) & (edge ^ n);
        }
        for (const label i : t)
        {
            integrals[i] += flux/3;
        }
    }
    return integrals/max(nodeAreas(x), VSMALL);
}


Foam::point Foam::closedSurface::centroid(const pointField& x) const
{
    // Of tetrahedra with a corner in the first node
    scalar V = 0;
    vector moment(Zero);
    for (const triFace& t : triangles_)
    {
        const vector a(x[t[0]] - x[0]);
        const scalar v = (a & areaVector(t, x))/3;
        V += v;
        moment += 0.25*v*(a + (x[t[1]] - x[0]) + (x[t[2]] - x[0]));
    }
    return x[0] + moment/V;
}


Foam::symmTensor Foam::closedSurface::secondMoments(const pointField& x) const
{
    const point c(centroid(x));
    symmTensor result(Zero);
    for (const triFace& t : triangles_)
    {
        // Of a tetrahedron with a corner in the centroid
        const vector a(x[t[0]] - c);
        const vector b(x[t[1]] - c);
        const vector d(x[t[2]] - c);
        const scalar v = (a & areaVector(t, x))/3;
        result += 0.05*v*(sqr(a) + sqr(b) + sqr(d) + sqr(a + b + d));
    }
    return result;
}


Foam::scalar Foam::closedSurface::edgeLength(const pointField& x) const
{
    scalar sum = 0;
    for (const hinge& h : hinges_)
    {
        sum += mag(x[h.j] - x[h.i]);
    }
    return sum/hinges_.size();
}
