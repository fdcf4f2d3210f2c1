/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surroundingStress.H"
#include "foamCompat.H"
#include "fvcGrad.H"
#include "immersedBoundary.H"

Foam::List<Foam::Tuple2<Foam::label, Foam::point>>
Foam::functionObjects::surroundingStress::places
(
    const clumpType& type,
    const clumpImage& image
) const
{
    DynamicList<Tuple2<label, point>> result;
    const pointField& x = image.x;
    if (type.hasTriangles())
    {
        const vectorField S(type.surface().areaVectors(x));
        const scalar sign = image.transform.invertsHands() ? -1 : 1;
        forAll(x, i)
        {
            const vector n(sign*S[i]/max(mag(S[i]), VSMALL));
            result.append(Tuple2<label, point>(i, x[i] + distance_*n));
        }
        return List<Tuple2<label, point>>(result);
    }

    // To the faces and corners of a cube
    DynamicList<vector> directions(14);
    for (const scalar sign : {-1, 1})
    {
        directions.append(vector(sign, 0, 0));
        directions.append(vector(0, sign, 0));
        directions.append(vector(0, 0, sign));
        for (const scalar b : {-1, 1})
        {
            for (const scalar c : {-1, 1})
            {
                directions.append(vector(sign, b, c)/Foam::sqrt(3.0));
            }
        }
    }
    forAll(x, i)
    {
        for (const vector& n : directions)
        {
            const point y(x[i] + (type.radii()[i] + distance_)*n);
            bool outside = true;
            forAll(x, j)
            {
                outside =
                    outside
                 && (
                        j == i
                     || magSqr(y - x[j])
                      > sqr(type.radii()[j] + (1 - 1e-6)*distance_)
                    );
            }
            if (outside)
            {
                result.append(Tuple2<label, point>(i, y));
            }
        }
    }
    return List<Tuple2<label, point>>(result);
}


Foam::List<Foam::scalarField> Foam::functionObjects::surroundingStress::find
(
    const deformableCloud& cloud,
    const volVectorField& U,
    const volScalarField& nu
)
{
    if (mesh_.changing() || !ghosts_.valid())
    {
        ghosts_.reset(new ghostExchange(mesh_));
    }
    UList<clumpImage>& own = ghosts_->own(cloud.size());
    label k = 0;
    for (const clumpParcel& p : cloud)
    {
        clumpImage& image = own[k];
        image.set(p, cloud.type(p), p.state(), k++);
        image.box = grown(image.box, distance_);
        image.reach += distance_;
    }
    ghosts_->update();

    // Sums and numbers of the values of each sphere or node
    const tmp<volTensorField> gradient(fvc::grad(U));
    const scalar rho = cloud.fluidDensity();
    const scalarField* solid =
        cloud.coupled()
      ? &cloud.boundary().solidFraction().primitiveField() : nullptr;
    for (clumpImage& image : ghosts_->images())
    {
        image.moments.reset(image.x.size());
        for (const auto& place : places(cloud.types()[image.typeId], image))
        {
            const label celli = mesh_.findCell(place.second());
            if (celli >= 0 && !(solid && (*solid)[celli] > 0.5))
            {
                const symmTensor E(symm(gradient()[celli]));
                image.moments.m0[place.first()] += 1;
                image.moments.m2[place.first()] +=
                    rho*nu[celli]*Foam::sqrt(2*magSqr(E))*symmTensor::I;
            }
        }
    }
    ghosts_->returnMoments();

    List<scalarField> result(ghosts_->nOwn());
    forAll(result, n)
    {
        // The same in every frame
        const nodeMoments& sums = ghosts_->images()[n].moments;
        const scalarField stress(sums.m2.component(symmTensor::XX));
        const scalarField& number = sums.m0;
        const scalar mean = sum(stress)/max(sum(number), scalar(1));
        result[n].setSize(stress.size());
        forAll(stress, i)
        {
            result[n][i] = number[i] > 0.5 ? stress[i]/number[i] : mean;
        }
    }
    return result;
}
