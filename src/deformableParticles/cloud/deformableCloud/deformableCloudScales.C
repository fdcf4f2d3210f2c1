/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "anyNumber.H"
#include "IOdictionary.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- rho (nu/D)^2 times this is 64 Pa for red cells in plasma
const scalar ofViscosity = 2.5;

//- The axial stiffness of the bonds over their cross section times this is 60 Pa for the
//  fitted healthy red cell
const scalar ofBonds = 4;

//- Ratios of the densities of clumps and fluid beyond which one of them is in another
//  unit; a grain in air has 2000
const scalar leastDensityRatio = 0.01;
const scalar largestDensityRatio = 1e4;


//- constant/transportProperties
IOdictionary transportProperties(const fvMesh& mesh)
{
    const anyNumber overflow;
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


//- Second derivative of the energy of a membrane by the logarithmic strain of a pure shear
//  across x, y or z, their mean over its volume [Pa]
scalar stressOfShear(const membraneMechanics& membrane)
{
    const scalar stretch = 1.01;
    const auto energy = [&](const direction d, const scalar lambda)
    {
        pointField x(membrane.stressFree());
        for (point& p : x)
        {
            p[d] *= lambda;
            p[(d + 1) % 3] /= lambda;
        }
        vectorField gradient(x.size(), Zero);
        return membrane.add(x, gradient);
    };

    scalar sum = -6*energy(0, 1);
    for (direction d = 0; d < 3; ++d)
    {
        sum += energy(d, stretch) + energy(d, 1/stretch);
    }
    return
        sum
       /(
            3*sqr(Foam::log(stretch))
           *membrane.surface().volume(membrane.stressFree())
        );
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

}


const Foam::PtrList<Foam::clumpType>& Foam::deformableCloud::readModels()
{
    effects_.decide(dict_, mesh_);
    readTypes();
    for (const word family : {"contactModel", "wallContactModel"})
    {
        if (!dict_.found(family))
        {
            string reason;
            const scalar stress = contactStress(reason);
            dictionary law;
            law.set("type", "hertz");
            law.set("allowedOverlap", 0.05);
            law.set("stress", min(stress, largestEntry));
            law.set("restitution", 0.5);
            dict_.add(family, law);
            Info<< family << ": hertz, with an overlap of 5 % of a radius under "
                << stress << " Pa, " << reason.c_str() << endl;
        }
    }
    if
    (
        membraneContacts_.needsStress() && surfaceImmersion::wanted(types_)
     && effects_.active("fluid")
    )
    {
        string reason;
        scalar stress = contactStress(reason);
        scalar ofShear = 0;
        forAll(types_, i)
        {
            if (types_[i].hasSurface())
            {
                ofShear = max(ofShear, stressOfShear(membranes_[i].mechanics()));
            }
        }

        // Stiffer contacts would be of no use: the membranes deform instead
        if (ofShear > 0 && ofShear < stress)
        {
            stress = ofShear;
            reason = "that of the stiffest membrane in shear";
        }
        membraneContacts_.setStress(min(stress, largestEntry));
        Info<< "membraneContact: " << stress << " Pa where surfaces touch, "
            << reason.c_str() << endl;
    }
    return types_;
}


Foam::scalar Foam::deformableCloud::contactStress(string& reason) const
{
    scalar density = 0;
    scalar width = GREAT;
    scalar ofElasticity = 0;
    forAll(types_, i)
    {
        density = max(density, types_[i].mass()/types_[i].volume());
        width = min(width, 2*types_[i].reach());
        for (const clumpBonds::bond& b : bonds_[i].bonds())
        {
            ofElasticity = max
            (
                ofElasticity,
                ofBonds*b.stiffness.normal*b.length
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
    if (effects_.active("fluid"))
    {
        const IOdictionary transport(transportProperties(mesh_));
        const dictionary& ofDensity =
            transport.found("rho") ? static_cast<const dictionary&>(transport) : dict_;
        if (!ofDensity.found("rho"))
        {
            // It is asked for below
            return 1;
        }
        const scalar rho = getPositive(ofDensity, "rho", dimDensity);
        consider
        (
            ofViscosity*rho*sqr(viscosity(transport)/width), "that of a viscous flow"
        );
    }
    consider
    (
        density*(cmptMag(g_) & mesh_.bounds().span()),
        "the weight of a pile as high as the mesh"
    );
    consider(density*sqr(givenSpeed(dict_)), "that of an impact");
    if (stress == 0)
    {
        consider(ofElasticity, "four times the stiffness of the bonds");
    }
    if (stress == 0)
    {
        FatalIOErrorInFunction(dict_)
            << "There is no contact model, and neither a viscosity, gravity, a velocity"
            << " of clumps nor bonds tell how stiff contacts should be. Give the stress"
            << " [Pa] under which spheres may overlap by 5 % of a radius," << nl
            << "    contactModel     { type hertz; allowedOverlap 0.05; stress ...;"
            << " restitution 0.5; }" << nl
            << "    wallContactModel { $contactModel; }" << exit(FatalIOError);
    }
    return stress;
}


void Foam::deformableCloud::reportScales() const
{
    scalar least = GREAT;
    scalar most = 0;
    Pair<scalar> densities(GREAT, 0);
    for (const clumpType& ct : types_)
    {
        least = min(least, 2*ct.reach());
        most = max(most, 2*ct.reach());
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
    const scalarField& V = mesh_.V();
    OStringStream os;
    os.precision(4);
    os  << "Lengths: mesh " << mesh_.bounds().span() << " m, mesh cells "
        << range(Foam::cbrt(gMin(V)), Foam::cbrt(gMax(V))).c_str() << " m, clumps "
        << range(least, most).c_str() << " m";
    Info<< os.str().c_str() << endl;

    if (!hasFluid())
    {
        return;
    }
    const scalar rho = fluidDensity();
    Info<< "Densities: clumps "
        << range(densities.first(), densities.second()).c_str() << " kg/m3, fluid "
        << rho << " kg/m3; viscosity of the fluid "
        << rho*viscosity(transportProperties(mesh_)) << " Pa s" << endl;
    if
    (
        densities.first() < leastDensityRatio*rho
     || densities.second() > largestDensityRatio*rho
    )
    {
        IOWarningInFunction(getDict(dict_, "types"))
            << "The densities of clumps and fluid differ by a factor of "
            << max(densities.second()/rho, rho/densities.first())
            << ". Is one of them in another unit? All units are SI: kg/m3." << endl;
    }
}
