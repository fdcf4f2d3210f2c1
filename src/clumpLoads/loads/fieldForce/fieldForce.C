/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fieldForce.H"
#include "FlatOutput.H"
#include "fvcGrad.H"
#include "volFields.H"

namespace Foam
{
namespace loads
{
    defineTypeNameAndDebug(fieldForce, 0);
    addToRunTimeSelectionTable(load, fieldForce, dictionary);
}
}


Foam::loads::fieldForce::fieldForce(const dictionary& dict)
:
    load(dict, {"field", "coefficient", "coefficientCoeffs", "per"}),
    dict_(dict),
    field_(getEntry<word>(dict, "field")),
    coefficient_(Function1<scalar>::New("coefficient", dict))
{
    const word per(dict.getOrDefault<word>("per", "volume"));
    if (per != "volume" && per != "clump")
    {
        FatalIOErrorInLookup
        (
            dict, "per", per, (HashTable<label>({{"volume", 0}, {"clump", 1}}))
        )   << exit(FatalIOError);
    }
    perVolume_ = per == "volume";
}


const Foam::volScalarField& Foam::loads::fieldForce::find
(
    const fvMesh& mesh
) const
{
    if (const auto* present = mesh.findObject<volScalarField>(field_))
    {
        return *present;
    }
    IOobject io
    (
        field_,
        mesh.time().findInstance
        (
            mesh.dbDir(), field_, IOobject::READ_IF_PRESENT
        ),
        mesh,
        IOobject::MUST_READ,
        IOobject::AUTO_WRITE
    );
    if (!io.typeHeaderOk<volScalarField>(true, true, false))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'field' is " << field_ << ", but neither the solver nor a time up"
            << " to " << mesh.time().timeName() << " nor constant has a volScalarField of"
            << " this name. Fields of the solver: "
            << flatOutput(mesh.sortedNames<volScalarField>()) << exit(FatalIOError);
    }
    if (io.instance() == mesh.time().constant())
    {
        io.writeOpt() = IOobject::NO_WRITE;
    }
    auto* read = new volScalarField(io, mesh);
    read->store();
    return *read;
}


Foam::tmp<Foam::volVectorField> Foam::loads::fieldForce::field
(
    const fvMesh& mesh
) const
{
    return fvc::grad(find(mesh));
}


void Foam::loads::fieldForce::add(const site& clump, externalForces& ext) const
{
    const scalarField V(clump.type.nominalVolumes());
    const scalar c =
        coefficient_->value(clump.time())
       /(perVolume_ ? 1 : sum(V)/clump.type.part());
    ext.f += c*V*clump.field;
}
