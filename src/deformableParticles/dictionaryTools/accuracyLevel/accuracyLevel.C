/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "accuracyLevel.H"
#include "messageStream.H"
#include "wordList.H"

void Foam::accuracyLevel::compare(const dictionary& file) const
{
    const word other(file.getOrDefault<word>("accuracyLevel", "none"));
    if (other != (chosen() ? name_ : word("none")))
    {
        IOWarningInFunction(file)
            << "The accuracy level of this file is " << other
            << ", that of constant/clumpProperties is "
            << (chosen() ? name_ : word("none"))
            << ". Include the same level in both files." << endl;
    }
}


Foam::accuracyLevel::accuracyLevel
(
    const dictionary& clumpProperties,
    const dictionary& fvSolution,
    const dictionary& controlDict
)
:
    dict_(clumpProperties.subOrEmptyDict("accuracyLevel"))
{
    if (!dict_.empty())
    {
        dict_.readEntry("name", name_);
        measured_ = dict_.subDict("measured").subDict(name_);
    }
    compare(fvSolution);
    compare(controlDict);
}


void Foam::accuracyLevel::refuseOldEntry(const dictionary& clumpProperties)
{
    if (!clumpProperties.found("accuracy"))
    {
        return;
    }
    const wordList levels({"draft", "standard", "fine"});
    const word old(clumpProperties.get<word>("accuracy"));
    const string path
    (
        "#include \"$WM_PROJECT_USER_DIR/etc/accuracy/"
      + (levels.found(old) ? old : word("standard"))
    );
    FatalIOErrorInFunction(clumpProperties)
        << "The entry 'accuracy' is no longer read. Write these lines before"
        << " the entries of the case instead:" << nl
        << "    constant/clumpProperties  " << path.c_str()
        << "/clumpProperties\"" << nl
        << "    system/fvSolution         " << path.c_str()
        << "/fvSolution\"" << nl
        << "    system/controlDict        " << path.c_str()
        << "/controlDict\"" << nl
        << "Valid levels: draft, standard, fine" << exit(FatalIOError);
}


void Foam::accuracyLevel::printMeasured(Ostream& os) const
{
    if (!chosen())
    {
        return;
    }
    const auto number = [&](const char* key)
    {
        return measured_.get<scalar>(key);
    };
    os  << nl << "Accuracy level " << name_
        << ", measured with the recommended mesh and clumps:" << nl
        << "    tethered red cell: error of the drag " << number("dragError")
        << " %, " << number("dragCost") << " s per simulated second" << nl
        << "    red cell in shear flow: error of the rotation "
        << number("rotationError") << " %, " << number("rotationCost")
        << " s per simulated second" << nl;
}


void Foam::accuracyLevel::print
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
    if (cellsPerDiameter >= GREAT)
    {
        return;     // there are no clumps yet
    }
    const label n = dict_.get<label>("spheresPerClump");
    const scalar cells = dict_.get<scalar>("cellsPerDiameter");

    // A single sphere is no coarse picture of something else
    const bool single = spheres == 1;

    printMeasured(os);
    os  << "    The case has ";
    if (!single)
    {
        os  << spheres << " spheres per clump (recommended: " << n << ") and ";
    }
    os  << cellsPerDiameter << " mesh cells per sphere diameter (recommended: "
        << cells << ')' << nl;

    if (!single && spheres < n)
    {
        WarningInFunction
            << "The clumps are coarser than accuracy level " << name_
            << " requires: " << spheres << " spheres per clump instead of "
            << n << endl;
    }
    if (cellsPerDiameter < 0.9*cells)
    {
        WarningInFunction
            << "The mesh is coarser than accuracy level " << name_
            << " requires: " << cellsPerDiameter
            << " mesh cells per sphere diameter instead of " << cells << endl;
    }
    os  << endl;
}
