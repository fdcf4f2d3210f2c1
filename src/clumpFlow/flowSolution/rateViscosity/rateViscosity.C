/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rateViscosity.H"
#include "coupledPatches.H"
#include "fluidCoupling.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvmLaplacian.H"
#include "ghostExchange.H"
#include "linear.H"
#include "mirroredValues.H"
#include "syncTools.H"

namespace
{

using namespace Foam;

//- Closer than this part of the width of the mesh cell, the surface is as good as in the
//  centre, see cellGeometry::wallConductance
constexpr scalar closest = 0.02;

//- Of the slope at the wall over the rate of strain in the centre
constexpr scalar largestRatio = 10;

//- action(neighbour, -1) for every neighbour of a mesh cell; (-1, boundary face) where it is
//  on the other side of a processor or periodic patch
template<class Action>
void forNeighbours(const polyMesh& mesh, const label celli, const Action& action)
{
    for (const label facei : mesh.cells()[celli])
    {
        const label other = facei - mesh.nInternalFaces();
        if (other < 0)
        {
            const label owner = mesh.faceOwner()[facei];
            action(owner == celli ? mesh.faceNeighbour()[facei] : owner, -1);
        }
        else if (mesh.boundaryMesh()[mesh.boundaryMesh().whichPatch(facei)].coupled())
        {
            action(-1, other);
        }
    }
}

}


Foam::rateViscosity::rateViscosity
(
    deformableCloud& cloud,
    incompressibleFlow& flow
)
:
    cloud_(cloud),
    flow_(flow),
    acts_(flow.solved() && cloud.coupled() && !flow.Newtonian()),
    withClumps_(false)
{
    if (acts_)
    {
        ghostExchange::checkMatching
        (
            flow.U().mesh().boundaryMesh(), "a viscosity that depends on the rate of strain",
            flow.U().mesh().lookupObject<IOdictionary>("transportProperties")
        );
    }
}


template<class Type>
Foam::List<Type> Foam::rateViscosity::across(const UList<Type>& values) const
{
    List<Type> result;
    syncTools::swapBoundaryCellList(flow_.U().mesh(), values, result);
    return result;
}


void Foam::rateViscosity::findSolid()
{
    const label n = flow_.U().size();
    distance_ = scalarField(n, GREAT);
    isSolid_ = labelList(n, Zero);
    for (const coveredCells& covered : cloud_.boundary().covered())
    {
        // Fluid passes through a clump that is partly absent
        if (covered.fadeFactor() == 1)
        {
            for (const coveredCell& c : covered.cells())
            {
                distance_[c.celli] = min(distance_[c.celli], c.distance);
                isSolid_[c.celli] =
                    isSolid_[c.celli] || c.centreInside || c.distance < 0;
            }
        }
    }
    solid_.clear();
    forAll(isSolid_, celli)
    {
        if (isSolid_[celli])
        {
            solid_.append(celli);
        }
        else
        {
            distance_[celli] =
                max(distance_[celli], closest*Foam::cbrt(flow_.U().mesh().V()[celli]));
        }
    }
}


void Foam::rateViscosity::extend(volVectorField& U) const
{
    const vectorField& us = cloud_.boundary().solidVelocity().primitiveField();
    const vectorField relative(U.primitiveField() - us);
    const labelList solidAcross(across(isSolid_));
    const scalarList distanceAcross(across(distance_));
    const List<vector> relativeAcross(across(relative));

    for (const label celli : solid_)
    {
        vector sum(Zero);
        scalar weight = 0;
        forNeighbours(U.mesh(), celli, [&](const label other, const label facei)
        {
            const scalar a = other < 0 ? distanceAcross[facei] : distance_[other];
            if (!(other < 0 ? solidAcross[facei] : isSolid_[other]) && a < GREAT)
            {
                sum += a*(other < 0 ? relativeAcross[facei] : relative[other]);
                weight += sqr(a);
            }
        });
        if (weight > 0)
        {
            U[celli] = us[celli] + distance_[celli]/weight*sum;
        }
    }
    evaluateCoupled(U.boundaryFieldRef());
}


template<class Type>
void Foam::rateViscosity::extend
(
    GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    labelList known(field.size(), 1);
    UIndirectList<label>(known, solid_) = 0;
    label nFound = 1;
    while (nFound)
    {
        const labelList knownAcross(across(known));
        const List<Type> valuesAcross(across(field.primitiveField()));
        DynamicList<label> found;
        for (const label celli : solid_)
        {
            if (known[celli])
            {
                continue;
            }
            Type sum(Zero);
            label n = 0;
            forNeighbours(field.mesh(), celli, [&](const label other, const label facei)
            {
                if (other < 0 ? knownAcross[facei] : known[other])
                {
                    sum += other < 0 ? valuesAcross[facei] : field[other];
                    ++n;
                }
            });
            if (n)
            {
                field[celli] = sum/scalar(n);
                found.append(celli);
            }
        }
        UIndirectList<label>(known, found) = 1;
        nFound = returnReduce(found.size(), sumOp<label>());
    }
    field.correctBoundaryConditions();
}


