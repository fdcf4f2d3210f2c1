/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fieldAtSpheres.H"

void Foam::setFieldAtSpheres
(
    const volVectorField& field,
    const volTensorField& gradient,
    UList<clumpImage>& images
)
{
    const fvMesh& mesh = field.mesh();
    const volVectorField& C = mesh.C();

    for (clumpImage& image : images)
    {
        image.fluid.reset(image.x.size());
        forAll(image.x, i)
        {
            const point& x = image.x[i];
            const label celli = mesh.findCell(x);
            if (celli >= 0)
            {
                image.fluid.f[i] =
                    field[celli] + ((x - C[celli]) & gradient[celli]);
                image.fluid.t[i] = vector::one;
            }
        }
    }
}
