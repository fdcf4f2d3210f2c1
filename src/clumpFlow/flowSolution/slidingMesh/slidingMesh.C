/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "slidingMesh.H"
#include "clumpMotion.H"
#include "clumpTotals.H"
#include "meshMotion.H"
#include "placedConditions.H"
#include <Eigen/Eigenvalues>

namespace
{

using namespace Foam;

//- Projects onto the directions at right angles to all faces that are not coupled, and
//  along which no clump is held
tensor alongBoundary(const fvMesh& mesh, const symmTensor& held)
{
    symmTensor normals(Zero);
    scalar area = 0;
    for (const fvPatch& patch : mesh.boundary())
    {
        if (!patch.coupled())
        {
            normals += sum(sqr(patch.Sf())/patch.magSf());
            area += sum(patch.magSf());
        }
    }
    reduce(normals, sumOp<symmTensor>());
    reduce(area, sumOp<scalar>());
    normals = normals/max(area, VSMALL) + held;

    Eigen::Matrix3d moments;
    moments <<
        normals.xx(), normals.xy(), normals.xz(),
        normals.xy(), normals.yy(), normals.yz(),
        normals.xz(), normals.yz(), normals.zz();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);

    // Points of a mesh are written with six digits
    tensor result(Zero);
    for (label i = 0; i < 3; ++i)
    {
        if (solver.eigenvalues()[i] < 1e-9)
        {
            const Eigen::Vector3d e(solver.eigenvectors().col(i));
            const vector direction(e[0], e[1], e[2]);
            result += direction*direction;
        }
    }
    return result;
}


//- The first function object that needs a mesh at rest in the laboratory, and why
string functionAtRest(const dictionary& controlDict)
{
    const wordHashSet transports
    ({
        "scalarTransport", "energyTransport", "icoUncoupledKinematicCloud"
    });
    const wordHashSet places
    ({
        "probes", "patchProbes", "sets", "surfaces", "fieldAverage", "columnAverage",
        "streamLine", "wallBoundedStreamLine", "nearWallFields"
    });
    const wordHashSet regions({"cellZone", "faceZone", "sampledSurface"});

    const dictionary functions(controlDict.subOrEmptyDict("functions"));
    for (const word& name : functions.toc())
    {
        const dictionary dict(functions.subOrEmptyDict(name));
        const word type(dict.getOrDefault<word>("type", ""));
        const string object("function object " + name + " (" + type + ") ");
        if (!dict.getOrDefault("enabled", true))
        {
            continue;
        }
        if (transports.found(type))
        {
            return object + "transports with phi";
        }
        if
        (
            places.found(type)
         || regions.found(dict.getOrDefault<word>("regionType", ""))
        )
        {
            return object + "has places that would slide along with the mesh";
        }
    }
    return string();
}

}


Foam::slidingMesh::slidingMesh
(
    deformableCloud& cloud,
    incompressibleFlow& flow
)
:
    cloud_(cloud),
    flow_(flow)
{
    const string reason(obstacle());
    cloud.effects().require("sliding", reason.empty(), reason);
    cloud.effects().decide
    (
        "sliding",
        reason.empty(),
        reason.empty() ? "the duct is straight, its ends are periodic" : reason
    );
}


Foam::string Foam::slidingMesh::obstacle()
{
    if (!flow_.solved() || !cloud_.coupled())
    {
        return "the flow does not feel the clumps";
    }
    const volVectorField& U = flow_.U();
    if (meshMotion::moves(U.mesh()))
    {
        return "the points of the mesh move";
    }
    if (mag(alongBoundary(U.mesh(), Zero)) == 0)
    {
        return "no straight duct with periodic ends";
    }
    if (cloud_.properties().found("injection") || !cloud_.outlets().empty())
    {
        return "clumps may enter or leave";
    }
    if (mag(alongBoundary(U.mesh(), cloud_.motion().held())) == 0)
    {
        return "a load holds a clump or acts at fixed places";
    }
    if (flow_.turbulence().type() != "Stokes")
    {
        return "the flow is turbulent";
    }
    word found(placedCondition(U));
    if (found.empty())
    {
        found = placedCondition(flow_.p());
    }
    if (!found.empty())
    {
        return "the condition of patch " + found + " may depend on the place";
    }
    found = placedSource(flow_.options(), U.name());
    if (!found.empty())
    {
        return "source " + found + " of fvOptions may depend on the place";
    }
    return functionAtRest(U.time().controlDict());
}


void Foam::slidingMesh::setVelocity()
{
    if (cloud_.effects().active("sliding"))
    {
        const volVectorField& U = flow_.U();
        const scalar dx = Foam::cbrt(gMin(U.mesh().V()));
        const scalar dt = U.time().deltaTValue();
        const vector fluid(U().weightedAverage(U.mesh().V()).value());

        // Of the present mesh: where it is refined, the normals change by round-off
        const tensor along(alongBoundary(U.mesh(), cloud_.motion().held()));
        const vector u(along & meanVelocity(cloud_));
        const vector q((along & fluid) - u);

        const vector V(u + 0.05*min(scalar(1), dx/dt/max(mag(q), VSMALL))*q);
        const scalar most =
            5*max(dx/dt, gMin(flow_.nu().primitiveField())/dx);
        cloud_.slideMesh(min(scalar(1), most/max(mag(V), VSMALL))*V);
        setFor_ = dt;
    }
}


void Foam::slidingMesh::beginStep()
{
    if (cloud_.effects().active("sliding"))
    {
        if (setFor_ != flow_.U().time().deltaTValue())
        {
            setVelocity();
        }
        setFor_ = 0;
        Info<< "Velocity of the mesh: " << cloud_.meshVelocity() << endl;
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::slidingMesh::flux() const
{
    const surfaceScalarField& phi = flow_.phi();
    if (cloud_.meshVelocity() == vector::zero)
    {
        return phi;
    }
    const fvMesh& mesh = phi.mesh();
    tmp<surfaceScalarField> result
    (
        phi
      - (
            dimensionedVector("V", dimVelocity, cloud_.meshVelocity())
          & mesh.Sf()
        )
    );
    result.ref().setOriented();
    forAll(mesh.boundary(), patchi)
    {
        if (!mesh.boundary()[patchi].coupled())
        {
            result.ref().boundaryFieldRef()[patchi] =
                phi.boundaryField()[patchi];
        }
    }
    return result;
}
