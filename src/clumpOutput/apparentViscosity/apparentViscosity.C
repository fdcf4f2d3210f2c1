/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "apparentViscosity.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntries.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(apparentViscosity, 0);
    addToRunTimeSelectionTable(functionObject, apparentViscosity, dictionary);
}
}


Foam::functionObjects::apparentViscosity::apparentViscosity
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    suspensionTable(name, runTime, dict, typeName, {"section", "drive"}),
    shear_(false)
{
    read(dict);
}


bool Foam::functionObjects::apparentViscosity::read(const dictionary& dict)
{
    const bool good = suspensionTable::read(dict);
    section_ = crossSection(dict, axes(), mesh_);
    const word drive(getEntry<word>(dict, "drive"));
    shear_ = drive == "shear";
    if ((!shear_ && drive != "pressure") || (shear_ && section_.tube()))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'drive' is " << drive << ". Valid: pressure"
            << (section_.tube() ? "" : ", shear") << exit(FatalIOError);
    }
    return good;
}


Foam::functionObjects::tableHeader
Foam::functionObjects::apparentViscosity::header() const
{
    return
        tableHeader("Apparent viscosity")
       .add("tau", "Pa").add("rate", "1/s").add("mu", "Pa.s").add("muRel")
       .add("Ub", "m/s")
       .explain("tau rate", "stress at the walls, and the shear rate there of a Newtonian"
            " fluid with the same mean velocity (drive pressure) or the same velocity of"
            " the walls (drive shear)")
       .explain("mu muRel", "tau/rate, and this over the viscosity of the fluid")
       .explain("time Ub", "mean velocity of fluid and clumps along the flow");
}


void Foam::functionObjects::apparentViscosity::addPatch
(
    const label patchi,
    UList<scalar>& values
) const
{
    const fvPatchVectorField& U = velocity()->boundaryField()[patchi];
    const auto& nuField = mesh_.lookupObject<volScalarField>("nu");
    const scalarField& nu = nuField.boundaryField()[patchi];
    const scalarField& area = U.patch().magSf();
    const vectorField slope(U.snGrad());

    forAll(area, facei)
    {
        const vector n(axes().local(U.patch().Sf()[facei])/area[facei]);
        if (mag(n.z()) > 0.5 || (!section_.tube() && mag(n.x()) < 0.5))
        {
            continue;
        }
        const bool isUpper = n.x() > 0;
        const scalar stress = nu[facei]*(slope[facei] & axes().flow);
        values[sums::force] += (shear_ && !isUpper ? -1 : 1)*stress*area[facei];
        values[sums::area] += area[facei];
        values[sums::viscosity] += nu[facei]*area[facei];
        values[isUpper ? sums::upper : sums::lower] +=
            (U[facei] & axes().flow)*area[facei];
        values[isUpper ? sums::upperArea : sums::lowerArea] += area[facei];
    }
}


bool Foam::functionObjects::apparentViscosity::write()
{
    if (!cloud().hasFluid())
    {
        FatalErrorInFunction
            << name() << ": there is no fluid whose viscosity could be measured"
            << exit(FatalError);
    }
    scalarList values(sums::number, Zero);
    forAll(mesh_.boundary(), patchi)
    {
        if (!mesh_.boundary()[patchi].coupled())
        {
            addPatch(patchi, values);
        }
    }
    values[sums::flow] =
        sum(mesh_.V()*(velocity()->primitiveField() & axes().flow));
    values[sums::volume] = sum(mesh_.V().field());
    sumUp(values);

    if (Pstream::master())
    {
        const scalar Ub = values[sums::flow]/values[sums::volume];
        const scalar h = section_.half();
        scalar rate = (section_.tube() ? 4 : 3)*Ub/h;
        if (shear_)
        {
            rate =
            (
                ratio(values[sums::upper], values[sums::upperArea])
              - ratio(values[sums::lower], values[sums::lowerArea])
            )/(2*h);
        }
        const scalar rho = cloud().fluidDensity();
        const scalar tau =
            (shear_ ? 1 : -1)*rho*ratio(values[sums::force], values[sums::area]);
        const scalar nu = ratio(values[sums::viscosity], values[sums::area]);
        const scalar mu = ratio(tau, rate);
        writeRow({tau, rate, mu, mu/(rho*nu), Ub});
    }

    return true;
}
