/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Application
    calibrateClump

Description
    Fits the parameters of a clump type to a measured curve or, without free
    parameters, compares a clump type with the curve.

        calibrateClump [-evaluate] [-variant n] calibration

    The argument is the dictionary described below. All variants of the clump type
    are fitted at once, or only variant n. With -evaluate the clump type is compared
    as it is. The results are written into a folder named after the dictionary with
    the ending .fit or .evaluated (and n):

        clumpType       the fitted type, to be copied to constant/clumpProperties
        loads           the entry loads of clumpProperties with which a case repeats the
                        experiment at the last abscissa (several variants: loads0, ...);
                        the type has the name fitted
        residuals.csv   the residual of every point
        curve.csv       a smooth curve

    bin/plotCalibration draws the points and the curve.

    Usage
    \verbatim
        test        { type stretching; ... }    // mandatory: see mechanicalTest
        data        { ... }                     // mandatory: see measurement
        type        { ... }                     // mandatory: see clumpType
        variants    ( {...} {...} );            // default none: changes to the type
        parameters  { ... }                     // mandatory: see freeParameters; may be {}
        norm        2;                          // [-], default 2: see fit
        starts      4;                          // [-], default 4: see fit
    \endverbatim

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "fit.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "cpuTime.H"

using namespace Foam;

