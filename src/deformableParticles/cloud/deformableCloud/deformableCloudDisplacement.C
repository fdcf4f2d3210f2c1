/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "nearestCentres.H"

Foam::tmp<Foam::volVectorField> Foam::deformableCloud::displacement() const
{
    // Of the clumps of all processors
    List<pointField> centres(Pstream::nProcs());
    List<vectorField> displacements(Pstream::nProcs());
    pointField& from = centres[Pstream::myProcNo()];
    vectorField& by = displacements[Pstream::myProcNo()];
    from.setSize(size());
    by.setSize(size());
    scalar reach = 0;
    label index = 0;
    for (const clumpParcel& p : *this)
    {
        const clumpType& ct = type(p);
        const pointField& x = ghosts_.images()[index].x;
        from[index] = sum(ct.masses()*x)/sum(ct.masses());
        by[index] = p.centre(ct) - from[index];
        reach = max(reach, 6*ct.reach());
        ++index;
    }
    reduce(reach, maxOp<scalar>());
    Pstream::gatherList(centres);
    Pstream::scatterList(centres);
    Pstream::gatherList(displacements);
    Pstream::scatterList(displacements);

    // And of their periodic images
    DynamicList<point> images;
    DynamicList<vector> ofImages;
    for (const vector& shift : ghosts_.shifts())
    {
        forAll(centres, proci)
        {
            images.append(pointField(centres[proci] + shift));
            ofImages.append(displacements[proci]);
        }
    }

    auto result = tmp<volVectorField>::New
    (
        IOobject("displacement", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimLength, Zero)
    );
    const labelList nearest
    (
        nearestCentres(mesh_.cellCentres(), images, reach)
    );
    forAll(nearest, celli)
    {
        if (nearest[celli] >= 0)
        {
            result.ref()[celli] = ofImages[nearest[celli]];
        }
    }
    result.ref().correctBoundaryConditions();
    return result;
}
