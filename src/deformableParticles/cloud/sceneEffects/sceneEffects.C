/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sceneEffects.H"
#include "checkedEntries.H"
#include "fvMesh.H"
#include "HashTable.H"
#include "IOdictionary.H"
#include "volFields.H"
#include <cstring>

namespace
{

using namespace Foam;

//- Fatal where the start time has a flow, but the file of the fluid is missing
void refuseForgotten(const fvMesh& mesh)
{
    const word start(mesh.time().timeName());
    const bool hasFlow =
        IOobject("U", start, mesh).typeHeaderOk<volVectorField>(false)
     && IOobject("p", start, mesh).typeHeaderOk<volScalarField>(false);
    if (returnReduce(hasFlow, orOp<bool>()))
    {
        FatalErrorInFunction
            << "There is no constant/transportProperties, but the start time " << start
            << " has the fields U and p. With a fluid, write its viscosity into that"
            << " file: transportModel Newtonian; nu <m2/s>;" << nl
            << "    For clumps without a fluid, write 'effects { fluid off; }' or remove"
            << " U and p." << exit(FatalError);
    }
}

}


Foam::sceneEffects::sceneEffects(const dictionary& clumpProperties)
:
    announce_(false),
    frozen_(false)
{
    const char* const names[] =
    {
        "fluid", "feedback", "convection", "sliding", "refinement", "gravity",
        "rotation", "loads", "damping", "conservation", "contact", "walls",
        "lubrication"
    };
    for (const char* name : names)
    {
        effects_.append({name, choice::automatic, true, ""});
    }
    if (clumpProperties.found("effects"))
    {
        readChoices(getDict(clumpProperties, "effects"));
    }
}


void Foam::sceneEffects::readChoices(const dictionary& chosen)
{
    HashTable<label> valid;
    for (const effect& e : effects_)
    {
        valid.insert(e.name, 0);
    }

    for (const word& name : chosen.toc())
    {
        if (!valid.found(name))
        {
            FatalIOErrorInLookup(chosen, "effect", name, valid)
                << exit(FatalIOError);
        }

        const word value(chosen.get<word>(name));
        HashTable<label> choices({{"off", 0}, {"on", 1}, {"auto", 2}});
        if (name == "fluid")
        {
            choices.insert("frozen", 1);
            frozen_ = value == "frozen";
        }
        if (!choices.found(value))
        {
            FatalIOErrorInLookup(chosen, name, value, choices)
                << exit(FatalIOError);
        }

        given_ = chosen;
        effect& e = const_cast<effect&>(find(name.c_str()));
        e.chosen = choice(choices[value]);
        if (e.chosen != choice::automatic)
        {
            e.active = e.chosen == choice::on;
            e.reason = "set by the user";
        }
    }
}


void Foam::sceneEffects::decide
(
    const dictionary& clumpProperties,
    const fvMesh& mesh
)
{
    decideFluid(clumpProperties, mesh);

    const bool loads = clumpProperties.found("loads");
    decide
    (
        "loads",
        loads && getDict(clumpProperties, "loads").size(),
        loads ? "clumpProperties has loads" : "there are no loads"
    );
    require
    (
        "loads",
        loads && getDict(clumpProperties, "loads").size(),
        "clumpProperties has no loads"
    );

    const dictionary& types = getDict(clumpProperties, "types");
    decideForModel("damping", types, "dampingModel");
    decideForModel("conservation", types, "conservationModel");
}


void Foam::sceneEffects::decideFluid
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    if (automatic("fluid"))
    {
        const bool found = IOobject
        (
            "transportProperties", mesh.time().constant(), mesh
        ).typeHeaderOk<IOdictionary>(false);

        if (!found)
        {
            refuseForgotten(mesh);
        }
        decide
        (
            "fluid",
            found,
            found
          ? "constant/transportProperties exists"
          : "constant/transportProperties does not exist"
        );
    }

    const bool flows = active("fluid") && !frozen_;
    const string still(active("fluid") ? "the flow is frozen" : "there is no fluid");
    decide
    (
        "feedback", flows, flows ? "the flow is solved" : still
    );
    if (!flows && active("feedback"))
    {
        FatalIOErrorInFunction(getDict(dict, "effects"))
            << "Entry 'effects': feedback is on, but " << still.c_str()
            << '.' << exit(FatalIOError);
    }
    require("convection", flows, still);
    require("refinement", flows && mesh.dynamic(), "the mesh is static");
    require("rotation", active("feedback"), "the flow does not feel the clumps");
    if (!flows)
    {
        decide("convection", false, still);
    }
    decide
    (
        "refinement",
        flows && mesh.dynamic(),
        mesh.dynamic() ? "the mesh is dynamic" : "the mesh is static"
    );

    if (!active("feedback"))
    {
        decide("rotation", false, "the flow does not feel the clumps");
    }
    else if (!switchedOff("rotation"))
    {
        decide("rotation", true, getDict(dict, "rotation").get<word>("type"));
    }
}


void Foam::sceneEffects::decideForModel
(
    const char* name,
    const dictionary& types,
    const word& family
)
{
    for (const word& typeName : types.toc())
    {
        const dictionary& type = getDict(types, typeName);
        const dictionary list(type.subOrEmptyDict(family + 's'));
        word models
        (
            type.subOrEmptyDict(family).getOrDefault<word>("type", "none")
        );
        for (const word& entry : list.toc())
        {
            const word model
            (
                list.subOrEmptyDict(entry).getOrDefault<word>("type", "none")
            );
            models =
                models == "none" ? model : word(models + ", " + model, false);
        }
        if (models != "none")
        {
            decide(name, true, typeName + " has " + models);
            return;
        }
    }
    decide(name, false, "no " + family);
    require(name, false, "no clump type has a " + family);
}


void Foam::sceneEffects::require
(
    const char* name,
    const bool acts,
    const string& reason
) const
{
    const effect& e = find(name);
    if (e.chosen == choice::on && !acts)
    {
        FatalIOErrorInFunction(given_)
            << "Entry 'effects': " << name << " is on, but " << reason.c_str()
            << ". Valid here: off, auto" << exit(FatalIOError);
    }
}


const Foam::sceneEffects::effect* Foam::sceneEffects::lookup
(
    const char* name
) const
{
    for (const effect& e : effects_)
    {
        if (!std::strcmp(e.name, name))
        {
            return &e;
        }
    }
    return nullptr;
}


const Foam::sceneEffects::effect& Foam::sceneEffects::find
(
    const char* name
) const
{
    const effect* e = lookup(name);
    if (!e)
    {
        FatalErrorInFunction << "No effect " << name << exit(FatalError);
    }
    return *e;
}


void Foam::sceneEffects::decide
(
    const char* name,
    const bool on,
    const string& reason
)
{
    effect& e = const_cast<effect&>(find(name));

    if (e.chosen != choice::automatic)
    {
        return;
    }
    if (announce_ && e.active != on)
    {
        Info<< "Effect " << name << ": now " << (on ? "on" : "off") << ", "
            << reason.c_str() << endl;
    }
    e.active = on;
    e.reason = reason;
}


void Foam::sceneEffects::print(Ostream& os)
{
    os  << nl << "Effects" << nl;
    for (const effect& e : effects_)
    {
        const bool isFrozen = frozen_ && &e == lookup("fluid");
        os  << "    " << e.name << ": "
            << (isFrozen ? "frozen" : e.active ? "on" : "off")
            << ", " << e.reason.c_str() << nl;
    }
    os  << endl;
    announce_ = true;
}
