/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "mechanicalTest.H"
#include "equilibrium.H"

namespace Foam
{
    defineTypeNameAndDebug(mechanicalTest, 0);
    defineRunTimeSelectionTable(mechanicalTest, dictionary);
}


Foam::mechanicalTest::mechanicalTest(const dictionary& dict)
:
    reading_(clumpExtent::readingNames.get("reading", dict)),
    pulledPart_
    (
        dict.getCheckOrDefault<scalar>
        (
            "pulledPart", 0.02, [](scalar x){ return x > 0 && x <= 0.5; }
        )
    )
{}


void Foam::mechanicalTest::refuseSpheres
(
    const clumpType& type,
    const dictionary& dict
)
{
    if (!type.hasTriangles())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shape': this test is one of a closed surface (icosphere,"
            << " biconcave, surfaceFile, filled)." << exit(FatalIOError);
    }
}


Foam::Pair<Foam::scalar> Foam::mechanicalTest::extents
(
    const clumpType& type,
    const pointField& x
) const
{
    const bool nodes = type.hasTriangles();
    const scalarField radii(nodes ? scalarField(x.size(), Zero) : type.radii());
    const auto reading = nodes ? clumpExtent::reading::spheres : reading_;
    return Pair<scalar>
    (
        clumpExtent::along(vector(1, 0, 0), x, radii, reading),
        clumpExtent::along(vector(0, 1, 0), x, radii, reading)
    );
}


Foam::externalForces Foam::mechanicalTest::pull
(
    const clumpType& type,
    const scalar F
) const
{
    return equilibrium::stretch
    (
        type, vector(F, 0, 0), type.hasTriangles() ? pulledPart_ : 0
    );
}


Foam::dictionary Foam::mechanicalTest::oppositeForces
(
    const clumpType& type,
    const scalar F
) const
{
    const auto ext(pull(type, F));
    labelList plus;
    labelList minus;
    forAll(ext.f, i)
    {
        if (ext.f[i].x() > 0)
        {
            plus.append(i);
        }
        else if (ext.f[i].x() < 0)
        {
            minus.append(i);
        }
    }
    dictionary result;
    result.set("type", "oppositeForces");
    result.set("clumpType", "fitted");
    result.set("direction", vector(1, 0, 0));
    result.set("plus", plus);
    result.set("minus", minus);
    result.set("force", F);
    return result;
}
