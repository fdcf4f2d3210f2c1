/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bodySurfaces.H"
#include "linear.H"
#include "planeInBox.H"
#include "surfaceDistance.H"
#include "zeroGradientFvPatchFields.H"
#include <cmath>

namespace
{

using namespace Foam;

//- More than there are processors
constexpr scalar mostProcessors = 1 << 24;

//- Fractions nearer than this to zero or one are zero or one
constexpr scalar leastCut = 1e-4;

template<class Type>
GeometricField<Type, fvPatchField, volMesh> emptyField
(
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dimensions
)
{
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject
        (
            name, mesh.time().timeName(), mesh,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        mesh,
        dimensioned<Type>("zero", dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );
}

}


Foam::bodySurfaces::bodySurfaces(const fvMesh& mesh)
:
    mesh_(mesh),
    geometry_(mesh),
    ghosts_(mesh),
    widths_(emptyField<vector>("cellWidths", mesh, dimLength)),
    distance_(emptyField<scalar>("bodyDistance", mesh, dimLength)),
    outwards_(emptyField<vector>("bodyNormal", mesh, dimless)),
    clump_(emptyField<scalar>("bodyNumber", mesh, dimless)),
    type_(mesh.nCells(), -1),
    fraction_(emptyField<scalar>("bodyFraction", mesh, dimless)),
    area_(mesh.nCells(), Zero),
    faceFraction_
    (
        IOobject
        (
            "bodyFaceFraction", mesh.time().timeName(), mesh,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        mesh,
        dimensionedScalar(dimless, Zero)
    )
{
    setWidths();
}


void Foam::bodySurfaces::setWidths()
{
    forAll(widths_, celli)
    {
        const boundBox box(mesh_.points(), mesh_.cellPoints()[celli], false);

        // Of the volume of the mesh cell, whatever its form
        const vector span(box.span());
        widths_[celli] = span*Foam::cbrt(mesh_.V()[celli]/cmptProduct(span));
    }
    widths_.correctBoundaryConditions();
}


Foam::bodySurfaces::places Foam::bodySurfaces::aroundSpheres
(
    const clumpImage& image,
    const clumpType& type
) const
{
    const scalarField& radii = type.radii();
    places result;
    for (const label celli : geometry_.find(image.box, 3))
    {
        const point& x = geometry_[celli].x;
        scalar nearest = GREAT;
        label sphere = 0;
        forAll(image.x, i)
        {
            const scalar d = mag(x - image.x[i]) - radii[i];
            if (d < nearest)
            {
                nearest = d;
                sphere = i;
            }
        }
        if (nearest < reach(celli))
        {
            const vector away(x - image.x[sphere]);
            result.append
            (
                place{celli, nearest, away/max(mag(away), VSMALL)}
            );
        }
    }
    return result;
}


Foam::bodySurfaces::places Foam::bodySurfaces::aroundSurface
(
    const clumpImage& image,
    const clumpType& type
) const
{
    places result;
    DynamicList<point> centres;
    scalar farthest = 0;
    const boundBox nodes(image.x, false);
    for (const label celli : geometry_.find(nodes, 3))
    {
        const point& x = geometry_[celli].x;
        if (mag(x - nodes.nearest(x)) < reach(celli))
        {
            result.append(place{celli, 0, Zero});
            centres.append(x);
            farthest = max(farthest, reach(celli));
        }
    }
    if (result.empty())
    {
        return result;
    }
    const pointField x(centres);
    const surfaceDistance surface
    (
        type.surface(), image.x, image.transform.invertsHands()
    );
    const auto nearest = surface.nearest(x, farthest);
    const boolList within(surface.inside(x, nearest));
    label n = 0;
    forAll(nearest, k)
    {
        place p = result[k];
        if (nearest[k].found)
        {
            p.distance = nearest[k].distance;
            p.outwards = nearest[k].outwards;
        }
        else
        {
            p.distance = (within[k] ? -1 : 1)*farthest;
        }
        if (p.distance < reach(p.celli))
        {
            result[n++] = p;
        }
    }
    result.setSize(n);
    return result;
}


Foam::scalarField Foam::bodySurfaces::displacements
(
    const PtrList<clumpType>& types,
    const UList<places>& around
)
{
    UList<clumpImage>& images = ghosts_.images();
    scalarField result(images.size(), Zero);
    scalarField areas(images.size(), Zero);

    // Sums of volume or area over all mesh cells, for every image
    const auto add = [&](const bool ofArea)
    {
        forAll(images, a)
        {
            images[a].inside = 0;
            for (const place& p : around[a])
            {
                const planeInBox::part part = planeInBox::behind
                (
                    p.distance + result[a],
                    widthsAlong
                    (
                        p.celli, p.outwards == vector::zero ? vector::one : p.outwards
                    )
                );
                images[a].inside +=
                    mesh_.V()[p.celli]*(ofArea ? part.area : part.fraction);
            }
        }
        ghosts_.sumInside();
    };
    add(true);
    forAll(images, a)
    {
        areas[a] = images[a].inside;
    }
    for (label pass = 0; pass < 2; ++pass)
    {
        add(false);
        forAll(images, a)
        {
            const scalar V = types[images[a].typeId].volume();
            const scalar more = images[a].inside - V;
            if (mag(more) < 0.1*V && areas[a] > 0)
            {
                result[a] += more/areas[a];
            }
        }
    }
    return result;
}


void Foam::bodySurfaces::update(const deformableCloud& cloud)
{
    UList<clumpImage>& own = ghosts_.own(cloud.size());
    label index = 0;
    for (const clumpParcel& p : cloud)
    {
        own[index].set(p, cloud.type(p), p.state(), index);
        ++index;
    }
    ghosts_.update();
    const UList<clumpImage>& images = ghosts_.images();

    List<places> around(images.size());
    forAll(images, a)
    {
        const clumpType& type = cloud.types()[images[a].typeId];
        around[a] =
            type.hasTriangles()
          ? aroundSurface(images[a], type) : aroundSpheres(images[a], type);
    }
    const scalarField inwards(displacements(cloud.types(), around));

    forAll(type_, celli)
    {
        distance_[celli] = reach(celli);
        outwards_[celli] = Zero;
        clump_[celli] = 0;
        type_[celli] = -1;
    }
    forAll(images, a)
    {
        const labelPair& id = images[a].id;
        const label typei = images[a].typeId;
        for (const place& p : around[a])
        {
            const scalar d = p.distance + inwards[a];
            if (d < distance_[p.celli])
            {
                distance_[p.celli] = d;
                outwards_[p.celli] = p.outwards;
                clump_[p.celli] = 1 + id.first() + mostProcessors*id.second();
                type_[p.celli] = cloud.types()[typei].whole(typei);
            }
        }
    }
    distance_.correctBoundaryConditions();
    outwards_.correctBoundaryConditions();
    clump_.correctBoundaryConditions();
    setCells();
    setFaces();
}


Foam::labelPair Foam::bodySurfaces::idOf(const label celli) const
{
    const scalar number = clump_[celli] - 1;
    const label id(std::floor(number/mostProcessors));
    return labelPair(label(number - mostProcessors*id), id);
}


void Foam::bodySurfaces::setCells()
{
    forAll(area_, celli)
    {
        const vector& n = outwards_[celli];
        planeInBox::part part{scalar(distance_[celli] < 0 ? 1 : 0), 0};
        if (n != vector::zero)
        {
            part = planeInBox::behind(distance_[celli], widthsAlong(celli, n));
        }
        const bool cut = part.fraction > leastCut && part.fraction < 1 - leastCut;
        fraction_[celli] = cut ? part.fraction : part.fraction < 0.5 ? 0 : 1;
        area_[celli] = cut ? part.area : 0;
    }
    fraction_.correctBoundaryConditions();
}


void Foam::bodySurfaces::setFaces()
{
    const surfaceScalarField d(linearInterpolate(distance_));
    const surfaceVectorField n(linearInterpolate(outwards_));
    const surfaceVectorField h(linearInterpolate(widths_));
    const auto theta = []
    (
        const scalar distance,
        const vector& normal,
        const vector& width,
        const vector& S
    )
    {
        const scalar size = mag(normal);
        if (size < 0.1)
        {
            return scalar(distance < 0 ? 1 : 0);
        }
        const vector e(cmptMag(S)/mag(S));
        return planeInBox::behind
        (
            distance,
            cmptMultiply(cmptMultiply(cmptMag(normal)/size, width), vector::one - e)
        ).fraction;
    };
    scalarField& inner = faceFraction_.primitiveFieldRef();
    forAll(inner, facei)
    {
        inner[facei] = theta(d[facei], n[facei], h[facei], mesh_.Sf()[facei]);
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const vectorField& S = patch.Sf();
        const vectorField& nb = n.boundaryField()[patchi];
        const vectorField& hb = h.boundaryField()[patchi];
        scalarField db(d.boundaryField()[patchi]);
        if (!patch.coupled())
        {
            db += nb & (patch.Cf() - patch.Cn());
        }
        fvsPatchScalarField& outer = faceFraction_.boundaryFieldRef()[patchi];
        forAll(S, i)
        {
            outer[i] = theta(db[i], nb[i], hb[i], S[i]);
        }
    }
}