namespace
{

void writeResiduals
(
    const fileName& file,
    const mechanicalTest& test,
    const measurement& data,
    const Eigen::VectorXd& z,
    const label nVariants
)
{
    OFstream os(file);
    os  << "variant,quantity," << test.abscissa()
        << ",measured,error,model,z,heldOut\n";

    const label n = data.points().size();
    for (label v = 0; v < nVariants; ++v)
    {
        forAll(data.points(), k)
        {
            const measurement::point& p = data.points()[k];
            const scalar r = z[v*n + k];
            os  << v << ',' << data.quantities()[p.quantity] << ','
                << data.abscissas()[p.abscissa] << ',' << p.value << ','
                << p.error << ',' << p.value + r*p.error << ',' << r << ','
                << label(p.heldOut) << nl;
        }
    }
}


//- States of a curve
constexpr label nStates = 101;

//- Returns the number of unstable states
label writeCurve
(
    const fileName& file,
    const mechanicalTest& test,
    const measurement& data,
    const fit& solution,
    const Eigen::VectorXd& y
)
{
    scalarField x(nStates);
    forAll(x, i)
    {
        x[i] = data.abscissas().last()*i/(x.size() - 1);
    }

    OFstream os(file);
    const wordList quantities(test.quantities());
    os << "variant," << test.abscissa();
    for (const word& q : quantities)
    {
        os << ',' << q;
    }
    os << nl;

    label unstable = 0;
    for (label v = 0; v < solution.nVariants(); ++v)
    {
        label n = 0;
        const List<scalarField> curve(test.predict(solution.type(y, v), x, &n));
        unstable += n;
        forAll(x, i)
        {
            os << v << ',' << x[i];
            forAll(quantities, q)
            {
                os << ',' << curve[q][i];
            }
            os << nl;
        }
    }
    return unstable;
}


//- The load at the last abscissa, of each variant, with the places of the spheres that
//  are pulled
void writeLoads
(
    const fileName& folder,
    const mechanicalTest& test,
    const measurement& data,
    const fit& solution,
    const Eigen::VectorXd& y
)
{
    for (label v = 0; v < solution.nVariants(); ++v)
    {
        const dictionary dict(solution.type(y, v));
        const clumpType type("fit", dict);
        const dictionary loads(test.loads(dict, data.abscissas().last()));
        const fileName file
        (
            "loads" + (solution.nVariants() > 1 ? Foam::name(v) : word())
        );
        OFstream os(folder/file);
        Info<< nl << file << nl;
        loads.write(os, false);
        loads.write(Info, false);

        for (const entry& e : loads)
        {
            for (const word key : {"plus", "minus"})
            {
                for (const label i : e.dict().get<labelList>(key))
                {
                    Info<< "// " << key << ": "
                        << (type.hasTriangles() ? "node " : "sphere ") << i << " of "
                        << type.size() << ", at " << type.centres()[i]
                        << " m at rest" << nl;
                }
            }
        }
    }
}


//- Warn of a first point that is far from the clump at abscissa 0, as where
//  elongations are given for diameters
void warnOfOtherQuantity
(
    const mechanicalTest& test,
    const measurement& data,
    const dictionary& type
)
{
    const List<scalarField> rest(test.predict(type, scalarField(1, 0.0)));
    const wordList names(test.quantities());
    labelHashSet seen;
    for (const measurement::point& p : data.points())
    {
        const word& name = data.quantities()[p.quantity];
        const scalar atZero = rest[names.find(name)][0];
        if
        (
            seen.insert(p.quantity)
         && mag(p.value - atZero) > 0.5*mag(atZero)
        )
        {
            WarningInFunction
                << "The first value of " << name << " in " << data.file()
                << " is " << p.value << ", but the clump type has " << atZero
                << " at " << test.abscissa() << " 0. Is the column another"
                << " quantity (an elongation, say) or in another unit?" << endl;
        }
    }
}

dictionary readDictionary(const fileName& file)
{
    IFstream is(file);
    if (!is.good())
    {
        FatalErrorInFunction
            << "Cannot read the dictionary " << file << exit(FatalError);
    }
    return dictionary(is);
}


//- The variants of the type that are fitted, with the option -variant only one of them,
//  whose number is added to the name of the folder
PtrList<dictionary> chosenVariants
(
    const dictionary& dict,
    const argList& args,
    fileName& folder
)
{
    PtrList<dictionary> variants;
    if (dict.found("variants"))
    {
        variants = PtrList<dictionary>(dict.lookup("variants"));
    }
    if (args.found("variant"))
    {
        const label v = args.get<label>("variant");
        if (v < 0 || v >= variants.size())
        {
            FatalIOErrorInFunction(dict)
                << "Option -variant is " << v << ", but the entry 'variants' has "
                << variants.size() << ", counted from 0." << exit(FatalIOError);
        }
        PtrList<dictionary> one(1);
        one.set(0, variants.set(v, nullptr));
        variants.transfer(one);
        folder += Foam::name(v);
    }
    return variants;
}


void refuseTooFewPoints
(
    const dictionary& dict,
    const label nFitted,
    const label nParameters
)
{
    if (nFitted < nParameters)
    {
        FatalIOErrorInFunction(dict)
            << "Only " << nFitted << " points are fitted, fewer than the "
            << nParameters << " parameters"
            << (dict.subDict("data").found("heldOut") ? " (see heldOut)" : "")
            << '.' << exit(FatalIOError);
    }
}


void printParameters
(
    const freeParameters& parameters,
    const Eigen::VectorXd& y,
    const scalarField& sigma
)
{
    Info<< "parameter" << tab << "value" << tab << "+-" << nl;
    forAll(sigma, i)
    {
        const scalar value = parameters.value(i, y[i]);
        Info<< parameters.name(i) << tab << value << tab << sigma[i]
            << (parameters.atBound(i, value) ? "  at its bound" : "") << nl;
    }
}


//- z: (model - measured)/error of all points, variant by variant
void printPoints
(
    const mechanicalTest& test,
    const measurement& data,
    const fit& solution,
    const Eigen::VectorXd& z
)
{
    const label n = data.points().size();
    Info<< nl << "line" << tab << "quantity" << tab << test.abscissa() << tab
        << "measured" << tab << "(model - measured)/error, per variant" << nl;
    forAll(data.points(), k)
    {
        const measurement::point& p = data.points()[k];
        Info<< p.line << tab << data.quantities()[p.quantity] << tab
            << data.abscissas()[p.abscissa] << tab << p.value;
        for (label v = 0; v < solution.nVariants(); ++v)
        {
            Info<< tab << z[v*n + k];
        }
        Info<< (data.points()[k].heldOut ? "  held out" : "") << nl;
    }

    Info<< nl;
    for (const bool heldOut : {false, true})
    {
        const Eigen::VectorXd part(solution.part(z, heldOut));
        if (part.size())
        {
            Info<< (heldOut ? "held out: " : "") << "largest |z| "
                << part.cwiseAbs().maxCoeff() << ", RMS "
                << part.norm()/Foam::sqrt(scalar(part.size())) << nl;
        }
    }
}

}


