/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stressFreeState.H"
#include "checkedEntries.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "surfaceFile.H"
#include <algorithm>
#include <cmath>

namespace
{

using namespace Foam;

//- Points of a meridian
const label nPoints = 20000;

//- V/[4 pi/3 (A/(4 pi))^(3/2)] of an oblate spheroid with the ratio k of its axes
scalar reducedVolumeOf(const scalar k)
{
    const scalar e = Foam::sqrt(1 - sqr(k));
    const scalar area = 0.5*(e > 1e-4 ? 1 + sqr(k)/e*std::atanh(e) : 1 + sqr(k));
    return k/Foam::pow(area, 1.5);
}


//- Areas of the surface of revolution of a polygon (distance from the axis, height)
//  from its beginning to each of its points, over 2 pi
scalarField areasUpTo(const scalarField& r, const scalarField& z)
{
    scalarField result(r.size(), Zero);
    for (label i = 1; i < r.size(); ++i)
    {
        result[i] =
            result[i - 1]
          + 0.5*(r[i] + r[i - 1])*std::hypot(r[i] - r[i - 1], z[i] - z[i - 1]);
    }
    return result;
}

}


Foam::stressFreeState::stressFreeState
(
    const clumpType& type,
    const dictionary& dict
)
:
    type_(type),
    dict_(getDict(dict, "membrane")),
    scale_(getPositiveOrDefault(dict, "scale", 1))
{}


Foam::scalar Foam::stressFreeState::aspectRatio(const scalar reducedVolume)
{
    // It increases from 0 to 1 as the spheroid goes from a disc to a sphere
    scalar low = 0;
    scalar high = 1;
    for (label n = 0; n < 60; ++n)
    {
        const scalar k = 0.5*(low + high);
        (reducedVolumeOf(k) < reducedVolume ? low : high) = k;
    }
    return 0.5*(low + high);
}


bool Foam::stressFreeState::unitNodes(pointField& unit) const
{
    const pointField& x = type_.centres();
    for (label n = 1, nNodes = 42; nNodes <= x.size(); ++n, nNodes = 4*nNodes - 6)
    {
        if (nNodes != x.size())
        {
            continue;
        }
        dictionary dict;
        dict.set("type", "icosphere");
        dict.set("radius", 1);
        dict.set("subdivisions", n);
        const auto sphere(clumpShapes::shape::New(dict));
        if (sphere->triangles() != type_.surface().triangles())
        {
            return false;
        }
        unit = sphere->centres()/mag(sphere->centres());

        // Of revolution: every node keeps its angle around the axis
        scalar off = 0;
        forAll(x, i)
        {
            off = max(off, mag(x[i].x()*unit[i].y() - x[i].y()*unit[i].x()));
        }
        return off < 1e-6*type_.reach();
    }
    return false;
}


Foam::pointField Foam::stressFreeState::directions() const
{
    const closedSurface& surface = type_.surface();
    const pointField& x = type_.centres();
    const vectorField d(x - surface.centroid(x));
    const pointField unit(d/max(mag(d), VSMALL));

    // One to one where no triangle is turned over, and the sphere is covered once
    bool once =
        surface.volume(unit) <= constant::mathematical::pi*4.0/3.0;
    for (const triFace& t : surface.triangles())
    {
        once = once && (unit[t[0]] & (unit[t[1]] ^ unit[t[2]])) > 0;
    }
    if (!once)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'stressFree': from the centroid of the type " << type_.name()
            << " some directions meet its surface more than once, so that its nodes have"
            << " no place on a sphere or spheroid. Give the positions of the nodes by a"
            << " file: type surface." << exit(FatalIOError);
    }
    return unit;
}


Foam::scalarField Foam::stressFreeState::parts(const pointField& unit) const
{
    const pointField& x = type_.centres();
    scalarField r(x.size());
    scalarField z(x.size());
    const labelList order(sortedOrder(scalarField(-unit.component(vector::Z))));
    forAll(order, n)
    {
        const point& p = x[order[n]];
        r[n] = std::hypot(p.x(), p.y());
        z[n] = p.z();
    }
    const scalarField areas(areasUpTo(r, z));
    scalarField result(x.size());
    forAll(order, n)
    {
        result[order[n]] = areas[n]/areas.last();
    }
    return result;
}


