/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "caseTemplate.H"
#include "FlatOutput.H"
#include "ghostExchange.H"
#include "IFstream.H"
#include "IOdictionary.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "patchWave.H"
#include "StringStream.H"

namespace
{

using namespace Foam;

//- Four digits, as numbers are given by hand
template<class Type>
std::string rounded(const Type& value)
{
    OStringStream os;
    os.precision(4);
    os << value;
    return os.str();
}

//- What the mesh has to resolve, with the mesh cells per diameter that the solver needs,
//  and those that are recommended
struct resolution
{
    const char* of;
    const char* good;
    scalar diameter;
    scalar least;
    scalar wanted;
};

resolution needed(const clumpType& type)
{
    return
        type.hasTriangles()
      ? resolution
        {
            "Its membrane", "give the deformation of a capsule", 2*type.reach(), 6, 10
        }
      : resolution{"Its smallest sphere", "give the drag", 2*min(type.radii()), 2, 4};
}


//- Part of its width that a mesh cell keeps where dynamicMeshDict refines around clumps
scalar refinedPart(const fvMesh& mesh)
{
    const IOdictionary dict
    (
        IOobject
        (
            "dynamicMeshDict", mesh.time().constant(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    const bool refines =
        dict.getOrDefault<word>("field", word::null) == "clumpCloseness";
    return
        refines ? Foam::pow(0.5, dict.getOrDefault<label>("maxRefinement", 0)) : 1;
}

}


void Foam::caseTemplate::readType(const scalar diameter)
{
    if (name_ == "bead")
    {
        const scalarField distance(surfaceDistance());
        const label widest = findMax(distance);
        const scalar d =
            diameter > 0 ? diameter
          : min(6*width(widest), distance[widest]);

        dictionary shape;
        shape.set("type", "chain");
        shape.set("nSpheres", 1);
        shape.set("sphereRadius", 0.5*d);
        type_.set("shape", shape);
        type_.set("density", 1050);
        return;
    }
    if (diameter > 0)
    {
        FatalErrorInFunction
            << "The option -diameter is for the template bead; the size of "
            << name_ << " belongs to its mechanics." << exit(FatalError);
    }
    const fileName folder(getEnv("WM_PROJECT_USER_DIR")/"etc"/"cells");
    source_ = folder/name_;
    if (!isFile(source_))
    {
        wordList names({"bead"});
        for (const fileName& file : readDir(folder))
        {
            names.append(word(file, false));
        }
        sort(names);
        FatalErrorInFunction
            << "There is no template " << name_ << " in " << folder << nl
            << "    Valid templates: " << flatOutput(names) << exit(FatalError);
    }
    IFstream is(source_);
    type_ = dictionary(is);
}


Foam::scalarField Foam::caseTemplate::surfaceDistance() const
{
    labelHashSet surfaces;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!pp.coupled() && pp.size())
        {
            surfaces.insert(pp.index());
        }
    }
    if (surfaces.empty())
    {
        // Periodic in all directions
        return scalarField(mesh_.nCells(), 0.5*cmptMin(mesh_.bounds().span()));
    }
    return patchWave(mesh_, surfaces, true).distance();
}


Foam::string Foam::caseTemplate::unitHint(const scalar diameter) const
{
    const vector span(mesh_.bounds().span());
    OStringStream os;
    os.precision(3);
    os  << name_ << " is " << diameter << " m wide, the mesh spans " << span
        << " m, and its mesh cells are " << width(findMin(mesh_.V())) << " to "
        << width(findMax(mesh_.V())) << " m wide"
        << (refined_ < 1 ? " where it is refined." : ".");
    if (diameter > cmptMax(span) || diameter < 0.1*width(findMin(mesh_.V())))
    {
        os  << nl << "    Is one of them in another unit? All lengths are in m: scale"
            << " 1e-6; in blockMeshDict, or transformPoints -scale, for a mesh in um.";
    }
    return os.str();
}


Foam::scalar Foam::caseTemplate::bestResolution
(
    const clumpType& type,
    const scalarField& distance
) const
{
    const resolution need(needed(type));
    const scalar room = 1.02*type.reach();
    scalar best = 0;
    forAll(distance, celli)
    {
        if (distance[celli] > room)
        {
            best = max(best, need.diameter/width(celli));
        }
    }
    if (max(distance) <= room)
    {
        FatalErrorInFunction
            << unitHint(2*type.reach()).c_str() << nl
            << "    No place is farther than " << rounded(max(distance)).c_str()
            << " m from walls and open patches: the clump does not fit."
            << exit(FatalError);
    }
    if (best < need.least)
    {
        FatalErrorInFunction
            << unitHint(2*type.reach()).c_str() << nl << "    " << need.of << " of "
            << rounded(need.diameter).c_str() << " m has at most "
            << rounded(best).c_str() << " mesh cells per diameter; at least "
            << need.least << " are needed, " << need.wanted << ' ' << need.good
            << " within a few per cent: make the mesh cells "
            << rounded(need.wanted/best).c_str() << " times smaller."
            << exit(FatalError);
    }
    return best;
}


void Foam::caseTemplate::choosePosition(const clumpType& type)
{
    const scalarField distance(surfaceDistance());
    const resolution need(needed(type));
    const point middle(mesh_.bounds().midpoint());

    // Resolved nearly as well as possible, far from the surfaces, in the middle
    const scalar wanted = max
    (
        need.least, min(0.75*bestResolution(type, distance), need.wanted)
    );
    scalar farthest = 0;
    scalar nearest = GREAT;
    label best = -1;
    forAll(distance, celli)
    {
        const scalar off = mag(mesh_.C()[celli] - middle);
        if
        (
            need.diameter/width(celli) >= wanted
         && (
                distance[celli] > 1.001*farthest
             || (distance[celli] > 0.999*farthest && off < nearest)
            )
        )
        {
            best = celli;
            farthest = max(farthest, distance[celli]);
            nearest = off;
        }
    }
    position_ = mesh_.C()[best];
    resolution_ = need.diameter/width(best);
}


bool Foam::caseTemplate::checkFluid() const
{
    const IOdictionary transport
    (
        IOobject
        (
            "transportProperties", mesh_.time().constant(), mesh_,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    if (transport.empty())
    {
        Info<< "Without constant/transportProperties there is no fluid, and the clump"
            << " moves under loads and gravity alone" << nl;
        return true;
    }
    if (transport.found("nu"))
    {
        const scalar nu = dimensionedScalar("nu", transport).value();
        if (nu > 1e-2 || nu < 1e-8)
        {
            IOWarningInFunction(transport)
                << "The kinematic viscosity nu is " << rounded(nu).c_str()
                << " m2/s, which no liquid has (water: 1e-6, blood plasma: 1.2e-6,"
                << " glycerine: 1e-3). Is it in another unit?" << endl;
        }
    }
    if (!transport.found("transportModel"))
    {
        IOWarningInFunction(transport)
            << "There is no transportModel; rbcIbFoam needs the line" << nl
            << "    transportModel Newtonian;" << endl;
    }
    return transport.found("rho");
}


void Foam::caseTemplate::writeHeader(Ostream& os, const word& object)
{
    os  << "FoamFile" << nl << '{' << nl
        << "    version     2.0;" << nl << "    format      ascii;" << nl
        << "    class       dictionary;" << nl << "    object      " << object << ';'
        << nl << '}' << nl << nl;
}


void Foam::caseTemplate::writeTurbulence() const
{
    const fileName folder(mesh_.time().constantPath());
    const fileName file(folder/"turbulenceProperties");
    if (isFile(folder/"transportProperties") && !isFile(file))
    {
        OFstream os(file);
        writeHeader(os, "turbulenceProperties");
        os << "simulationType laminar;" << nl;
        Info<< "Wrote " << file.c_str() << ", which was missing: laminar" << nl;
    }
}


void Foam::caseTemplate::adviseTimeStep(const clumpType& type) const
{
    const IOobject file
    (
        "U", mesh_.time().timeName(), mesh_, IOobject::MUST_READ, IOobject::NO_WRITE
    );
    if (!IOobject(file).typeHeaderOk<volVectorField>(true))
    {
        return;
    }
    const volVectorField U(file, mesh_);
    const scalar fastest = max(mag(U)).value();
    if (fastest < VSMALL)
    {
        return;
    }
    const resolution need(needed(type));
    const scalar limit = 0.125*need.diameter/fastest;
    Info<< "At the largest velocity of time " << mesh_.time().timeName() << ", "
        << rounded(fastest).c_str() << " m/s, an eighth of the diameter "
        << rounded(need.diameter).c_str() << " m takes "
        << rounded(limit).c_str() << " s; deltaT is "
        << rounded(mesh_.time().deltaTValue()).c_str() << " s";
    if (mesh_.time().deltaTValue() > limit)
    {
        Info<< ". Reduce it, or set adjustTimeStep yes";
    }
    Info<< nl;
}


Foam::caseTemplate::caseTemplate
(
    const fvMesh& mesh,
    const word& name,
    const scalar diameter
)
:
    mesh_(mesh),
    name_(name),
    position_(Zero),
    resolution_(0),
    refined_(refinedPart(mesh))
{
    ghostExchange::checkPatches(mesh.boundaryMesh());
    readType(diameter);
    choosePosition(clumpType(name_, type_));
}


void Foam::caseTemplate::write(const bool overwrite) const
{
    const fileName folder(mesh_.time().constantPath());
    const fileName file(folder/"clumpProperties");
    const clumpType type(name_, type_);
    if (isFile(file) && !overwrite)
    {
        FatalErrorInFunction
            << file << " exists already. Give the option -overwrite to replace it."
            << exit(FatalError);
    }
    const bool hasDensity = checkFluid();
    adviseTimeStep(type);

    writeTurbulence();

    OFstream os(file);
    writeHeader(os, "clumpProperties");
    os  << "// Entries that are absent are the accurate choices:" << nl
        << "// doc/models/clumpProperties.md lists all" << nl << nl
        << "types" << nl << '{' << nl << "    " << name_ << nl << "    {" << nl;
    if (source_.empty())
    {
        const dictionary& shape = type_.subDict("shape");
        os  << "        shape   { type chain; nSpheres 1; sphereRadius "
            << rounded(shape.get<scalar>("sphereRadius")).c_str() << "; }   // [m]" << nl
            << "        density " << type_.get<scalar>("density") << ";   // [kg/m3]"
            << nl;
    }
    else
    {
        os  << "        #include \"" << name_ << '"' << nl;
        cp(source_, folder/name_);
    }
    os  << "    }" << nl << '}' << nl << nl << "placement" << nl << '{' << nl
        << "    type    list;" << nl << "    clumps  ( { type " << name_
        << "; position " << rounded(position_).c_str() << "; } );    // [m]" << nl
        << '}' << nl;
    if (!source_.empty())
    {
        // With these, blood of rings and of cells is alike, see doc/models/gapModels.md
        os  << nl << "// Attraction of red cells in plasma" << nl
            << "// surfaceForces { plasma { type depletion; energy "
            << (type_.found("membrane") ? "2.67e-6" : "0.28e-6")
            << "; } }     // [J/m2]" << nl;
    }
    if (!hasDensity)
    {
        const scalar rho = source_.empty() ? 1000 : 1025;
        os  << nl << "rho " << rho << ";    // [kg/m3] of the fluid" << nl;
        Info<< "constant/transportProperties has no rho: clumpProperties has "
            << rho << " kg/m3" << nl;
    }
    const resolution need(needed(type));
    Info<< unitHint(2*type.reach()).c_str() << nl << need.of << " has "
        << rounded(resolution_).c_str() << " mesh cells per diameter";
    if (resolution_ < need.wanted)
    {
        Info<< "; " << need.wanted << ' ' << need.good << " within a few per cent";
    }
    Info<< nl << "Wrote " << file.c_str() << ": " << name_ << " at "
        << rounded(position_).c_str() << nl << "End" << nl << endl;
}
