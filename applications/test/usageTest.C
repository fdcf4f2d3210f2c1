/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
-------------------------------------------------------------------------------
Description
    Every usage dictionary in the library's headers is run: the models are
    selected from them. Folder, class and type of every model have one name.
    The headers are found through $DEFORMABLE_SRC.
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "clump/closedSurfaces.H"
#include "injection.H"
#include "openBox.H"
#include "shape.H"
#include "placement.H"
#include "conservationModel.H"
#include "integrator.H"
#include "contactModel.H"
#include "gapModel.H"
#include "load.H"
#include "solidFractionModel.H"
#include "forcingModel.H"
#include "hydrodynamicForceModel.H"
#include "rotationModel.H"
#include "couplingScheme.H"
#include "OSspecific.H"
#include "IFstream.H"

using namespace Foam;

namespace
{

//- The dictionaries between \verbatim and \endverbatim after Usage
dictionary usageOf(const fileName& header)
{
    IFstream is(header);
    string line, text;
    bool usage = false, inside = false;

    while (is.good())
    {
        is.getLine(line);
        if (line == "Usage")
        {
            usage = true;
        }
        else if (line.find("Usage") == 4 || line.find("Usage,") == 4)
        {
            usage = true;
        }
        else if (usage && line.find("\\verbatim") != string::npos)
        {
            inside = true;
        }
        else if (line.find("\\endverbatim") != string::npos)
        {
            usage = inside = false;
        }
        else if (inside)
        {
            text += line + "\n";
        }
    }
    return dictOf(text);
}


template<class Model, class... Args>
void run(const fileName& folder, const Args&... args)
{
    const fileName src(getEnv("DEFORMABLE_SRC"));
    label n = 0;

    for (const fileName& name : readDir(src/folder, fileName::DIRECTORY))
    {
        const fileName header(src/folder/name/name + ".H");
        const dictionary usage(usageOf(header));

        for (const entry& e : usage)
        {
            // Loads stand one level deeper
            const dictionary& d =
                e.dict().found("type")
              ? e.dict()
              : e.dict().subDict(e.dict().toc()[0]);

            INFO(header << ": " << e.keyword());
            CHECK_NOTHROW(selectModel<Model>(d, args...));
            ++n;
        }
    }

    INFO(src/folder);
    CHECK(n >= 1);
}

}


TEST_CASE("usage: what the headers show can be run", "[usage][serial]")
{
    REQUIRE(isDir(getEnv("DEFORMABLE_SRC")));

    // The file of fromSurface, in micrometres
    const fileName surface(getEnv("FOAM_CASE")/"constant"/"triSurface"/"cell.stl");
    mkDir(surface.path());
    ellipsoid(vector(3, 1.5, 1)).write(surface);
    run<clumpShapes::shape>("../clumpSpheres/shapes");
    run<clumpShapes::shape>("../clumpMembranes/shapes");
    rmDir(surface.path());

    // NOTE: a new family of models needs a line here, and a page in bin/developer/modelReference
    run<bondModel>("../clumpSpheres/bondModels");
    run<dampingModel>("../clumpSpheres/dampingModels");
    run<integrator>("integrators");
    run<integrator>("../paperModels/integrators");
    run<contactModel>("contact/contactModels");
    run<gapModel>("../clumpGaps/gapModels");
    run<load>("../clumpLoads/loads");
    for (const fileName folder : {"fluidCoupling", "../paperModels"})
    {
        run<solidFractionModel>(folder/"solidFractionModels");
        run<forcingModel>(folder/"forcingModels");
        run<hydrodynamicForceModel>(folder/"hydrodynamicForceModels");
        run<rotationModel>(folder/"rotationModels");
        run<couplingScheme>(folder/"couplingSchemes");
    }

    // Corners of a convex surface, which in their order enclose an area as well
    pointField corners(10);
    forAll(corners, i)
    {
        const scalar z = 0.9 - 0.2*i;
        const scalar r = Foam::sqrt(1 - sqr(z));
        corners[i] = 2e-6*point(r*Foam::cos(2.4*i), r*Foam::sin(2.4*i), z);
    }
    run<conservationModel>
    (
        "../clumpSpheres/conservationModels", corners, scalarField(corners.size(), 1e-6)
    );

    const autoPtr<polyMesh> mesh(openBox());
    const ghostExchange ghosts(*mesh);
    PtrList<clumpType> types(2);
    types.set(0, new clumpType("healthy", cellDict()));
    types.set(1, new clumpType("schizont", cellDict()));
    const HashTable<label> typeIds({{"healthy", 0}, {"schizont", 1}});
    run<injection>
    (
        "../clumpPlacement/injections", injection::site{*mesh, ghosts, types, typeIds, true}
    );
}


//- Every header below a folder that gives a class its TypeName
void checkNames(const fileName& folder, label& n)
{
    for (const fileName& sub : readDir(folder, fileName::DIRECTORY))
    {
        if (sub == "lnInclude" || sub == "Make")
        {
            continue;
        }
        checkNames(folder/sub, n);

        IFstream is(folder/sub/sub + ".H");
        string line, type;
        bool hasClass = false;
        while (is.good())
        {
            is.getLine(line);
            const auto start = line.find("TypeName(\"");
            if (start != string::npos)
            {
                type = line.substr(start + 10);
                type = type.substr(0, type.find('"'));
            }
            hasClass = hasClass || line == "class " + sub;
        }
        if (type.empty())
        {
            continue;
        }

        ++n;
        INFO(folder/sub << ": type " << type);
        CHECK(hasClass);
        if (type == "none")
        {
            // noDamping of the dampingModels
            REQUIRE(sub.size() > 2);
            string family(sub.substr(2));
            family[0] = std::tolower(family[0]);
            CHECK(sub.substr(0, 2) == "no");
            CHECK(family + "Models" == folder.name());
        }
        else
        {
            CHECK(type == sub);
        }
    }
}


TEST_CASE("usage: folder, class and type have one name", "[usage][serial]")
{
    label n = 0;
    checkNames(getEnv("DEFORMABLE_SRC")/"..", n);
    CHECK(n > 50);
}


TEST_CASE("usage: former names of types and entries", "[usage][serial]")
{
    CHECK
    (
        selectModel<rotationModel>(dictOf("type clump;"))->type()
     == "wholeClump"
    );
    CHECK
    (
        selectModel<solidFractionModel>(dictOf("type full;"))->type()
     == "fullCells"
    );
    CHECK
    (
        selectModel<couplingScheme>(dictOf("type explicit;"))->type()
     == "explicitCoupling"
    );
    CHECK_THROWS(selectModel<rotationModel>(dictOf("type sphere;")));

    // The former entry counts like the present one, but not beside it
    const clumpType type("cell", cellDict());
    const auto zeta = [&](const string& text)
    {
        scalarField z(type.size()), zR(type.size());
        selectModel<couplingScheme>(dictOf("type robin; " + text))->coefficients
        (
            type, 1e-3, 1000, 1e-3, z, zR
        );
        return z[0];
    };
    CHECK(zeta("margin 3;") == zeta("coefficient 3;"));
    CHECK(zeta("margin 3;") > 1.5*zeta("coefficient 1;"));
    CHECK_THROWS(zeta("margin 3; coefficient 1;"));
    CHECK(zeta("") == zeta("coefficient 1;"));
}
