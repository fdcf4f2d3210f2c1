/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "accuracyPreset.H"
#include "StringStream.H"
#include "HashTable.H"
#include "messageStream.H"

Foam::accuracyPreset::accuracyPreset(const dictionary& clumpProperties)
{
    if (!clumpProperties.found("accuracy"))
    {
        return;
    }

    clumpProperties.readEntry("accuracy", name_);
    dictionary all{IStringStream(text)()};
    all.remove("common");
    if (!all.found(name_))
    {
        HashTable<label> valid;
        for (const word& known : all.toc())
        {
            valid.insert(known, 0);
        }
        FatalIOErrorInLookup(clumpProperties, "accuracy", name_, valid)
            << exit(FatalIOError);
    }
    preset_ = all.subDict(name_);
}


void Foam::accuracyPreset::fill(dictionary& dict, const dictionary& missing)
{
    for (const entry& e : missing)
    {
        if (!dict.found(e.keyword()))
        {
            dict.add(e);
        }
        else if
        (
            // A model of the user's own has entries of its own
            e.isDict() && dict.isDict(e.keyword()) && !e.dict().found("type")
        )
        {
            fill(dict.subDict(e.keyword()), e.dict());
        }
    }
}


Foam::dictionary Foam::accuracyPreset::completed
(
    const dictionary& clumpProperties
) const
{
    dictionary result(clumpProperties);
    if (chosen())
    {
        fill(result, preset_.subDict("clumpProperties"));
    }
    return result;
}


Foam::scalar Foam::accuracyPreset::limit
(
    const word& key,
    const scalar otherwise
) const
{
    return
        chosen()
      ? preset_.subDict("controlDict").get<scalar>(key)
      : otherwise;
}


void Foam::accuracyPreset::complete(const fvMesh& mesh) const
{
    if (chosen())
    {
        auto& solution = const_cast<dictionary&>(mesh.solutionDict());
        fill
        (
            solution.subDictOrAdd("PISO"),
            preset_.subDict("fvSolution").subDict("PISO")
        );
    }
}


const Foam::dictionary& Foam::accuracyPreset::solver
(
    const fvMesh& mesh,
    const word& field
) const
{
    if (!chosen())
    {
        return mesh.solverDict(field);
    }

    const dictionary* solvers = mesh.solutionDict().findDict("solvers");
    const dictionary* own = solvers ? solvers->findDict(field) : nullptr;
    if (own && !own->empty())
    {
        return mesh.solverDict(field);
    }
    return preset_.subDict("fvSolution").subDict("solvers").subDict(field);
}


void Foam::accuracyPreset::print
(
    Ostream& os,
    const label spheres,
    const scalar cellsPerDiameter
) const
{
    if (!chosen())
    {
        return;
    }

    const dictionary& scene = preset_.subDict("scene");
    const label n = scene.get<label>("spheres");
    const scalar cells = scene.get<scalar>("cellsPerDiameter");

    os  << nl << "Accuracy " << name_
        << ", where the case does not say otherwise:" << nl;
    preset_.writeEntries(os);
    os  << nl << "    The case has " << spheres << " spheres per clump (meant for "
        << n << ") and " << cellsPerDiameter
        << " cells per sphere diameter (meant for " << cells << ')' << nl;

    if (cellsPerDiameter < 0.9*cells)
    {
        WarningInFunction
            << "The mesh is coarser than accuracy " << name_ << " is meant for: "
            << cellsPerDiameter << " cells per sphere diameter instead of "
            << cells << endl;
    }
    os  << endl;
}
