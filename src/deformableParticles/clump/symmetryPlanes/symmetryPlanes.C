/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "symmetryPlanes.H"
#include "PstreamReduceOps.H"
#include "StringStream.H"
#include "polyMesh.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"

namespace
{

//- Deviation from a plane that counts as rounding, relative to the size of the mesh or
//  to one
constexpr Foam::scalar roundOff = 1e-6;

}


Foam::symmetryPlanes::symmetryPlanes(const polyBoundaryMesh& patches)
:
    patches_(patches)
{
    for (label patchi = 0; patchi < patches.nNonProcessor(); ++patchi)
    {
        if (isOne(patches[patchi]))
        {
            add(patches[patchi]);
        }
    }
}


bool Foam::symmetryPlanes::isOne(const polyPatch& patch)
{
    return isA<symmetryPlanePolyPatch>(patch) || isA<symmetryPolyPatch>(patch);
}


Foam::vector Foam::symmetryPlanes::normal(const polyPatch& patch) const
{
    vector n(gSum(patch.faceAreas()));
    n /= max(mag(n), VSMALL);
    for (scalar& component : n)
    {
        component = mag(component) < roundOff*roundOff ? 0 : component;
    }
    return n/max(mag(n), VSMALL);
}


void Foam::symmetryPlanes::add(const polyPatch& patch)
{
    if (!returnReduce(patch.size(), sumOp<label>()))
    {
        return;
    }
    const polyMesh& mesh = patches_.mesh();
    const vector n(normal(patch));

    // In the plane, and of the whole mesh
    scalar least = GREAT;
    scalar most = -GREAT;
    scalar farthest = -GREAT;
    boundBox box(boundBox::invertedBox);
    for (const point& x : patch.localPoints())
    {
        least = min(least, n & x);
        most = max(most, n & x);
    }
    for (const point& x : mesh.points())
    {
        farthest = max(farthest, n & x);
        box.add(x);
    }
    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());
    reduce(farthest, maxOp<scalar>());
    box.reduce();

    const scalar tolerance = roundOff*box.mag();
    if (fault_.empty() && !(most - least < tolerance))
    {
        fault_ = "Patch " + patch.name() + " of type " + patch.type()
          + " is not flat: only behind a plane have clumps mirror images.";
    }
    if (fault_.empty() && farthest > most + tolerance)
    {
        fault_ = "Patch " + patch.name() + " of type " + patch.type()
          + " lies in a plane that has mesh on both sides: the mirror image of the"
            " mesh would overlap with it.";
    }
    const plane found{n, most, patch.index()};
    for (const plane& p : planes_)
    {
        if ((p.n & n) > 0 && p.isParallel(found) && mag(p.d - most) < tolerance)
        {
            return;
        }
    }
    planes_.append(found);
}


Foam::symmTensor Foam::symmetryPlanes::along() const
{
    symmTensor result(symmTensor::I);
    for (const plane& p : planes_)
    {
        // Of two parallel ones the first
        if ((p.n & result & p.n) > 0.5)
        {
            result -= sqr(p.n);
        }
    }
    return result;
}


Foam::string Foam::symmetryPlanes::fault(const UList<vector>& periods) const
{
    if (fault_.size())
    {
        return fault_;
    }
    for (const plane& p : planes_)
    {
        const word& name = patches_[p.patch].name();
        for (const plane& other : planes_)
        {
            if (!p.isParallel(other) && !p.isPerpendicular(other))
            {
                return "Patches " + name + " and " + patches_[other.patch].name()
                  + " are planes of symmetry that are neither parallel nor"
                    " perpendicular to each other.";
            }
        }
        for (const vector& period : periods)
        {
            if (mag(p.n & period) > roundOff*mag(period))
            {
                OStringStream os;
                os  << "The plane of symmetry " << name << " is not parallel to the"
                    << " period " << period << " of a cyclic patch.";
                return os.str();
            }
        }
    }
    return string();
}


Foam::DynamicList<Foam::imageTransform> Foam::symmetryPlanes::transforms
(
    const UList<vector>& shifts
) const
{
    // Products of reflections in planes that are all perpendicular to each other
    struct product
    {
        imageTransform mirror;
        DynamicList<plane> planes;
    };
    DynamicList<product> products(1, product());
    for (const plane& p : planes_)
    {
        const label n = products.size();
        for (label k = 0; k < n; ++k)
        {
            product next(products[k]);
            bool perpendicular = true;
            for (const plane& other : next.planes)
            {
                perpendicular = perpendicular && p.isPerpendicular(other);
            }
            if (perpendicular)
            {
                next.planes.append(p);
                next.mirror.shift += 2*p.d*p.n;
                next.mirror.reflection -= 2*sqr(p.n);
                ++next.mirror.nMirrors;
                products.append(next);
            }
        }
    }

    DynamicList<imageTransform> result;
    for (label k = 1; k < products.size(); ++k)
    {
        for (const vector& shift : shifts)
        {
            imageTransform t(products[k].mirror);
            t.shift += shift;
            result.append(t);
        }
    }
    return result;
}