Foam::pointField Foam::stressFreeState::spheroid
(
    const scalar reducedVolume,
    const word& kept
) const
{
    const scalar k = aspectRatio(reducedVolume);
    pointField unit;
    pointField result;
    if (unitNodes(unit))
    {
        const scalarField wanted(parts(unit));
        scalarField r(nPoints + 1);
        scalarField z(nPoints + 1);
        forAll(r, n)
        {
            const scalar angle = constant::mathematical::pi*n/nPoints;
            r[n] = n == nPoints ? 0 : Foam::sin(angle);
            z[n] = k*Foam::cos(angle);
        }
        const scalarField areas(areasUpTo(r, z));

        result.setSize(unit.size());
        forAll(result, i)
        {
            const scalar area = wanted[i]*areas.last();
            label n =
                std::upper_bound(areas.begin(), areas.end(), area) - areas.begin();
            n = min(max(n, label(1)), nPoints);
            const scalar width = max(areas[n] - areas[n - 1], VSMALL);
            const scalar part =
                min(max((area - areas[n - 1])/width, scalar(0)), scalar(1));
            const scalar distance = (1 - part)*r[n - 1] + part*r[n];
            const scalar angle = Foam::atan2(unit[i].y(), unit[i].x());
            result[i] = vector
            (
                distance*Foam::cos(angle),
                distance*Foam::sin(angle),
                (1 - part)*z[n - 1] + part*z[n]
            );
        }
    }
    else
    {
        result = cmptMultiply(vector(1, 1, k), directions());
    }
    const closedSurface& surface = type_.surface();
    const pointField& x = type_.centres();
    const scalar factor =
        kept == "volume"
      ? Foam::cbrt(surface.volume(x)/surface.volume(result))
      : Foam::sqrt(surface.area(x)/surface.area(result));
    return factor*result;
}


Foam::pointField Foam::stressFreeState::ofFile(const dictionary& dict) const
{
    const clumpShapes::surfaceFile free(dict);

    // Turned outwards, as those of the shape. Its nodes may have other numbers: the corners
    // of the triangles say which is which
    const closedSurface surface(free.centres(), free.triangles(), dict);
    const List<triFace>& theirs = surface.triangles();
    const List<triFace>& own = type_.surface().triangles();
    labelList places(type_.size(), -1);
    bool same = theirs.size() == own.size() && surface.nNodes() == type_.size();
    for (label n = 0; same && n < own.size(); ++n)
    {
        forAll(own[n], k)
        {
            label& place = places[own[n][k]];
            place = place < 0 ? theirs[n][k] : place;
            same = same && place == theirs[n][k];
        }
    }
    if (!same)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'file': the surface has other triangles than the shape of the type "
            << type_.name() << ", " << theirs.size() << " of " << surface.nNodes()
            << " nodes instead of " << own.size() << " of " << type_.size()
            << ", or in another order. Write it with the triangles of the shape, in their"
            << " order." << exit(FatalIOError);
    }
    return scale_*pointField(free.centres(), places);
}


Foam::pointField Foam::stressFreeState::positions() const
{
    if (!dict_.found("stressFree"))
    {
        return type_.centres();
    }
    const dictionary& dict = getDict(dict_, "stressFree");
    const word form(getEntry<word>(dict, "type"));
    const HashTable<wordList> choices
    ({
        {"shape", {}},
        {"scaled", {"factor"}},
        {"sphere", {"keep"}},
        {"spheroid", {"reducedVolume", "keep"}},
        {"surface", {"file", "scale"}}
    });
    if (!choices.found(form))
    {
        FatalIOErrorInLookup(dict, "type", form, choices) << exit(FatalIOError);
    }
    wordList entries({"type"});
    entries.append(choices[form]);
    checkEntries(dict, entries);

    if (form == "scaled")
    {
        return getBetween(dict, "factor", 0.2, 5)*type_.centres();
    }
    if (form == "surface")
    {
        return ofFile(dict);
    }
    if (form == "shape")
    {
        return type_.centres();
    }
    if (type_.size() > type_.surface().nNodes())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'type' is " << form << ": the shape of the type " << type_.name()
            << " is filled, and the nodes inside have no place in another one. Valid"
            << " here: shape, scaled" << exit(FatalIOError);
    }
    const word kept(dict.getOrDefault<word>("keep", "area"));
    if (kept != "area" && kept != "volume")
    {
        FatalIOErrorInLookup
        (
            dict, "keep", kept, (HashTable<label>({{"area", 0}, {"volume", 1}}))
        )   << exit(FatalIOError);
    }
    return spheroid
    (
        form == "sphere" ? 1 : getBetween(dict, "reducedVolume", 0.1, 1), kept
    );
}
