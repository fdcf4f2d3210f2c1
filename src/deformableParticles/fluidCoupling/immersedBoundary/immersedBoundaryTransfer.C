/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "immersedBoundary.H"
#include "fvmSup.H"

// Transfer between the spheres of the clumps and the cells of the mesh

namespace
{

using namespace Foam;

//- Reaction of the forcing [N/m3]
vector reaction(const hydrodynamicForceModel::flow& f, const label celli)
{
    return f.rho*f.strength[celli]*(f.U[celli] - f.solidVelocity[celli]);
}

//- Velocity that an image imposes at x, with the weights of its spheres
vector imposed
(
    const clumpImage& image, const point& x, const UList<sphereWeight>& weights
)
{
    vector result(Zero);
    for (const sphereWeight& s : weights)
    {
        const label i = s.i;
        const vector r(x - image.x[i]);
        result +=
            s.w*(image.u[i] + (image.omega[i] ^ r) + image.contraction*r);
    }
    return result;
}

}

template<class Images, class Action>
void Foam::immersedBoundary::visit(Images& images, const Action& action) const
{
    forAll(images, a)
    {
        const coveredCells& covered = covered_[a];
        forAll(covered.cells(), k)
        {
            const coveredCell& c = covered.cells()[k];
            action
            (
                images[a], covered, c, covered.weights(k),
                c.forcingWeight/max(sumForcingWeights_[c.celli], VSMALL)
            );
        }
    }
}


void Foam::immersedBoundary::setSolidVolumes(UList<clumpImage>& images) const
{
    visit
    (
        images,
        []
        (
            clumpImage& image, const coveredCells&,
            const coveredCell& c, const UList<sphereWeight>& weights,
            const scalar fraction
        )
        {
            if (c.moves())
            {
                for (const sphereWeight& s : weights)
                {
                    const scalar V = c.volume*fraction*s.w;
                    const vector r(c.x - image.x[s.i]);
                    constraintForces& constraint = image.constraint;
                    constraint.solidVolumes[s.i] += V;
                    constraint.solidMoments[s.i] += V*r;
                    constraint.solidInertias[s.i] +=
                        V*(magSqr(r)*symmTensor::I - sqr(r));
                }
            }
        }
    );
}


void Foam::immersedBoundary::setViscosities
(
    const volScalarField& nu,
    UList<clumpImage>& images
) const
{
    for (clumpImage& image : images)
    {
        image.viscosity = Zero;
    }
    visit
    (
        images,
        [&nu]
        (
            clumpImage& image, const coveredCells&,
            const coveredCell& c, const UList<sphereWeight>&,
            const scalar
        )
        {
            if (c.distance > 0 && !c.centreInside)
            {
                image.viscosity += c.volume*vector2D(nu[c.celli], 1);
            }
        }
    );
}


void Foam::immersedBoundary::setConstraints(UList<clumpImage>& images) const
{
    visit
    (
        images,
        []
        (
            clumpImage& image, const coveredCells& covered,
            const coveredCell& c, const UList<sphereWeight>& weights,
            const scalar
        )
        {
            if (c.solid == 0)
            {
                return;
            }
            const scalar V = c.volume*c.solid;
            imageForces& constraint = image.constraint;
            constraint.c += 3*V;
            for (const sphereWeight& s : weights)
            {
                const label i = s.i;
                const vector r(c.x - image.x[i]);
                const vector g(V*covered.gradWeight(c, i, s.w, r));
                constraint.f[i] += g;
                constraint.t[i] += r ^ g;
                constraint.c += r & g;
            }
        }
    );
}


void Foam::immersedBoundary::sampleVelocity
(
    const volVectorField& U,
    UList<clumpImage>& images
) const
{
    for (clumpImage& image : images)
    {
        image.fluid.reset(image.x.size());
        const coveredCells covered(coveredBy(image));
        forAll(covered.cells(), k)
        {
            const coveredCell& c = covered.cells()[k];
            const scalar V = c.volume*c.lambda;
            for (const sphereWeight& s : covered.weights(k))
            {
                image.fluid.f[s.i] += V*s.w*U[c.celli];
                image.fluid.t[s.i] += V*s.w*vector::one;
            }
        }
    }
}


