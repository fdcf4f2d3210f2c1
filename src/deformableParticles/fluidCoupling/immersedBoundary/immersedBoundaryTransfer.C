/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "immersedBoundary.H"
#include "fvmSup.H"

// Transfer between the spheres of the clumps and the cells of the mesh

template<class Images, class Action>
void Foam::immersedBoundary::visit(Images& images, const Action& action) const
{
    forAll(images, a)
    {
        const coveredCells& c = covered_[a];
        const label n = images[a].x.size();

        forAll(c.cells, k)
        {
            const label celli = c.cells[k];
            const coveredCell cell
            {
                celli,
                mesh_.cellCentres()[celli],
                mesh_.V()[celli],
                c.share[k]/max(sumShare_[celli], VSMALL),
                solidFraction_[celli]*c.lambda[k]
               /max(sumLambda_[celli], VSMALL),
                SubList<scalar>(c.weights, n, n*k),
                SubList<vector>(c.gradWeights, n, n*k)
            };
            action(images[a], cell);
        }
    }
}


void Foam::immersedBoundary::setDilations(UList<clumpImage>& images) const
{
    visit
    (
        images,
        [](clumpImage& image, const coveredCell& c)
        {
            const scalar V = c.volume*c.solid;
            forAll(c.gradWeights, i)
            {
                const vector g(V*c.gradWeights[i]);
                image.dilation.g[i] += g;
                image.dilation.h[i] += (c.x - image.x[i]) ^ g;
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
    visit
    (
        images,
        [&U](clumpImage& image, const coveredCell& c)
        {
            const scalar V = c.volume*c.solid;
            forAll(c.weights, i)
            {
                image.force[i] += V*c.weights[i]*U[c.celli];
                image.torque[i] += V*c.weights[i]*vector::one;
            }
        }
    );
}


void Foam::immersedBoundary::impose(const UList<clumpImage>& images)
{
    for (const coveredCells& c : covered_)
    {
        for (const label celli : c.cells)
        {
            solidVelocity_[celli] = Zero;
        }
    }
    if (dilates_)
    {
        dilation_ = dimensionedScalar(dilation_.dimensions(), Zero);
    }

    visit
    (
        images,
        [this](const clumpImage& image, const coveredCell& c)
        {
            forAll(c.weights, i)
            {
                const vector u
                (
                    image.u[i] + (image.omega[i] ^ (c.x - image.x[i]))
                );
                solidVelocity_[c.celli] += c.share*c.weights[i]*u;

                if (dilates_)
                {
                    dilation_[c.celli] += c.solid*(c.gradWeights[i] & u);
                }
            }
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
        image.force = Zero;
        image.torque = Zero;
    }

    visit
    (
        images,
        [&](clumpImage& image, const coveredCell& c)
        {
            const vector F(c.volume*c.share*(*forceModel_)(flow, c.celli));
            const scalar P = dilates_ ? c.volume*c.solid*rho*p[c.celli] : 0;

            forAll(c.weights, i)
            {
                const vector g(c.weights[i]*F - P*c.gradWeights[i]);
                image.force[i] += g;
                image.torque[i] += (c.x - image.x[i]) ^ g;
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