int main(int argc, char* argv[])
{
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addNote("Fit the parameters of a clump type to a measured curve");
    argList::addArgument("dictionary", "what to fit to what");
    argList::addBoolOption("evaluate", "compare the type as it is");
    argList::addOption("variant", "number", "fit this variant alone");
    argList args(argc, argv);

    const cpuTime timer;
    const fileName file(args[1]);
    const dictionary dict(readDictionary(file));

    const autoPtr<mechanicalTest> test
    (
        selectModel<mechanicalTest>(dict.subDict("test"))
    );
    const measurement data
    (
        dict.subDict("data"), file.path(), test->quantities()
    );
    const dictionary& type = dict.subDict("type");
    const bool evaluate = args.found("evaluate");
    const freeParameters parameters
    (
        evaluate ? dictionary::null : dict.subDict("parameters"), type
    );

    fileName folder(file + (evaluate ? ".evaluated" : ".fit"));
    const PtrList<dictionary> variants(chosenVariants(dict, args, folder));
    refuseTooFewPoints
    (
        dict, data.nFitted()*max(1, variants.size()), parameters.size()
    );

    warnOfOtherQuantity(*test, data, type);
    for (const dictionary& variant : variants)
    {
        dictionary changed(type);
        changed.merge(variant);
        test->predict(changed, scalarField(1, 0.0));
    }
    fit solution(*test, data, parameters, type, variants);
    const Eigen::VectorXd y
    (
        solution.run
        (
            getPositiveOrDefault(dict, "norm", 2),
            dict.found("starts") ? getNumber(dict, "starts", 1, 1000) : 4
        )
    );
    const Eigen::VectorXd z(solution.residuals(y));
    const scalarField sigma(solution.uncertainties(y));

    mkDir(folder);
    writeResiduals
    (
        folder/"residuals.csv", *test, data, z, solution.nVariants()
    );
    const label unstable =
        writeCurve(folder/"curve.csv", *test, data, solution, y);

    {
        OFstream os(folder/"clumpType");
        solution.type(y).write(os, false);
    }
    writeLoads(folder, *test, data, solution, y);

    if (solution.nRejected())
    {
        Info<< nl << "Rejected " << solution.nRejected()
            << " candidates that are not admissible, the first "
            << solution.firstRefusal().c_str() << nl;
    }
    Info<< nl << data.points().size() << " points of " << data.file() << nl << nl;
    printParameters(parameters, y, sigma);
    printPoints(*test, data, solution, z);
    if (!clumpType("fit", solution.type(y)).hasTriangles())
    {
        Info<< "unstable states " << unstable << " of "
            << nStates*solution.nVariants() << " in curve.csv" << nl;
        if (unstable)
        {
            WarningInFunction
                << "In a case, the clump buckles out of these states and leaves the curve. A"
                << " larger torsional or bending stiffness in the clump type to start with"
                << " keeps it in them." << endl;
        }
    }
    Info<< "volume [m3]";
    for (label v = 0; v < solution.nVariants(); ++v)
    {
        Info<< ' ' << clumpType("fit", solution.type(y, v)).volume();
    }
    Info<< nl
        << solution.nCalls() << " curves in " << timer.elapsedCpuTime()
        << " s of processor time" << nl << "Wrote " << folder << nl << endl;

    UPstream::exit(0);
    return 0;
}
