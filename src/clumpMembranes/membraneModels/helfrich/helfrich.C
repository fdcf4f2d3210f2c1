/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "helfrich.H"
#include "surfaceFold.H"

namespace Foam
{
namespace membraneModels
{
    defineTypeNameAndDebug(helfrich, 0);
    addToRunTimeSelectionTable(membraneModel, helfrich, dictionary);
}
}


Foam::membraneModels::helfrich::helfrich
(
    const dictionary& dict,
    const closedSurface& surface,
    const pointField&
)
:
    surface_(surface),
    stiffness_(getPositive(dict, "bendingStiffness")),
    curvature_(getFiniteOrDefault<scalar>(dict, "spontaneousCurvature", 0)),
    neighbours_(surface.nNodes())
{
    checkEntries(dict, {"type", "bendingStiffness", "spontaneousCurvature"});

    forAll(neighbours_, i)
    {
        neighbours_[i].append(i);
    }
    for (const closedSurface::hinge& h : surface.hinges())
    {
        neighbours_[h.i].append(h.j);
        neighbours_[h.j].append(h.i);
    }
}


Foam::scalar Foam::membraneModels::helfrich::add
(
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    const scalarField A(surface_.nodeAreas(x));
    scalarField M(A.size(), Zero);
    for (const closedSurface::hinge& h : surface_.hinges())
    {
        const surfaceFold f(h, x);
        const scalar quarter = 0.25*f.length*f.angle;
        M[h.i] += quarter;
        M[h.j] += quarter;
    }

    // Half the deviation of 2 H from c0
    const scalarField d(M/A - 0.5*curvature_);

    for (const closedSurface::hinge& h : surface_.hinges())
    {
        const surfaceFold f(h, x);
        const scalar k = stiffness_*(d[h.i] + d[h.j]);
        const FixedList<label, 4> nodes(surfaceFold::nodes(h));
        forAll(nodes, n)
        {
            gradient[nodes[n]] += k*f.productGradient(n);
        }
    }
    const scalarField areaDerivative(2*stiffness_*d*(d - 2*M/A)/3);
    for (const triFace& t : surface_.triangles())
    {
        const FixedList<vector, 3> g(closedSurface::areaGradient(t, x));
        const scalar k =
            areaDerivative[t[0]] + areaDerivative[t[1]] + areaDerivative[t[2]];
        forAll(t, n)
        {
            gradient[t[n]] += k*g[n];
        }
    }
    if (tangent)
    {
        addTangent(x, M, A, *tangent);
    }
    return 2*stiffness_*sum(A*sqr(d));
}


void Foam::membraneModels::helfrich::addTangent
(
    const pointField& x,
    const scalarField& M,
    const scalarField& A,
    membraneTangent& tangent
) const
{
    // The gradients of what is squared, 2 sqrt(kappa A) d, by the nodes around
    List<vectorField> g(neighbours_.size());
    forAll(neighbours_, i)
    {
        g[i] = vectorField(neighbours_[i].size(), Zero);
    }
    const auto addTo = [&](const label i, const label node, const vector& v)
    {
        g[i][neighbours_[i].find(node)] += v;
    };

    const scalarField dM(2*Foam::sqrt(stiffness_/A));
    const scalarField dA(-0.25*dM*(2*M/A + curvature_));
    for (const closedSurface::hinge& h : surface_.hinges())
    {
        const surfaceFold f(h, x);
        const FixedList<label, 4> nodes(surfaceFold::nodes(h));
        forAll(nodes, k)
        {
            const vector v(0.25*f.productGradient(k));
            addTo(h.i, nodes[k], dM[h.i]*v);
            addTo(h.j, nodes[k], dM[h.j]*v);
        }
    }
    for (const triFace& t : surface_.triangles())
    {
        const FixedList<vector, 3> triangleGradient(closedSurface::areaGradient(t, x));
        for (const label i : t)
        {
            forAll(t, n)
            {
                addTo(i, t[n], dA[i]/3*triangleGradient[n]);
            }
        }
    }

    forAll(neighbours_, i)
    {
        const auto v = membraneTangent::asVector(g[i]);
        tangent.addDense
        (
            neighbours_[i], neighbours_[i].size(), Eigen::MatrixXd(v*v.transpose())
        );
    }
}
