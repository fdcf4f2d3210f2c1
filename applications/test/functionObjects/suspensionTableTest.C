/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCloud.H"
#include "apparentViscosity.H"
#include "cellFreeLayer.H"
#include "clumpProfiles.H"
#include "contactStress.H"
#include "fixedValueFvPatchFields.H"
#include "haematocrit.H"
#include "mathematicalConstants.H"
#include "OSspecific.H"
#include <fstream>
#include <map>
#include <sstream>

using namespace Foam;
using constant::mathematical::pi;

namespace
{

//- A row by the names of its columns, units left out
typedef std::map<std::string, scalar> tableRow;

//- The table of a function object, read on the master; empty elsewhere
template<class Table>
std::vector<tableRow> tableOf(const string& entries)
{
    const fileName folder
    (
        testTime().globalPath()/"postProcessing"/Table::typeName
    );
    if (Pstream::master() && isDir(folder))
    {
        rmDir(folder);
    }
    Table(Table::typeName, testTime(), dictOf(entries)).write();

    std::vector<tableRow> rows;
    if (!Pstream::master())
    {
        return rows;
    }
    const fileName start(readDir(folder, fileName::DIRECTORY)[0]);
    std::ifstream file(folder/start/(Table::typeName + ".dat"));
    std::vector<std::string> names;
    for (std::string line; std::getline(file, line); )
    {
        std::istringstream cells(line);
        std::string cell;
        if (line.find_first_of("-0123456789") != line.find_first_not_of(' '))
        {
            names.clear();
            while (std::getline(cells, cell, '\t'))
            {
                names.push_back(cell.substr(0, cell.find(" [")));
            }
            continue;
        }
        tableRow row;
        for (const std::string& name : names)
        {
            std::getline(cells, cell, '\t');
            row[name] = std::stod(cell);
        }
        rows.push_back(row);
    }
    return rows;
}


//- Spheres without a fluid or in one
autoPtr<openCloud> spheres(const string& clumps, const scalar r, const bool wet)
{
    OStringStream os;
    os  << "types { sphere { shape { type chain; nSpheres 1; sphereRadius " << r
        << "; } density 1000; massModel union; motion free;"
        << " bondModel { type elastic; rigidities { normal 1e-12;"
        << " tangential 1e-12; bending 1e-24; torsional 1e-24; } }"
        << " dampingModel { type none; } } }"
        << "placement { type list; clumps (" << clumps.c_str() << "); }"
        << "integrator { type implicitEuler; tolerance 1e-9; maxIterations 200; }"
        << "contactModel { type hertz; reducedModulus 1000; restitution 1; }"
        << "wallContactModel { type hertz; reducedModulus 1000; restitution 1; }"
        << "rotation { type wholeClump; }"
        << "couplingScheme { type robin; coefficient 1; }"
        << "immersedBoundary { solidFraction { type tetClipping; }"
        << " forcing { type sharp; }"
        << " hydrodynamicForce { type momentumExchange; } interiorDilation yes; }"
        << "effects { fluid " << (wet ? "on" : "off") << "; }";
    return autoPtr<openCloud>(new openCloud(testMesh(), dictOf(os.str())));
}


//- A capsule across the periodic boundary, its centre 12.5 um above the lower wall
autoPtr<openCloud> capsule(const scalar r)
{
    OStringStream os;
    os  << "types { capsule { shape { type icosphere; radius " << r
        << "; subdivisions 4; } density 1000;"
        << " membrane { a { type neoHookean; shearModulus 1e-6; } } } }"
        << "placement { type list; clumps ("
        << "{ type capsule; position (1e-6 12.5e-6 3e-6); }); }"
        << "effects { fluid on; }";
    return autoPtr<openCloud>(new openCloud(testMesh(), dictOf(os.str())));
}


//- Profiles in four bins of a clump of this type, a sphere of 5 um with its centre 12.5 um
//  above the lower wall: caps in two bins and the rest between them, to a relative error
std::vector<tableRow> profilesOfSphere(const std::string& type, const scalar error)
{
    const auto rows
    (
        tableOf<functionObjects::clumpProfiles>("section slit; bins 4;")
    );
    if (rows.empty())
    {
        return rows;
    }
    REQUIRE(rows.size() == 4);

    const scalar r = 5e-6;
    const scalar bin = 5e-6*sqr(20e-6);
    const scalar cap = pi*sqr(2.5e-6)*(3*r - 2.5e-6)/3/bin;
    const scalar all = 4*pi*pow3(r)/3/bin;
    CHECK(rows[0].at("H") == 0);
    CHECK(rows[1].at("H") == Approx(cap).epsilon(error));
    CHECK(rows[2].at("H") == Approx(all - 2*cap).epsilon(error));
    CHECK(rows[3].at("H_" + type) == Approx(cap).epsilon(error));
    return rows;
}


//- A velocity along x that depends on y, with walls that have it, too
struct flowOf
{
    volVectorField U;
    volScalarField nu;

