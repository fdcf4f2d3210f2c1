/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "crossSection.H"
#include "checkedEntries.H"
#include "mathematicalConstants.H"
#include "symmetryPlanes.H"

using Foam::constant::mathematical::pi;

Foam::functionObjects::crossSection::crossSection
(
    const dictionary& dict,
    const flowAxes& axes,
    const polyMesh& mesh
)
:
    tube_(false),
    axes_(axes)
{
    const word section(getEntry<word>(dict, "section"));
    tube_ = section == "tube";
    if (!tube_ && section != "slit")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'section' is " << section << ". Valid: slit, tube"
            << exit(FatalIOError);
    }

    const symmetryPlanes symmetric(mesh.boundaryMesh());
    for (const symmetryPlanes::plane& plane : symmetric.planes())
    {
        // Of a slit it may end the width along the vorticity
        const vector n(axes_.local(plane.n));
        if (mag(n.x()) > 1e-3 || (tube_ && mag(n.y()) > 1e-3))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'section' is " << section << ", but patch "
                << mesh.boundaryMesh()[plane.patch].name() << " is a plane of symmetry"
                << " and no wall. Mesh both sides of it for this table."
                << exit(FatalIOError);
        }
    }

    vector low(vector::uniform(GREAT)), high(vector::uniform(-GREAT));
    for (const point& p : mesh.points())
    {
        low = min(low, axes_.local(p));
        high = max(high, axes_.local(p));
    }
    reduce(low, minOp<vector>());
    reduce(high, maxOp<vector>());
    middle_ = 0.5*(low + high);
    half_ = 0.5*(high - low);

    if (tube_)
    {
        // The corners of the faces lie on the wall, not always where it is highest
        scalar radius = 0;
        for (const point& p : mesh.points())
        {
            const vector x(local(p));
            radius = max(radius, Foam::sqrt(sqr(x.x()) + sqr(x.y())));
        }
        half_.x() = half_.y() = returnReduce(radius, maxOp<scalar>());
    }

    checkVolume(mesh, dict);
}


void Foam::functionObjects::crossSection::checkVolume
(
    const polyMesh& mesh,
    const dictionary& dict
) const
{
    // A round tube of 24 plane faces around lacks 1.1 % of its volume
    const scalar tolerance = tube_ ? 0.03 : 0.001;
    const scalar expected = volumeTo(width());
    const scalar ratio = gSum(mesh.cellVolumes())/expected;
    if (mag(ratio - 1) > tolerance)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'section' is " << (tube_ ? "tube" : "slit")
            << ", but the mesh has " << ratio << " times the volume of "
            << (tube_ ? "a round tube with this radius" : "a box with these sides")
            << " and length. Set section (slit, tube), flow and gradient to those"
            << " of a straight channel that the mesh fills." << exit(FatalIOError);
    }
}


Foam::scalar Foam::functionObjects::crossSection::volumeTo
(
    const scalar position
) const
{
    return
        length()*(tube_ ? pi*sqr(position) : 2*half_.y()*position);
}


Foam::List<Foam::vector>
Foam::functionObjects::crossSection::towardsWalls() const
{
    List<vector> result(tube_ ? 16 : 2);
    forAll(result, k)
    {
        const scalar angle = 2*pi*k/result.size();
        result[k] = vector(Foam::cos(angle), Foam::sin(angle), 0);
    }
    return result;
}