template<class Action>
void Foam::rateViscosity::withExtended(const Action& action)
{
    volVectorField& U = flow_.U();
    findSolid();

    // That of the last step is the velocity before it is continued
    U.storeOldTimes();
    const vectorField inside(U.primitiveField(), solid_);
    extend(U);
    action();
    UIndirectList<vector>(U.primitiveFieldRef(), solid_) = inside;
    evaluateCoupled(U.boundaryFieldRef());
}


void Foam::rateViscosity::setAtWall
(
    const scalarField& rate,
    const scalarField& doubled
)
{
    const volVectorField& U = flow_.U();
    const scalarField& nu = flow_.nu().primitiveField();
    const vectorField& us = cloud_.boundary().solidVelocity().primitiveField();
    const labelList solidAcross(across(isSolid_));

    atWall_ = scalarField(U.size(), Zero);
    forAll(atWall_, celli)
    {
        bool atWall = false;
        if (!isSolid_[celli] && distance_[celli] < GREAT)
        {
            forNeighbours(U.mesh(), celli, [&](const label other, const label facei)
            {
                atWall =
                    atWall || (other < 0 ? solidAcross[facei] : isSolid_[other]);
            });
        }
        if (atWall)
        {
            const scalar slope = mag(U[celli] - us[celli])/distance_[celli];
            const scalar index = Foam::log(doubled[celli]/nu[celli])/Foam::log(2.0);
            const scalar ratio =
                rate[celli] > VSMALL ? slope/rate[celli] : scalar(1);
            atWall_[celli] =
                nu[celli]*Foam::pow(min(max(ratio, 1/largestRatio), largestRatio), index);
        }
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::rateViscosity::onFaces() const
{
    const fvMesh& mesh = flow_.U().mesh();
    tmp<surfaceScalarField> result(linearInterpolate(flow_.nu()));
    surfaceScalarField& nu = result.ref();
    const labelList solidAcross(across(isSolid_));
    const scalarList atWallAcross(across(atWall_));

    forAll(nu, facei)
    {
        const label i = mesh.owner()[facei];
        const label j = mesh.neighbour()[facei];
        if (isSolid_[i] != isSolid_[j])
        {
            nu[facei] = max(atWall_[i], atWall_[j]);
        }
    }
    for (fvsPatchScalarField& onPatch : nu.boundaryFieldRef())
    {
        const fvPatch& patch = onPatch.patch();
        if (patch.coupled())
        {
            forAll(onPatch, k)
            {
                const label i = patch.faceCells()[k];
                const label other = patch.start() + k - mesh.nInternalFaces();
                if (isSolid_[i] != solidAcross[other])
                {
                    onPatch[k] = max(atWall_[i], atWallAcross[other]);
                }
            }
        }
    }
    return result;
}


Foam::tmp<Foam::fvVectorMatrix> Foam::rateViscosity::stress()
{
    if (!acts_ || !withClumps_ || (cloud_.fluids() && cloud_.fluids()->viscosity()))
    {
        return flow_.viscousStress();
    }
    const volVectorField& U = flow_.U();
    autoPtr<volTensorField> gradU;
    withExtended
    (
        [&]
        {
            gradU.reset(new volTensorField("gradU", fvc::grad(U)));
            setMirroredValues(*gradU, U);
        }
    );
    extend(*gradU);
    return flow_.viscousStress(onFaces()(), flow_.nu(), *gradU);
}


void Foam::rateViscosity::begin()
{
    if (acts_)
    {
        cloud_.setViscosities(flow_.nu());
    }
    correct(true);
}


void Foam::rateViscosity::force()
{
    if (acts_)
    {
        volScalarField nu("nuOfForcing", flow_.nu());
        nu.checkOut();
        forAll(atWall_, celli)
        {
            if (atWall_[celli] > 0)
            {
                nu[celli] = atWall_[celli];
            }
        }
        cloud_.setForcing(nu);
    }
}


void Foam::rateViscosity::correct(const bool withClumps)
{
    if (!acts_)
    {
        flow_.transport().correct();
        return;
    }
    volVectorField& U = flow_.U();
    auto& nu = U.mesh().lookupObjectRef<volScalarField>("nu");
    withClumps_ = withClumps;
    if (withClumps)
    {
        withExtended([&]
        {
            const scalarField rate(sqrt(2.0)*mag(symm(fvc::grad(U)().primitiveField())));

            // A power of two leaves U as it was
            U == 2*U;
            flow_.transport().correct();
            const scalarField doubled(nu.primitiveField());
            U == 0.5*U;
            flow_.transport().correct();
            setAtWall(rate, doubled);
        });
        extend(nu);
    }
    else
    {
        flow_.transport().correct();
        atWall_ = scalarField(U.size(), Zero);
    }
    cloud_.setViscosities(nu);
}
