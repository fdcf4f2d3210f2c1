/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "solverSettings.H"
#include "checkedEntries.H"
#include "outerCorrectors.H"
#include "ddtScheme.H"
#include "gradScheme.H"
#include "LduMatrix.H"
#include "lduMatrix.H"
#include "unitConversion.H"
#include "volFields.H"

namespace
{

using namespace Foam;

//- Entries of OpenFOAM's linear solvers
const wordList solverEntries
({
    "solver", "preconditioner", "smoother", "tolerance", "relTol", "minIter", "maxIter",
    "nSweeps", "nPreSweeps", "nPostSweeps", "nFinestSweeps", "cacheAgglomeration",
    "agglomerator", "nCellsInCoarsestLevel", "mergeLevels"
});


template<class Table>
void checkSelection
(
    const dictionary& dict,
    const word& what,
    const word& selected,
    const Table& table
)
{
    if (!table.found(selected))
    {
        FatalIOErrorInLookup(dict, what, selected, table) << exit(FatalIOError);
    }
}


//- A preconditioner is a word, or a dictionary that has it
word preconditioner(const dictionary& dict)
{
    const bool nested = bool(dict.findDict("preconditioner"));
    return
        nested
      ? dict.subDict("preconditioner").get<word>("preconditioner")
      : dict.get<word>("preconditioner");
}


template<class Solvers, class Smoothers, class Preconditioners>
void checkSolver
(
    const dictionary& dict,
    const Solvers& solvers,
    const Smoothers& smoothers,
    const Preconditioners& preconditioners
)
{
    refuseMisspelt(dict, solverEntries);
    const word solver(dict.get<word>("solver"));
    if (solver == "diagonal")
    {
        return;
    }
    checkSelection(dict, "matrix solver", solver, solvers);
    getNonNegativeOrDefault(dict, "tolerance", 0);
    getNonNegativeOrDefault(dict, "relTol", 0);

    if (solver == "GAMG" || solver == "smoothSolver")
    {
        // Several smoothers may stand in a list; they are left to OpenFOAM
        ITstream& is = dict.lookup("smoother");
        if (is.size() == 1 && is[0].isWord())
        {
            checkSelection
            (
                dict, "matrix smoother", is[0].wordToken(), smoothers
            );
        }
    }
    else if (dict.found("preconditioner"))
    {
        checkSelection
        (
            dict, "matrix preconditioner", preconditioner(dict), preconditioners
        );
    }
}


//- What a corrector leaves of the error of U is no change from one corrector to the next,
//  and the residual of the coupling does not see it. The forcing in the mesh cells of
//  clumps makes the matrix stiff for a smoother
void warnOfSolver(const dictionary& dict)
{
    if (dict.get<word>("solver") == "smoothSolver")
    {
        IOWarningInFunction(dict)
            << "Entry 'solver' is smoothSolver, which needs hundreds of sweeps where clumps"
            << " are. Give PBiCGStab with the preconditioner DILU." << endl;
    }
    constexpr scalar most = 0.01;
    const scalar relTol = dict.getOrDefault<scalar>("relTol", 0);
    if (relTol > most)
    {
        IOWarningInFunction(dict)
            << "Entry 'relTol' is " << relTol << ". The outer correctors end before U is"
            << " solved, and clumps drift across the flow. Give at most " << most
            << ", better 1e-4." << endl;
    }
}


//- Schemes without the part of a gradient across a face that lines between the centres of
//  mesh cells do not see where they meet the face obliquely
void warnOfScheme(const fvMesh& mesh)
{
    constexpr scalar most = 5;
    const tokenList& scheme = mesh.laplacianScheme("laplacian(nuEff,U)");
    for (const token& t : scheme)
    {
        const word name(t.isWord() ? t.wordToken() : word());
        if (name != "orthogonal" && name != "uncorrected")
        {
            continue;
        }
        const scalar angle = radToDeg
        (
            Foam::atan(gMax(mag(mesh.nonOrthCorrectionVectors().primitiveField())()))
        );
        if (angle > most)
        {
            IOWarningInFunction(mesh.schemesDict().subDict("laplacianSchemes"))
                << "The scheme of laplacian(nuEff,U) is '" << name << "', but the lines"
                << " between the centres of mesh cells meet faces at up to " << angle
                << " degrees from their normals. This leaves an error that does not"
                << " become smaller on a finer mesh. Give 'corrected' in laplacianSchemes"
                << " and in snGradSchemes." << endl;
        }
    }
}


//- Settings of the field, and of its final iteration where there are any
template<class Field>
wordList namesOf(const Field& field)
{
    wordList result({field.name()});
    const word last(field.name() + "Final");
    if (outerCorrectors::solverGiven(field.mesh(), last))
    {
        result.append(last);
    }
    return result;
}

}


void Foam::solverSettings::check(const volScalarField& p)
{
    const fvMesh& mesh = p.mesh();
    for (const word& name : namesOf(p))
    {
        checkSolver
        (
            mesh.solverDict(name),
            *lduMatrix::solver::symMatrixConstructorTablePtr_,
            *lduMatrix::smoother::symMatrixConstructorTablePtr_,
            *lduMatrix::preconditioner::symMatrixConstructorTablePtr_
        );
    }
    fv::gradScheme<scalar>::New(mesh, mesh.gradScheme("grad(p)"));
}


void Foam::solverSettings::check(const volVectorField& U, const bool coupled)
{
    const fvMesh& mesh = U.mesh();
    for (const word& name : namesOf(U))
    {
        const dictionary& dict = mesh.solverDict(name);
        if (dict.getOrDefault<word>("type", "segregated") == "segregated")
        {
            checkSolver
            (
                dict,
                *lduMatrix::solver::asymMatrixConstructorTablePtr_,
                *lduMatrix::smoother::asymMatrixConstructorTablePtr_,
                *lduMatrix::preconditioner::asymMatrixConstructorTablePtr_
            );
            if (coupled)
            {
                warnOfSolver(dict);
            }
        }
    }
    warnOfScheme(mesh);
    const word ddt(mesh.ddtScheme("ddt(U)"));
    if (ddt == "steadyState")
    {
        FatalIOErrorInFunction(mesh.schemesDict().subDict("ddtSchemes"))
            << "The scheme of ddt(U) is steadyState, but the clumps move in time and"
            << " the pressure equation needs the inertia of a step. Use Euler or"
            << " another scheme of unsteady flows." << exit(FatalIOError);
    }
    fv::ddtScheme<vector>::New(mesh, mesh.ddtScheme("ddt(U)"));
}
