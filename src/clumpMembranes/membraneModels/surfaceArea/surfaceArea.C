/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceArea.H"
#include "triangleElasticity.H"

namespace Foam
{
namespace membraneModels
{
    defineTypeNameAndDebug(surfaceArea, 0);
    addToRunTimeSelectionTable(membraneModel, surfaceArea, dictionary);
}
}


Foam::membraneModels::surfaceArea::surfaceArea
(
    const dictionary& dict,
    const closedSurface& surface,
    const pointField& x0
)
:
    surface_(surface),
    modulus_(getPositive(dict, "areaModulus")),
    area0_(surface.area(x0))
{
    checkEntries(dict, {"type", "areaModulus"});
}


Foam::scalar Foam::membraneModels::surfaceArea::add
(
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    const vectorField g(surface_.areaGradient(x));
    const scalar excess = surface_.area(x) - area0_;
    const scalar tension = modulus_*excess/area0_;
    gradient += tension*g;
    if (tangent)
    {
        tangent->addProduct(modulus_/area0_, g);
        addStretch(surface_, x, tension, *tangent);
    }
    return 0.5*tension*excess;
}


void Foam::membraneModels::surfaceArea::addTensions
(
    const pointField& x,
    symmTensorField& tensions
) const
{
    const scalar tension = modulus_*(surface_.area(x) - area0_)/area0_;
    addIsotropic(surface_, x, tension, tensions);
}


void Foam::membraneModels::surfaceArea::addIsotropic
(
    const closedSurface& surface,
    const pointField& x,
    const scalar tension,
    symmTensorField& tensions
)
{
    forAll(tensions, n)
    {
        tensions[n] +=
            tension*(symmTensor(I) - sqr(surface.triangles()[n].unitNormal(x)));
    }
}


void Foam::membraneModels::surfaceArea::addStretch
(
    const closedSurface& surface,
    const pointField& x,
    const scalar tension,
    membraneTangent& tangent
)
{
    typedef Eigen::Matrix<double, 6, 1> vector6;
    typedef Eigen::Matrix<double, 6, 6> matrix6;

    for (const triFace& t : surface.triangles())
    {
        const vector ea(x[t[1]] - x[t[0]]);
        const vector eb(x[t[2]] - x[t[0]]);
        const Eigen::Vector3d a(ea.x(), ea.y(), ea.z());
        const Eigen::Vector3d b(eb.x(), eb.y(), eb.z());

        // Of the area, half the root of q = |a x b|^2
        vector6 g;
        g << b.dot(b)*a - a.dot(b)*b, a.dot(a)*b - a.dot(b)*a;
        g *= 2;
        const scalar root = mag(ea ^ eb);
        const matrix6 H
        (
            tension
           *(
                0.25/root*triangleElasticity::areaHessian(a, b)
              - 0.125/pow3(root)*g*g.transpose()
            )
        );
        triangleElasticity::addEdges
        (
            t, triangleElasticity::kept(H, tangent), tangent
        );
    }
}
