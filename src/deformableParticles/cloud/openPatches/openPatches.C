/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "openPatches.H"
#include "checkedEntries.H"
#include "foamCompat.H"
#include "volFields.H"
#include "wallPolyPatch.H"

namespace
{

using namespace Foam;

scalar readFadeLength(const dictionary& clumpProperties)
{
    if (!clumpProperties.found("openPatches"))
    {
        return 0;
    }
    const dictionary& dict = getDict(clumpProperties, "openPatches");
    checkEntries(dict, {"fadeLength"});
    return getPositiveOrDefault(dict, "fadeLength", 0);
}

}

Foam::openPatches::openPatches
(
    const polyMesh& mesh,
    const dictionary& clumpProperties
)
:
    mesh_(mesh),
    fadeLength_(readFadeLength(clumpProperties)),
    neighbourhood_(-1)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    labelList faces(patches.nNonProcessor(), Zero);
    forAll(faces, patchi)
    {
        faces[patchi] = patches[patchi].size();
    }
    reduceList(faces, plusEqOp<label>());

    forAll(faces, patchi)
    {
        if (faces[patchi] && isOpen(patches[patchi]))
        {
            patches_.append(patchi);
        }
    }
}


bool Foam::openPatches::isOpen(const polyPatch& patch)
{
    return
        !patch.coupled() && !isA<wallPolyPatch>(patch)
     && !polyPatch::constraintType(patch.type());
}


void Foam::openPatches::report() const
{
    if (!empty())
    {
        Info<< "Clumps may leave through:";
        for (const label patchi : patches_)
        {
            Info<< ' ' << mesh_.boundaryMesh()[patchi].name();
        }
        Info<< endl;
    }
}


void Foam::openPatches::warnOfClosed(const volVectorField& U) const
{
    for (const label patchi : patches_)
    {
        const fvPatchVectorField& u = U.boundaryField()[patchi];
        bool closed = u.type() == "noSlip" || u.type() == "slip";
        if (u.type() == "fixedValue")
        {
            const vectorField n(u.patch().nf());
            const scalar across = gSum(mag(u & n));
            closed = across <= 1e-9*gSum(mag(u));
        }
        if (closed)
        {
            WarningInFunction
                << "Patch " << u.patch().name() << " is of the type "
                << u.patch().patch().type() << ", but its velocity, " << u.type()
                << ", does not cross it. Clumps near it lose their action on the"
                << " fluid, as before an outlet. If it is a wall, give it the type"
                << " wall in constant/polyMesh/boundary." << endl;
        }
    }
}


Foam::scalar Foam::openPatches::gap
(
    const scalar d,
    const scalar cosTheta,
    const scalar r
)
{
    return d/max(sqr(cosTheta), SMALL) - r;
}


Foam::scalar Foam::openPatches::fadeFactor
(
    const scalar gap,
    const scalar fadeLength
)
{
    // A clump that acts on nothing would have no force to be divided
    const scalar least = 1e-3;
    const scalar s = min(max(gap/fadeLength, scalar(0)), scalar(1));
    return max(least, sqr(s)*(3 - 2*s));
}


void Foam::openPatches::update(const ghostExchange& ghosts)
{
    // Patches of the neighbouring processors belong to it
    if (neighbourhood_ != ghosts.neighbourhood())
    {
        neighbourhood_ = ghosts.neighbourhood();
        surfaces_.clear();
    }
    if (surfaces_.size() == patches_.size())
    {
        return;
    }
    surfaces_.setSize(patches_.size());
    forAll(patches_, k)
    {
        surfaces_.set
        (
            k,
            new wallSurface
            (
                mesh_.boundaryMesh()[patches_[k]], mesh_.points(), ghosts
            )
        );
    }
}


Foam::openPatches::place Foam::openPatches::nearest
(
    const clumpType& type,
    const pointField& x,
    const scalar limit
) const
{
    place result;
    forAll(surfaces_, k)
    {
        forAll(x, i)
        {
            const scalar r = type.radii()[i];
            wallSurface::nearPlace nearby;
            if (!surfaces_[k].nearest(x[i], limit + r, nearby))
            {
                continue;
            }

            // Behind the patch only where it is opposite
            const scalar cosTheta = nearby.away & nearby.inwards;
            const scalar gapHere = gap(nearby.height, cosTheta, r);
            if (gapHere < result.gap && (nearby.height >= 0 || cosTheta > 0.999))
            {
                result.gap = gapHere;
                result.patchi = patches_[k];
                result.inwards = nearby.inwards;
            }
        }
    }
    return result;
}


Foam::scalar Foam::openPatches::fadeFactor
(
    const clumpType& type,
    const pointField& x
) const
{
    if (empty() || type.fixed())
    {
        return 1;
    }
    const scalar length = fadeLength(type);
    return fadeFactor(nearest(type, x, length).gap, length);
}
