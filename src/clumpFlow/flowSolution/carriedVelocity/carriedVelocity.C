/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "carriedVelocity.H"
#include "fvcFlux.H"
#include "fvcSurfaceIntegrate.H"
#include "gaussGrad.H"
#include "linear.H"

namespace
{

using namespace Foam;

//- Below this Reynolds number of a clump's motion inertia does not matter
constexpr scalar leastRe = 0.05;

//- Values on faces: linear, and four thirds of what a cubic polynomial adds
class faceValues
{
    surfaceScalarField ownerWeights_;
    surfaceScalarField ownerGradientWeights_;
    surfaceScalarField neighbourGradientWeights_;
    const surfaceVectorField delta_;

public:

    explicit faceValues(const fvMesh& mesh)
    :
        ownerWeights_(mesh.surfaceInterpolation::weights()),
        ownerGradientWeights_(4.0/3.0*sqr(1 - ownerWeights_)*ownerWeights_),
        neighbourGradientWeights_(4.0/3.0*sqr(ownerWeights_)*(ownerWeights_ - 1)),
        delta_(mesh.delta())
    {
        ownerWeights_ +=
            4.0/3.0*ownerWeights_*(1 - ownerWeights_*(3 - 2*ownerWeights_));
    }

    tmp<surfaceVectorField> operator()(const volVectorField& U) const
    {
        const volTensorField gradU
        (
            fv::gaussGrad<vector>::gradf(linearInterpolate(U), "gradient")
        );
        const surfaceTensorField gradient
        (
            surfaceInterpolationScheme<tensor>::interpolate
            (
                gradU, ownerGradientWeights_, neighbourGradientWeights_
            )
        );
        return
            surfaceInterpolationScheme<vector>::interpolate
            (
                U, ownerWeights_, 1 - ownerWeights_
            )
          + (delta_ & gradient);
    }
};

}


Foam::IOobject Foam::carriedVelocity::unregistered(const word& name) const
{
    return IOobject
    (
        name, U_.time().timeName(), U_.mesh(),
        IOobject::NO_READ, IOobject::NO_WRITE, false
    );
}


Foam::carriedVelocity::carriedVelocity(const volVectorField& U)
:
    U_(U),
    Euler_
    (
        word(U.mesh().ddtScheme("ddt(" + U.name() + ')')) == "Euler"
    )
{}


Foam::tmp<Foam::volVectorField> Foam::carriedVelocity::carried
(
    const surfaceScalarField& part,
    const label nParts
) const
{
    const fvMesh& mesh = U_.mesh();
    const volScalarField divergence(fvc::surfaceIntegrate(part));
    const faceValues onFaces(mesh);

    // The values beyond coupled patches are needed; derivatives are zero on others
    const auto zero = [&](const char* name)
    {
        return tmp<volVectorField>::New
        (
            unregistered(name), mesh, dimensionedVector(dimVelocity, Zero)
        );
    };
    tmp<volVectorField> tresult(zero("carried"));
    volVectorField& result = tresult.ref();
    result == U_.oldTime();
    volVectorField term(zero("term"));
    for (label i = 0; i < nParts; ++i)
    {
        vectorField sum(mesh.nCells(), Zero);
        for (label order = 1; order <= 3; ++order)
        {
            const volVectorField& of = order == 1 ? result : term;
            const volVectorField derivative
            (
                divergence*of - fvc::surfaceIntegrate(part*onFaces(of)())
            );
            term.primitiveFieldRef() = derivative.primitiveField()/order;
            term.correctBoundaryConditions();
            sum += term.primitiveField();
        }
        result.primitiveFieldRef() += sum;
        result.correctBoundaryConditions();
    }
    return tresult;
}


void Foam::carriedVelocity::carry
(
    const volVectorField& d,
    const scalar diameter,
    const scalar leastNu
)
{
    rate_.clear();
    swept_.clear();

    const fvMesh& mesh = U_.mesh();
    const dimensionedScalar dt(mesh.time().deltaT());
    const scalar speed = gMax(mag(d.primitiveField()))/dt.value();
    if (!Euler_ || speed*diameter < leastRe*leastNu)
    {
        return;
    }

    swept_.reset(new surfaceScalarField(unregistered("swept"), fvc::flux(d)));
    for (auto& patch : swept_->boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch = Zero;
        }
    }
    const scalarField Courant
    (
        0.5*fvc::surfaceSum(mag(*swept_))().primitiveField()/mesh.V().field()
    );
    const label nParts = max(label(1), label(std::ceil(gMax(Courant))));
    rate_.reset
    (
        new volVectorField
        (
            unregistered("rate"),
            (U_.oldTime() - carried(*swept_/nParts, nParts))/dt
        )
    );
}


Foam::tmp<Foam::surfaceScalarField> Foam::carriedVelocity::flux() const
{
    return *swept_/U_.mesh().time().deltaT();
}
