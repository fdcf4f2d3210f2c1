/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "outerCorrectors.H"
#include "foamCompat.H"
#include "Switch.H"
#include "volFields.H"

namespace
{

//- Criteria of OpenFOAM for the end of the outer correctors, without the clumps
const Foam::wordList residualControls
({
    "residualControl", "outerCorrectorResidualControl"
});

}


constexpr Foam::label Foam::outerCorrectors::usualNumber;
constexpr Foam::scalar Foam::outerCorrectors::usualTolerance;

Foam::word Foam::outerCorrectors::dictionaryName(const fvMesh& mesh)
{
    const dictionary& fvSolution = mesh.solutionDict();
    const bool pimple = fvSolution.found("PIMPLE");
    if (pimple && fvSolution.found("PISO"))
    {
        FatalIOErrorInFunction(fvSolution)
            << "There are two dictionaries, PISO and PIMPLE, of which only one would be"
            << " read. Remove one of them." << exit(FatalIOError);
    }
    return pimple ? "PIMPLE" : "PISO";
}


bool Foam::outerCorrectors::solverGiven
(
    const fvMesh& mesh,
    const word& field
)
{
    return
        mesh.solutionDict().subOrEmptyDict("solvers").found
        (
            field, keyType::REGEX
        );
}


Foam::outerCorrectors::outerCorrectors(fvMesh& mesh, const bool iterates)
:
    pimpleControl(mesh, dictionaryName(mesh), false),
    iterates_(iterates),
    finalPressure_(solverGiven(mesh, "pFinal")),
    finalVelocity_(solverGiven(mesh, "UFinal"))
{
    residualControl_.clear();
    read();
    report();
    warnOfUnused();
}


void Foam::outerCorrectors::report() const
{
    const dictionary given(pimpleControl::dict());
    const label n = given.getOrDefault<label>("nOuterCorrectors", 0);

    if (n > 0 && n < nCorrPIMPLE_)
    {
        Info<< algorithmName_ << ": nOuterCorrectors " << n << " is raised to "
            << nCorrPIMPLE_ << ", which end at couplingTolerance "
            << given.getOrDefault<scalar>("couplingTolerance", usualTolerance)
            << ", because flow and clumps are iterated until"
            << " they agree. For exactly " << n
            << " of them give couplingTolerance 0" << nl << endl;
    }
}


void Foam::outerCorrectors::warnOfUnused() const
{
    const dictionary given(pimpleControl::dict());
    for (const word& name : residualControls)
    {
        if (iterates_ && given.found(name))
        {
            IOWarningInFunction(given)
                << "Entry '" << name << "' is not used: the outer correctors end at"
                << " couplingTolerance." << endl;
        }
    }
    const bool relaxed =
        (mesh_.relaxEquation("U") && mesh_.equationRelaxationFactor("U") != 1)
     || (mesh_.relaxField("p") && mesh_.fieldRelaxationFactor("p") != 1);
    if (relaxed)
    {
        IOWarningInFunction(mesh_.solutionDict().subDict("relaxationFactors"))
            << "The relaxation factors of U and p are not used: the steps of an unsteady"
            << " flow are solved without under-relaxation." << endl;
    }
}


const Foam::dictionary Foam::outerCorrectors::dict() const
{
    dictionary usual;
    usual.set("consistent", Switch(true));
    if (iterates_)
    {
        usual.set("nOuterCorrectors", usualNumber);
        usual.set("couplingTolerance", usualTolerance);
        usual.set("andersonDepth", 4);
    }

    // A copy of the case's dictionary has its name, for messages
    dictionary result(pimpleControl::dict());
    const bool toleranceGiven = result.found("couplingTolerance");
    for (const entry& e : usual)
    {
        if (!result.found(e.keyword()))
        {
            result.add(e);
        }
    }
    if (iterates_)
    {
        for (const word& name : residualControls)
        {
            result.remove(name);
        }
        const label n = result.get<label>("nOuterCorrectors");
        const bool exact = result.get<scalar>("couplingTolerance") == 0;
        const bool iterated = exact && n > 1 && startsFromRest();
        const bool cannotIterate = n == 1 && !exact;
        if (iterated || !toleranceGiven || cannotIterate)
        {
            result.set("nOuterCorrectors", max(n, usualNumber));
        }
        if (iterated)
        {
            result.set("couplingTolerance", usualTolerance);
        }
    }
    return result;
}


bool Foam::outerCorrectors::startsFromRest() const
{
    // At the start of a run there is no U yet
    const auto* U = mesh_.findObject<volVectorField>("U");
    return
        U && mesh_.time().timeIndex() == 1
     && gMax(magSqr(U->oldTime().primitiveField())) == 0;
}


bool Foam::outerCorrectors::loop()
{
    const bool goesOn = pimpleControl::loop();
    if (!finalVelocity_)
    {
        endFinalIteration(mesh_);
    }
    return goesOn;
}


Foam::label Foam::outerCorrectors::least() const
{
    const dictionary given(pimpleControl::dict());
    const bool exact =
        given.getOrDefault<scalar>("couplingTolerance", usualTolerance) == 0;
    return exact ? given.getOrDefault<label>("nOuterCorrectors", usualNumber) : 1;
}


void Foam::outerCorrectors::end()
{
    corr_ = 0;
    converged_ = false;
    endFinalIteration(mesh_);
}


bool Foam::outerCorrectors::finalPressure() const
{
    return finalPressure_ && finalInnerIter();
}
