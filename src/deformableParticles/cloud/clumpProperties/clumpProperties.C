/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpProperties.H"
#include "accuracyLevel.H"
#include "ignoreOverflow.H"
#include "checkedEntries.H"
#include "clumpKind.H"
#include "foamCompat.H"
#include "fvMesh.H"
#include "modelSelection.H"
#include "sizeClasses.H"
#include "unreadEntries.H"
#include "uniformDimensionedFields.H"

namespace
{

using namespace Foam;

//- The models of a case that does not choose others
dictionary accurateModels()
{
    IStringStream is
    (
        "integrator { type implicitEuler; tolerance 1e-9; maxIterations 100; }"
        "rotation { type wholeClump; }"
        "couplingScheme { type robin; }"
        "immersedBoundary"
        "{"
        "    solidFraction { type signedDistance; }"
        "    forcing { type sharp; }"
        "    hydrodynamicForce { type momentumExchange; }"
        "    interiorDilation yes;"
        "}"
    );
    return dictionary(is);
}


//- Add the entries that dict lacks, whole models and not parts of them
void complete(dictionary& dict, const dictionary& usual)
{
    for (const entry& e : usual)
    {
        dictionary* given = dict.findDict(e.keyword(), keyType::LITERAL);
        if (given && e.isDict() && !e.dict().found("type"))
        {
            complete(*given, e.dict());
        }
        else if (!dict.found(e.keyword()))
        {
            dict.add(e);
        }
    }
}

}


Foam::IOdictionary Foam::readClumpProperties(const fvMesh& mesh)
{
    // A number too large for the machine becomes infinite, and is refused where it is read
    const ignoreOverflow overflow;
    const IOobject io
    (
        "clumpProperties", mesh.time().constant(), mesh, IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
    if (typeFilePath<IOdictionary>(io).empty())
    {
        FatalErrorInFunction
            << "There is no file " << mesh.time().constant()/io.name() << ", which says"
            << " what clumps there are and where." << nl
            << "    setClumps -template healthy writes it for red cells, setClumps"
            << " -template bead for a sphere." << exit(FatalError);
    }
    return IOdictionary(io);
}


Foam::vector Foam::gravityOf(const fvMesh& mesh)
{
    const ignoreOverflow overflow;
    const uniformDimensionedVectorField g
    (
        IOobject
        (
            "g", mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE, false
        ),
        dimensionedVector(dimAcceleration, Zero)
    );
    if (g.dimensions() != dimAcceleration || !physical(g.value()))
    {
        FatalErrorInFunction
            << "The acceleration in " << g.objectPath() << " is "
            << g.dimensions() << ' ' << g.value() << "; it must be finite and"
            << " have the dimensions " << dimAcceleration << exit(FatalError);
    }
    return g.value();
}


Foam::dictionary Foam::completeClumpProperties
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    dictionary result
    (
        withPresentNames(dict, {{"exchange", "couplingScheme"}})
    );
    accuracyLevel::refuseOldEntry(result);
    if (result.found("aggregation"))
    {
        FatalIOErrorInFunction(result)
            << "Entry 'aggregation' has become a dictionary of 'surfaceForces', with a"
            << " name of your own and 'type depletion;'" << exit(FatalIOError);
    }
    wordList entries
    ({
        "types", "placement", "injection", "integrator", "contactModel",
        "wallContactModel", "lubrication", "surfaceForces", "loads", "effects", "rotation",
        "couplingScheme", "immersedBoundary", "openPatches", "typesMayChange",
        "accuracyLevel", "rho"
    });
    entries.append(clumpKind::entries());
    refuseUnread
    (
        result,
        typeFilePath<IOdictionary>
        (
            IOobject("clumpProperties", mesh.time().constant(), mesh)
        ),
        entries
    );
    if (result.isDict("types"))
    {
        result.set("types", sizeClasses::expanded(result.subDict("types")));
    }
    complete(result, accurateModels());
    return result;
}