void Foam::immersedBoundary::impose(const UList<clumpImage>& images)
{
    for (const coveredCells& covered : covered_)
    {
        for (const coveredCell& c : covered.cells())
        {
            solidVelocity_[c.celli] = Zero;
            dilation_[c.celli] = 0;
            sumFriction_[c.celli] = 0;
            frictionVelocity_[c.celli] = Zero;
        }
    }

    visit
    (
        images,
        [this]
        (
            const clumpImage& image, const coveredCells& covered,
            const coveredCell& c, const UList<sphereWeight>& weights,
            const scalar fraction
        )
        {
            const bool dilates = dilates_ && c.solid > 0;
            const vector velocity(imposed(image, c.x, weights));
            solidVelocity_[c.celli] += fraction*velocity;
            if (c.friction > 0)
            {
                sumFriction_[c.celli] += c.friction;
                frictionVelocity_[c.celli] += c.friction*velocity;
            }
            if (!dilates)
            {
                return;
            }
            const scalar k = image.contraction;
            scalar dilation = 3*k;
            for (const sphereWeight& s : weights)
            {
                const label i = s.i;
                const vector r(c.x - image.x[i]);
                const vector u(image.u[i] + (image.omega[i] ^ r) + k*r);
                dilation += covered.gradWeight(c, i, s.w, r) & u;
            }
            dilation_[c.celli] += c.solid*dilation;
        }
    );
}


Foam::tmp<Foam::fvVectorMatrix> Foam::immersedBoundary::forcing
(
    const volVectorField& U
) const
{
    return strength_*solidVelocity_ - fvm::Sp(strength_, U);
}


void Foam::immersedBoundary::integrate
(
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& nu,
    const scalar rho,
    UList<clumpImage>& images
)
{
    const hydrodynamicForceModel::flow flow
    {
        U, p, nu, rho, solidFraction_, solidVelocity_, strength_
    };
    forceModel_->prepare(flow);

    for (clumpImage& image : images)
    {
        image.fluid.reset(image.x.size());
    }

    visit
    (
        images,
        [&]
        (
            clumpImage& image, const coveredCells& covered,
            const coveredCell& c, const UList<sphereWeight>& weights,
            const scalar fraction
        )
        {
            vector density((*forceModel_)(flow, c.celli));
            if (covered.fadeFactor() < 1)
            {
                // Divided by the fade factor later, which other models do not bear
                const scalar phi = covered.fadeFactor();
                density =
                    phi*density + (1 - phi)*reaction(flow, c.celli);
            }
            vector F(c.volume*fraction*density);
            if (c.friction > 0)
            {
                F +=
                    c.volume*rho*c.friction
                   *(
                        frictionVelocity_[c.celli]/sumFriction_[c.celli]
                      - imposed(image, c.x, weights)
                    );
            }
            const scalar P = dilates_ ? c.volume*c.solid*rho*p[c.celli] : 0;

            imageForces& fluid = image.fluid;
            fluid.c -= 3*P;
            for (const sphereWeight& s : weights)
            {
                const label i = s.i;
                const vector r(c.x - image.x[i]);
                vector g(s.w*F);
                if (P != 0)
                {
                    g -= P*covered.gradWeight(c, i, s.w, r);
                }
                fluid.f[i] += g;
                fluid.t[i] += r ^ g;
                fluid.c += r & g;
            }
        }
    );
}


Foam::vector Foam::immersedBoundary::forceOnFluid
(
    const volVectorField& U,
    const scalar rho
) const
{
    return gSum
    (
        rho*mesh_.V()*strength_.primitiveField()
       *(solidVelocity_.primitiveField() - U.primitiveField())
    );
}
