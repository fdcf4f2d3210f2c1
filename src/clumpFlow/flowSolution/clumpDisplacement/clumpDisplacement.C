/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpDisplacement.H"
#include "clumpTotals.H"
#include "deformableCloud.H"
#include "foamCompat.H"
#include "nearestCentres.H"
#include "IPstream.H"
#include "sentMessages.H"

namespace
{

using namespace Foam;

//- From 1 at two thirds of the reach smoothly to 0 at the reach
scalar fading(const scalar part)
{
    const scalar x = min(max(3*(1 - part), scalar(0)), scalar(1));
    return sqr(x)*(3 - 2*x);
}


//- The clumps of all processors and their images within reach of this mesh:
//  where they come from, and their displacements
void nearImages
(
    const ghostExchange& ghosts,
    const scalar reach,
    const UList<point>& from,
    const UList<vector>& by,
    DynamicList<point>& images,
    DynamicList<vector>& ofImages
)
{
    // To every processor the clumps and images within reach of its box
    const auto imagesOf = [&]
    (
        const ghostExchange::partner& to,
        DynamicList<point>& near,
        DynamicList<vector>& ofNear
    )
    {
        const boundBox box(grown(ghosts.box(to.proci), reach));
        for (const label s : to.transforms)
        {
            const imageTransform& image = ghosts.transforms()[s];
            forAll(from, k)
            {
                const point x(image.position(from[k]));
                if (box.contains(x))
                {
                    near.append(x);
                    ofNear.append(image.polar(by[k]));
                }
            }
        }
    };

    const UList<ghostExchange::partner>& partners = ghosts.partners(reach);
    sentMessages messages(partners.size());
    forAll(partners, n)
    {
        const ghostExchange::partner& to = partners[n];
        if (to.proci != Pstream::myProcNo())
        {
            DynamicList<point> sent;
            DynamicList<vector> ofSent;
            imagesOf(to, sent, ofSent);
            sentMessages::stream os(messages, n, to.proci);
            os << pointField(sent) << vectorField(ofSent);
        }
    }

    for (const ghostExchange::partner& of : partners)
    {
        if (of.proci == Pstream::myProcNo())
        {
            imagesOf(of, images, ofImages);
        }
        else
        {
            IPstream is(UPstream::commsTypes::blocking, of.proci);
            images.append(pointField(is));
            ofImages.append(vectorField(is));
        }
    }
}

}


Foam::tmp<Foam::volVectorField> Foam::clumpDisplacement
(
    const deformableCloud& cloud
)
{
    const fvMesh& mesh = refCast<const fvMesh>(cloud.pMesh());
    const ghostExchange& ghosts = cloud.ghosts();
    const scalar half = 0.5*mesh.time().deltaTValue();
    pointField from(cloud.size());
    vectorField by(cloud.size());
    const scalar reach = 3*largestDiameter(cloud);
    label index = 0;
    for (const clumpParcel& p : cloud)
    {
        // Nodes of surfaces are coupled with the fluid at the end of a step
        const clumpType& type = cloud.type(p);
        from[index] = p.centre(type) - p.sinceMet();
        by[index] =
            p.sinceMet()
          + (type.ofSpheres() ? 1 : 2)*half*cloud.velocityOverMesh(p);
        ++index;
    }

    DynamicList<point> images;
    DynamicList<vector> ofImages;
    nearImages(ghosts, reach, from, by, images, ofImages);

    auto result = tmp<volVectorField>::New
    (
        IOobject("displacement", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimLength, Zero)
    );
    const labelList nearest
    (
        nearestCentres(mesh.cellCentres(), images, reach)
    );
    forAll(nearest, celli)
    {
        if (nearest[celli] >= 0)
        {
            const label k = nearest[celli];
            vector way(ofImages[k]);
            if (mesh.moving())
            {
                // Less that of the mesh cell itself
                way -=
                    mesh.cellCentres()[celli]
                  - mesh.cells()[celli].centre(mesh.oldPoints(), mesh.faces());
            }
            result.ref()[celli] =
                fading(mag(mesh.cellCentres()[celli] - images[k])/reach)*way;
        }
    }
    result.ref().correctBoundaryConditions();
    return result;
}