    explicit flowOf(const std::function<scalar(scalar)>& u)
    :
        U
        (
            IOobject("U", testTime().timeName(), testMesh()), testMesh(),
            dimensionedVector("U", dimVelocity, Zero),
            fixedValueFvPatchVectorField::typeName
        ),
        nu
        (
            IOobject("nu", testTime().timeName(), testMesh()), testMesh(),
            dimensionedScalar("nu", dimViscosity, 1.5e-6)
        )
    {
        forAll(U, celli)
        {
            U[celli].x() = u(testMesh().C()[celli].y());
        }
        forAll(testMesh().boundary(), patchi)
        {
            vectorField values(testMesh().boundary()[patchi].size(), Zero);
            forAll(values, facei)
            {
                values[facei].x() =
                    u(testMesh().boundary()[patchi].Cf()[facei].y());
            }
            if (!testMesh().boundary()[patchi].coupled())
            {
                U.boundaryFieldRef()[patchi] == values;
            }
        }
        U.correctBoundaryConditions();
    }
};

}


TEST_CASE("tables: haematocrit of clumps that are faster than the fluid", "[tables]")
{
    const flowOf flow([](const scalar) { return 2e-3; });
    testCloud t
    (
        point(1e-6, 10e-6, 10e-6), vector(3e-3, 1e-3, 0), Zero, "wholeClump", false
    );
    t.add(point(12e-6, 8e-6, 9e-6), vector(4e-3, 0, 0));

    for (const tableRow& row : tableOf<functionObjects::haematocrit>(""))
    {
        const scalar Ht = 2*t.type().nominalVolume()/8e-15;
        CHECK(row.at("Ht") == Approx(Ht).epsilon(1e-5));
        CHECK(row.at("phi") == Approx(2*t.type().volume()/8e-15).epsilon(1e-5));
        CHECK(row.at("Uc") == Approx(3.5e-3).epsilon(1e-5));
        CHECK(row.at("Hd") == Approx(Ht*3.5/2).epsilon(1e-5));
        CHECK(row.at("HtHd") == Approx(2/3.5).epsilon(1e-5));
        CHECK(row.at("Hd_cell") == Approx(row.at("Hd")));
    }
}


TEST_CASE("tables: no discharge haematocrit without a flow", "[tables]")
{
    const flowOf flow([](const scalar y) { return y - 10e-6; });
    testCloud t
    (
        point(10e-6, 10e-6, 10e-6), vector(1, 0, 0), Zero, "wholeClump", false
    );
    for (const tableRow& row : tableOf<functionObjects::haematocrit>(""))
    {
        CHECK(std::isnan(row.at("Hd")));
        CHECK(row.at("Uc") == Approx(1));
    }
}


