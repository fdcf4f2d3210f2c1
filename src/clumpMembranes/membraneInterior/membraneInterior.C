/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneInterior.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvcSnGrad.H"
#include "linear.H"
#include "mirroredValues.H"

Foam::membraneInterior::membraneInterior
(
    const fvMesh& mesh,
    const PtrList<clumpType>& types,
    const UPtrList<surfaceKernel>& kernels,
    const cellGeometry& geometry,
    const vectorField& widths,
    const volScalarField& factor
)
:
    mesh_(mesh),
    types_(types),
    kernels_(kernels),
    geometry_(geometry),
    widths_(widths),
    factor_(factor),
    slip_
    (
        IOobject("interiorSlip", mesh.time().timeName(), mesh),
        mesh,
        dimensionedSymmTensor(dimPressure, Zero)
    ),
    across_(mesh.nCells(), Zero)
{}


void Foam::membraneInterior::reset()
{
    slip_ = dimensionedSymmTensor(dimPressure, Zero);
    across_ = symmTensorField(mesh_.nCells(), Zero);
    normals_.clear();
}


Foam::tmp<Foam::surfaceScalarField> Foam::membraneInterior::faceFactor() const
{
    return 1/linearInterpolate(1/factor_);
}


void Foam::membraneInterior::addSlip
(
    const UList<clumpImage>& images,
    const UList<DynamicList<stencilCell>>& stencils,
    volVectorField& force
)
{
    symmTensorField& slip = slip_.primitiveFieldRef();
    slip = Zero;
    forAll(stencils, a)
    {
        const clumpImage& image = images[a];
        const vectorField& normals = normals_[a];
        if (normals.empty())
        {
            continue;
        }
        const surfaceKernel& kernel = kernels_[image.typeId];
        const scalar part = 1 - 1/types_[image.typeId].viscosityRatio();
        vectorField s(normals.size());
        forAll(s, i)
        {
            const vector& n = normals[i];
            const vector& F = image.force[i];
            s[i] = kernel.correlation(n)*part*(F - n*(n & F));
        }
        for (const stencilCell& m : stencils[a])
        {
            const vector& n = normals[m.node];
            const scalar width = mag(cmptMultiply(widths_[m.celli], n));
            slip[m.celli] +=
                m.weight*width/geometry_[m.celli].volume*twoSymm(n*s[m.node]);
        }
    }
    slip_.correctBoundaryConditions();
    const surfaceVectorField forces
    (
        faceFactor()*(mesh_.Sf() & linearInterpolate(slip_))
    );
    force.primitiveFieldRef() += fvc::div(forces + couple(forces))().primitiveField();
}


Foam::tmp<Foam::volTensorField> Foam::membraneInterior::stressIn
(
    const surfaceVectorField& forces
) const
{
    const surfaceVectorField& Sf = mesh_.Sf();
    tmp<volTensorField> tresult
    (
        new volTensorField
        (
            IOobject("interiorStress", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedTensor(forces.dimensions()/dimArea, Zero)
        )
    );
    tensorField& result = tresult.ref().primitiveFieldRef();
    symmTensorField areas(mesh_.nCells(), Zero);
    const auto add = [&](const label celli, const vector& S, const vector& force)
    {
        if (inLayer(celli))
        {
            areas[celli] += sqr(S)/mag(S);
            result[celli] += S*force/mag(S);
        }
    };
    forAll(mesh_.neighbour(), facei)
    {
        add(mesh_.owner()[facei], Sf[facei], forces[facei]);
        add(mesh_.neighbour()[facei], Sf[facei], forces[facei]);
    }
    forAll(mesh_.boundary(), patchi)
    {
        const labelUList& cells = mesh_.boundary()[patchi].faceCells();
        const vectorField& S = Sf.boundaryField()[patchi];
        forAll(S, i)
        {
            add(cells[i], S[i], forces.boundaryField()[patchi][i]);
        }
    }
    forAll(result, celli)
    {
        if (inLayer(celli))
        {
            result[celli] = inv(areas[celli]) & result[celli];
        }
    }
    return tresult;
}


Foam::tmp<Foam::surfaceVectorField> Foam::membraneInterior::couple
(
    const surfaceVectorField& forces
) const
{
    volTensorField change(stressIn(forces));
    forAll(change, celli)
    {
        const tensor& T = change[celli];
        change[celli] = (T.T() - T) & across_[celli];
    }
    change.correctBoundaryConditions();
    return mesh_.Sf() & linearInterpolate(change);
}


Foam::tmp<Foam::volTensorField> Foam::membraneInterior::strain
(
    const volVectorField& U,
    const scalar mu0
) const
{
    volTensorField gradU("gradU", fvc::grad(U));
    setMirroredValues(gradU, U);
    const dimensionedScalar mu("mu", dimDynamicViscosity, mu0);
    return stressIn
    (
        faceFactor()
       *(
            mesh_.magSf()*fvc::snGrad(U)
          + (mesh_.Sf() & linearInterpolate(T(gradU) + slip_/mu))
        )
    );
}


void Foam::membraneInterior::set
(
    const UList<clumpImage>& images,
    const UList<DynamicList<stencilCell>>& stencils
)
{
    across_ = Zero;
    normals_ = List<vectorField>(images.size());
    forAll(images, a)
    {
        const clumpType& type = types_[images[a].typeId];
        if (type.viscosityRatio() == 1)
        {
            continue;
        }
        normals_[a] = type.surface().areaVectors(images[a].x);
        for (vector& n : normals_[a])
        {
            n.normalise();
            n *= images[a].transform.invertsHands() ? -1 : 1;
        }
        for (const stencilCell& m : stencils[a])
        {
            across_[m.celli] += max(m.weight, scalar(0))*sqr(normals_[a][m.node]);
        }
    }
    for (symmTensor& N : across_)
    {
        N = innerSqr(innerSqr(N/max(tr(N), VSMALL)));
        N /= max(tr(N), VSMALL);
    }
}
