/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "compression.H"
#include "checkedEntries.H"
#include "membraneEquilibrium.H"

namespace Foam
{
namespace mechanicalTests
{
    defineTypeNameAndDebug(compression, 0);
    addToRunTimeSelectionTable(mechanicalTest, compression, dictionary);
}
}


Foam::mechanicalTests::compression::compression(const dictionary& dict)
{
    checkEntries(dict, {"type"});
}


Foam::scalar Foam::mechanicalTests::compression::plates::force
(
    const pointField& x
) const
{
    scalar result = 0;
    forAll(areas, i)
    {
        result += stiffness*areas[i]*max(depth(x[i]), scalar(0));
    }
    return result;
}


Foam::vectorField Foam::mechanicalTests::compression::plates::turnGradient
(
    const direction c
) const
{
    vector axis(Zero);
    axis[c] = 1;
    return axis ^ start;
}


Foam::scalar Foam::mechanicalTests::compression::plates::add
(
    const vectorField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    scalar energy = 0;
    for (direction c = 0; c < vector::nComponents; ++c)
    {
        const vectorField v(turnGradient(c));
        const scalar turned = sum(v & x);
        energy += 0.5*turning*sqr(turned);
        gradient += turning*turned*v;
        if (tangent)
        {
            tangent->addProduct(turning, v);
        }
    }
    forAll(areas, i)
    {
        const scalar inside = depth(x[i]);
        if (inside <= 0)
        {
            continue;
        }
        const scalar k = stiffness*areas[i];
        energy += 0.5*k*sqr(inside);
        gradient[i].z() += k*inside*sign(x[i].z());
        if (tangent)
        {
            Eigen::Matrix3d block(Eigen::Matrix3d::Zero());
            block(2, 2) = k;
            tangent->add(i, i, block);
        }
    }
    return energy;
}


Foam::List<Foam::scalarField> Foam::mechanicalTests::compression::predict
(
    const dictionary& dict,
    const UList<scalar>& indentations,
    label* unstable
) const
{
    const clumpType type("fit", dict);
    refuseSpheres(type, dict);
    if (unstable)
    {
        *unstable = 0;
    }
    const closedSurface& surface = type.surface();
    const membraneEquilibrium solver(type, dict);
    const scalarField areas(surface.nodeAreas(type.centres()));
    const scalar R = type.halfWidth();

    // A thousand times that of the body, whose energy is this one for a strain of one
    const scalar E = membraneMechanics(type, dict).shearStiffness();
    const scalar stiffness = 1e3*E/type.volume()/R;

    pointField x(type.centres());
    scalar top = -GREAT;
    scalar bottom = GREAT;
    for (const point& p : x)
    {
        top = max(top, p.z());
        bottom = min(bottom, p.z());
    }
    for (point& p : x)
    {
        p.z() -= 0.5*(top + bottom);
    }
    const pointField start(x);

    // Of the order of a tenth of that energy for a tenth of a radian
    const scalar turning = 10*E/sqr(sum(magSqr(start)));

    List<scalarField> result(1, scalarField(indentations.size(), GREAT));
    forAll(indentations, k)
    {
        const plates both
        {
            areas, start, stiffness, turning, 0.5*(top - bottom - indentations[k])
        };
        const auto touched = [&]
        (
            const vectorField& y, vectorField& gradient, membraneTangent* tangent
        )
        {
            return both.add(y, gradient, tangent);
        };
        if (both.height <= 0 || !solver.find(vectorField(x.size(), Zero), x, touched))
        {
            x = start;
            continue;
        }
        result[0][k] = 0.5*both.force(x);
    }
    return result;
}