TEST_CASE("tables: profiles of a sphere in a shear flow", "[tables]")
{
    // Across the periodic boundary, 7.5 to 17.5 um above the lower wall
    const flowOf flow([](const scalar y) { return 100*y; });
    const scalar r = 5e-6;
    const autoPtr<openCloud> cloud
    (
        spheres
        (
            "{ type sphere; position (1e-6 12.5e-6 3e-6); velocity (1e-3 0 0); }",
            r, false
        )
    );
    const auto rows(profilesOfSphere("sphere", 0.01));
    if (rows.empty())
    {
        return;
    }
    CHECK(std::isnan(rows[0].at("Uc")));
    CHECK(rows[2].at("Uc") == Approx(1e-3));
    for (label k = 0; k < 4; ++k)
    {
        CHECK(rows[k].at("s") == Approx((k + 0.5)*5e-6));
        CHECK(rows[k].at("U") == Approx(100*(k + 0.5)*5e-6));
    }
}


TEST_CASE("tables: profiles of a capsule that turns like a solid body", "[tables]")
{
    const flowOf flow([](const scalar y) { return 100*y; });
    const scalar r = 5e-6;
    autoPtr<openCloud> cloud(capsule(r));
    for (clumpParcel& p : *cloud)
    {
        // 1 mm/s at the centre, 50 1/s around it
        const point centre(p.centre(cloud->type(p)));
        forAll(p.state().u, i)
        {
            p.state().u[i] =
                vector(1e-3 + 50*(p.centres()[i].y() - centre.y()), 0, 0);
        }
    }
    const auto rows(profilesOfSphere("capsule", 0.02));
    if (rows.empty())
    {
        return;
    }

    // Of the centroid of a cap
    const scalar d = 2.5e-6;
    const scalar high = 0.75*sqr(2*r - d)/(3*r - d);
    CHECK(rows[1].at("Uc") == Approx(1e-3 - 50*high).epsilon(1e-3));
    CHECK(rows[2].at("Uc") == Approx(1e-3).epsilon(1e-3));
    CHECK(rows[3].at("Uc") == Approx(1e-3 + 50*high).epsilon(1e-3));
}


TEST_CASE("tables: layer between a sphere or capsule and two walls", "[tables]")
{
    const scalar r = 5e-6, h = 10e-6, y = 2.5e-6;
    const bool membrane = GENERATE(false, true);
    const autoPtr<openCloud> cloud
    (
        membrane
      ? capsule(r)
      : spheres("{ type sphere; position (1e-6 12.5e-6 3e-6); }", r, false)
    );

    // Outline of a circle at y above the middle, mean over 20 um
    scalar mean = h;
    const label n = 100000;
    for (label k = 0; k < n; ++k)
    {
        const scalar half = r*Foam::sqrt(1 - sqr((2*k + 1.0)/n - 1));
        mean -= (y + half + max(half - y, scalar(0)))/2*(2*r/n)/20e-6;
    }
    for
    (
        const tableRow& row : tableOf<functionObjects::cellFreeLayer>
        (
            "section slit; stations 1000;"
        )
    )
    {
        CHECK(row.at("layer") == Approx(mean).epsilon(1e-3));

        // The nodes of a capsule are farther out than the sphere with its volume
        CHECK(row.at("least") == Approx(h - y - r).epsilon(membrane ? 2e-3 : 1e-3));
    }
}


TEST_CASE("tables: viscosity of a fluid without stress of clumps", "[tables]")
{
    const autoPtr<openCloud> cloud
    (
        spheres("{ type sphere; position (10e-6 10e-6 10e-6); }", 4e-6, true)
    );
    const scalar rho = cloud->fluidDensity();
    const scalar nu = 1.5e-6, h = 10e-6, dy = 1e-6, c = 3e7;
    {
        const flowOf flow([](const scalar y) { return 1e-3 - 100*y; });
        for
        (
            const tableRow& row : tableOf<functionObjects::apparentViscosity>
            (
                "section slit; drive shear;"
            )
        )
        {
            CHECK(row.at("rate") == Approx(-100).epsilon(1e-4));
            CHECK(row.at("tau") == Approx(-100*rho*nu).epsilon(1e-4));
            CHECK(row.at("muRel") == Approx(1).epsilon(1e-4));
        }
    }

    // The discrete solution under a gradient of the pressure 2 c rho nu
    const flowOf flow
    (
        [&](const scalar y)
        {
            return
                y < 0.1*dy || y > 2*h - 0.1*dy
              ? 0 : c*(y*(2*h - y) + 0.25*sqr(dy));
        }
    );
    const scalar Ub = gSum(flow.U.primitiveField().component(0)())/8000;
    for
    (
        const tableRow& row : tableOf<functionObjects::apparentViscosity>
        (
            "section slit; drive pressure;"
        )
    )
    {
        CHECK(row.at("tau") == Approx(2*c*rho*nu*h).epsilon(1e-4));
        CHECK(row.at("Ub") == Approx(Ub).epsilon(1e-4));
        CHECK(row.at("muRel") == Approx(2*c*sqr(h)/(3*Ub)).epsilon(1e-4));
        CHECK(row.at("muRel") == Approx(1).epsilon(0.005));
    }
}


