/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sceneScales.H"
#include "ignoreOverflow.H"
#include "clumpSuspension.H"
#include "IOdictionary.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- rho (nu/D)^2 times this is 64 Pa for red cells in plasma
const scalar viscousFactor = 2.5;

//- The axial stiffness of the bonds over their cross section times this is 60 Pa for the
//  fitted healthy red cell
const scalar bondFactor = 4;

//- Ratios of the densities of clumps and fluid beyond which one of them is in another
//  unit; a grain in air has 2000
const scalar leastDensityRatio = 0.01;
const scalar largestDensityRatio = 1e4;


//- constant/transportProperties
IOdictionary transportProperties(const fvMesh& mesh)
{
    const ignoreOverflow overflow;
    return IOdictionary
    (
        IOobject
        (
            "transportProperties", mesh.time().constant(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
}


//- Kinematic viscosity [m2/s], of a fluid that is not Newtonian that at rest; zero where
//  it is not known
scalar viscosity(const dictionary& transport)
{
    const dictionary& coeffs = transport.optionalSubDict
    (
        transport.getOrDefault<word>("transportModel", "Newtonian") + "Coeffs"
    );
    for (const char* key : {"nu", "nu0", "nuMax"})
    {
        for (const dictionary* dict : {&coeffs, &transport})
        {
            if (dict->found(key))
            {
                return dimensionedScalar(key, dimViscosity, *dict).value();
            }
        }
    }
    return 0;
}


//- Largest of the entries velocity [m/s] of clumps that are placed or injected
scalar givenSpeed(const dictionary& clumpProperties)
{
    scalar result = 0;
    const auto add = [&](const dictionary& dict)
    {
        if (dict.found("velocity"))
        {
            result = max(result, mag(dict.get<vector>("velocity")));
        }
    };
    const dictionary placement(clumpProperties.subOrEmptyDict("placement"));
    add(placement);
    if (placement.found("clumps"))
    {
        for (const dictionary& clump : getDictList(placement, "clumps"))
        {
            add(clump);
        }
    }
    const dictionary injections(clumpProperties.subOrEmptyDict("injection"));
    for (const entry& e : injections)
    {
        if (e.isDict())
        {
            add(e.dict());
        }
    }
    return result;
}


//- Warn where a mesh cell is too large for the spheres of a type
void warnOfCoarseMesh(const clumpSuspension& cloud, const fvMesh& mesh)
{
    const scalarField width(Foam::cbrt(mesh.V().field()));
    const scalar largest = gMax(width);
    const bool isHere = width.size() && max(width) == largest;
    const label owner = returnReduce
    (
        isHere ? Pstream::myProcNo() : labelMax, minOp<label>()
    );
    point place(Zero);
    if (owner == Pstream::myProcNo())
    {
        place = mesh.cellCentres()[findMax(width)];
    }
    reduce(place, sumOp<point>());
    for (const clumpType& type : cloud.types())
    {
        const scalar r = min(type.radii());
        if (!type.fixed() && type.ofSpheres() && r < 0.999*largest)
        {
            IOWarningInFunction(getDict(cloud.properties(), "types"))
                << "The mesh has less than two mesh cells across the smallest sphere of"
                << " type " << type.name() << ", of radius " << r << " m, in some"
                << " places: " << 2*r/largest << " at " << place << ". The run stops"
                << " where such a sphere gets there. Refine the mesh." << endl;
        }
    }
}


//- Fatal where a sphere or surface that moves is wider than the mesh, so that the lengths
//  must be in other units than metres
void refuseWide(const clumpSuspension& cloud, const fvMesh& mesh)
{
    const scalar diagonal = mesh.bounds().mag();
    for (const clumpType& type : cloud.types())
    {
        const scalar width = 2*(type.hasTriangles() ? type.reach() : max(type.radii()));
        if (!type.fixed() && width > diagonal)
        {
            OStringStream os;
            os.precision(3);
            os  << "Clump type " << type.name() << " is " << width/diagonal
                << " times wider than the mesh: "
                << (type.hasTriangles() ? "its surface" : "a sphere of it") << " is "
                << width << " m wide, and the diagonal of the mesh is " << diagonal
                << " m long. All units are SI: check the lengths of the entry 'shape' and"
                << " the scale of the mesh.";
            FatalIOErrorInFunction
            (
                getDict(getDict(cloud.properties(), "types"), type.name())
            )   << os.str().c_str() << exit(FatalIOError);
        }
    }
}


//- Warn of the density of a gas with the viscosity of a liquid
void warnOfDensity(const scalar rho, const scalar nu, const dictionary& properties)
{
    if (rho > 0.5 && rho < 2 && nu > 1e-7 && nu < 5e-6)
    {
        IOWarningInFunction(properties)
            << "The density of the fluid is " << rho << " kg/m3, that of a gas, with the"
            << " kinematic viscosity of a liquid, " << nu << " m2/s. Is it in g/cm3?"
            << " All units are SI." << endl;
    }
}

}


Foam::scalar Foam::contactStress
(
    const fvMesh& mesh,
    const dictionary& clumpProperties,
    const sceneEffects& effects,
    const vector& g,
    const PtrList<clumpType>& types,
    const PtrList<clumpBonds>& bonds,
    string& reason
)
{
    scalar density = 0;
    scalar width = GREAT;
    scalar elasticStress = 0;
    forAll(types, i)
    {
        density = max(density, types[i].mass()/types[i].volume());
        width = min(width, 2*types[i].reach());
        for (const clumpBonds::bond& b : bonds[i].bonds())
        {
            elasticStress = max
            (
                elasticStress,
                bondFactor*b.stiffness.normal*b.length
               /(constant::mathematical::pi*sqr(b.radius))
            );
        }
    }

    scalar stress = 0;
    const auto consider = [&](const scalar p, const char* name)
    {
        if (p > stress)
        {
            stress = p;
            reason = name;
        }
    };
    if (effects.active("fluid"))
    {
        const IOdictionary transport(transportProperties(mesh));
        const dictionary& densityDict =
            transport.found("rho") ? static_cast<const dictionary&>(transport) : clumpProperties;
        if (!densityDict.found("rho"))
        {
            // It is asked for below
            return 1;
        }
        const scalar rho = getPositive(densityDict, "rho", dimDensity);
        consider
        (
            viscousFactor*rho*sqr(viscosity(transport)/width), "that of a viscous flow"
        );
    }
    consider
    (
        density*(cmptMag(g) & mesh.bounds().span()),
        "the weight of a pile as high as the mesh"
    );
    consider(density*sqr(givenSpeed(clumpProperties)), "that of an impact");
    if (stress == 0)
    {
        consider(elasticStress, "four times the stiffness of the bonds");
    }
    if (stress == 0)
    {
        FatalIOErrorInFunction(clumpProperties)
            << "There is no contact model, and neither a viscosity, gravity, a velocity"
            << " of clumps nor bonds tell how stiff contacts should be. Give the stress"
            << " [Pa] under which spheres may overlap by 5 % of a radius," << nl
            << "    contactModel     { type hertz; allowedOverlap 0.05; stress ...;"
            << " restitution 0.5; }" << nl
            << "    wallContactModel { $contactModel; }" << exit(FatalIOError);
    }
    return stress;
}


void Foam::reportScales(const clumpSuspension& cloud)
{
    const fvMesh& mesh = cloud.mesh();
    scalar least = GREAT;
    scalar most = 0;
    Pair<scalar> densities(GREAT, 0);
    for (const clumpType& ct : cloud.types())
    {
        // The nodes of a surface have no size
        const scalar size = 2*(ct.ofSpheres() ? ct.reach() : max(mag(ct.centres())));
        least = min(least, size);
        most = max(most, size);
        const scalar density = ct.mass()/ct.volume();
        densities.first() = min(densities.first(), density);
        densities.second() = max(densities.second(), density);
    }
    const auto range = [](const scalar from, const scalar to)
    {
        // Four digits are enough for the log
        OStringStream os;
        os.precision(4);
        os << from;
        if (to > 1.0001*from)
        {
            os << " to " << to;
        }
        return os.str();
    };
    const scalarField& V = mesh.V();
    OStringStream os;
    os.precision(4);
    os  << "Lengths: mesh " << mesh.bounds().span() << " m, mesh cells "
        << range(Foam::cbrt(gMin(V)), Foam::cbrt(gMax(V))).c_str() << " m, clumps "
        << range(least, most).c_str() << " m";
    Info<< os.str().c_str() << endl;
    refuseWide(cloud, mesh);

    if (!cloud.hasFluid())
    {
        return;
    }
    const scalar rho = cloud.fluidDensity();
    warnOfDensity(rho, viscosity(transportProperties(mesh)), cloud.properties());
    if (!cloud.effects().active("refinement"))
    {
        warnOfCoarseMesh(cloud, mesh);
    }
    Info<< "Densities: clumps "
        << range(densities.first(), densities.second()).c_str() << " kg/m3, fluid "
        << rho << " kg/m3; viscosity of the fluid "
        << rho*viscosity(transportProperties(mesh)) << " Pa s" << endl;
    if
    (
        densities.first() < leastDensityRatio*rho
     || densities.second() > largestDensityRatio*rho
    )
    {
        IOWarningInFunction(getDict(cloud.properties(), "types"))
            << "The densities of clumps and fluid differ by a factor of "
            << max(densities.second()/rho, rho/densities.first())
            << ". Is one of them in another unit? All units are SI: kg/m3." << endl;
    }
}