TEST_CASE("tables: stress of two spheres in contact", "[tables]")
{
    const scalar dt0 = testTime().deltaTValue();
    testTime().setDeltaT(1e-7, false);
    autoPtr<openCloud> cloud
    (
        spheres
        (
            "{ type sphere; position (19.9e-6 10e-6 10e-6); }"
            "{ type sphere; position (0.5e-6 10.6e-6 10e-6); }",
            0.5e-6, false
        )
    );
    cloud->evolve();
    cloud->accept();

    // The force on the first one from its motion, and the distance at the end. The spheres
    // bounce, so that the force acts at distances between those at the start and at the end
    vector force(Zero), apart(Zero);
    for (const clumpParcel& p : *cloud)
    {
        const clumpType& type = cloud->type(p);
        const bool first = p.origId() == 0;
        force += first ? type.mass()*p.step().end.u[0]/1e-7 : vector::zero;
        apart += (first ? 1 : -1)*p.step().end.x[0];
    }
    reduce(force, sumOp<vector>());
    reduce(apart, sumOp<vector>());
    apart -= vector(0.6e-6, 0.6e-6, 0);
    REQUIRE(mag(force) > 0);

    for (const tableRow& row : tableOf<functionObjects::contactStress>(""))
    {
        CHECK(row.at("contacts") == 1);
        CHECK(row.at("wall") == 0);
        CHECK(row.at("deepest") == Approx(2 - mag(apart)/0.5e-6).epsilon(1e-4));
        for (const auto& stress : {Pair<scalar>(row.at("flow"), force.x()),
            Pair<scalar>(row.at("shear"), force.y())})
        {
            const scalar least = 0.6e-6*stress.second()/8e-15;
            const scalar most = -apart.x()*stress.second()/8e-15;
            CHECK(stress.first() <= least*(1 - 1e-4));
            CHECK(stress.first() >= most*(1 + 1e-4));
            CHECK(stress.first() == Approx(most).epsilon(1e-2));
        }
        CHECK(row.at("shear") < 0);
        CHECK(mag(row.at("vorticity")) < 1e-6*mag(row.at("shear")));
    }
    testTime().setDeltaT(dt0, false);
}


TEST_CASE("tables: a channel of another section is refused", "[tables]")
{
    testCloud t(point(10e-6, 10e-6, 10e-6), Zero, Zero, "wholeClump", false);
    CHECK_THROWS(tableOf<functionObjects::cellFreeLayer>("section tube;"));
    CHECK_THROWS(tableOf<functionObjects::cellFreeLayer>("section pipe;"));
    CHECK_THROWS(tableOf<functionObjects::cellFreeLayer>(""));
    CHECK_THROWS
    (
        tableOf<functionObjects::apparentViscosity>("section slit; drive shear;")
    );
}


TEST_CASE("tables: of some types of clumps only", "[tables]")
{
    // 2 um and 8.5 um above the lower wall, 3.5 um below the upper one
    const scalar r = 1e-6, R = 4e-6;
    const flowOf flow([](const scalar) { return 1e-3; });
    openCloud cloud
    (
        testMesh(),
        dictOf
        (
            "types { small { shape { type chain; nSpheres 1; sphereRadius 1e-6; }"
            " density 1000; } large { shape { type chain; nSpheres 1;"
            " sphereRadius 4e-6; } density 1000; } }"
            "placement { type list; clumps ("
            "{ type small; position (19.9e-6 3e-6 5e-6); velocity (2e-3 0 0); }"
            "{ type large; position (12e-6 12.5e-6 12e-6); velocity (1e-3 0 0); }"
            "{ type small; position (3e-6 4e-6 15e-6); velocity (4e-3 0 0); }); }"
            "contactModel { type hertz; reducedModulus 1000; restitution 1; }"
            "wallContactModel { type hertz; reducedModulus 1000; restitution 1; }"
            "effects { fluid off; gravity off; }"
        )
    );
    const scalar V = 4*pi*pow3(r)/3, W = 4*pi*pow3(R)/3;

    for (const char* entry : {"types (small);", "types (large small);", ""})
    {
        const string types(entry);
        const bool both = types != "types (small);";
        INFO(types);
        for (const tableRow& row : tableOf<functionObjects::haematocrit>(types))
        {
            CHECK(row.at("Ht") == Approx((2*V + (both ? W : 0))/8e-15).epsilon(1e-4));
            CHECK(row.at("Ht_small") == Approx(2*V/8e-15).epsilon(1e-4));
            CHECK(row.at("Uc_small") == Approx(3e-3).epsilon(1e-4));
            CHECK(row.at("Hd_small") == Approx(6*V/8e-15).epsilon(1e-4));
            CHECK(row.count("Ht_large") == both);
            CHECK
            (
                row.at("Uc")
             == Approx(both ? (6e-3*V + 1e-3*W)/(2*V + W) : 3e-3).epsilon(1e-4)
            );
        }

        const auto rows
        (
            tableOf<functionObjects::clumpProfiles>("section slit; bins 4; " + types)
        );
        for (size_t k = 0; k < rows.size(); ++k)
        {
            CHECK(rows[k].at("n_small") == (k == 0 ? 2 : 0));
            CHECK
            (
                rows[k].at("H_small") == Approx(k == 0 ? 2*V/2e-15 : 0).epsilon(0.01)
            );
            CHECK(rows[k].count("n_large") == both);
            if (both)
            {
                CHECK(rows[k].at("n_large") == (k == 2));
                CHECK
                (
                    rows[k].at("H")
                 == Approx(rows[k].at("H_small") + rows[k].at("H_large"))
                );
            }
            else
            {
                CHECK(rows[k].at("H") == Approx(rows[k].at("H_small")));
                CHECK(std::isnan(rows[k].at("Uc")) == (k > 0));
            }
        }

        // Half of the discs of the small ones lies towards the lower wall, beyond the middle;
        // the large one lies across the middle
        for
        (
            const tableRow& row : tableOf<functionObjects::cellFreeLayer>
            (
                "section slit; stations 4000; " + types
            )
        )
        {
            const scalar h = 10e-6, L = 20e-6;
            const scalar small =
                h - 0.5*((7e-6 + 6e-6)*2*r + pi*sqr(r))/L;
            CHECK(row.at("layer_small") == Approx(small).epsilon(1e-3));
            CHECK(row.at("least") == Approx(2e-6).epsilon(1e-3));
            CHECK(row.count("layer_large") == both);
            if (both)
            {
                CHECK(row.at("layer_large") < h);
                CHECK(row.at("layer") < row.at("layer_large"));
                CHECK(row.at("layer") < row.at("layer_small"));
            }
            else
            {
                CHECK(row.at("layer") == Approx(row.at("layer_small")));
            }
        }
    }
    for (const tableRow& row : tableOf<functionObjects::cellFreeLayer>
        ("section slit; stations 4000; types (large);"))
    {
        CHECK(row.at("least") == Approx(3.5e-6).epsilon(1e-3));
        CHECK(row.at("layer") == Approx(row.at("layer_large")));
    }
    CHECK_THROWS(tableOf<functionObjects::cellFreeLayer>("section slit; types (red);"));
    CHECK_THROWS(tableOf<functionObjects::clumpProfiles>("section slit; types (red);"));
    CHECK_THROWS(tableOf<functionObjects::haematocrit>("types (red);"));
}
