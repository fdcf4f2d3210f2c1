/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stressFreeState.H"
#include "checkedEntries.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "shape.H"
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
    dict_(dict)
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


Foam::pointField Foam::stressFreeState::unitNodes() const
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
            break;
        }

        // Of revolution: every node keeps its angle around the axis
        scalar off = 0;
        forAll(x, i)
        {
            const vector& u = sphere->centres()[i];
            off = max(off, mag(x[i].x()*u.y() - x[i].y()*u.x()));
        }
        if (off < 1e-6*type_.reach())
        {
            return sphere->centres()/mag(sphere->centres());
        }
    }
    FatalIOErrorInFunction(dict_)
        << "Entry 'stressFree': a sphere or spheroid is known for the shapes icosphere"
        << " and biconcave only; the type " << type_.name() << " has another one, which"
        << " can be free of stress itself: type shape." << exit(FatalIOError);
    return pointField();
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


Foam::pointField Foam::stressFreeState::spheroid(const scalar reducedVolume) const
{
    const pointField unit(unitNodes());
    const scalarField wanted(parts(unit));
    const scalar k = aspectRatio(reducedVolume);

    scalarField r(nPoints + 1);
    scalarField z(nPoints + 1);
    forAll(r, n)
    {
        const scalar angle = constant::mathematical::pi*n/nPoints;
        r[n] = n == nPoints ? 0 : Foam::sin(angle);
        z[n] = k*Foam::cos(angle);
    }
    const scalarField areas(areasUpTo(r, z));

    pointField result(unit.size());
    forAll(result, i)
    {
        const scalar area = wanted[i]*areas.last();
        label n = std::upper_bound(areas.begin(), areas.end(), area) - areas.begin();
        n = min(max(n, label(1)), nPoints);
        const scalar part =
            min
            (
                max((area - areas[n - 1])/max(areas[n] - areas[n - 1], VSMALL), scalar(0)),
                scalar(1)
            );
        const scalar distance = (1 - part)*r[n - 1] + part*r[n];
        const scalar angle = Foam::atan2(unit[i].y(), unit[i].x());
        result[i] = vector
        (
            distance*Foam::cos(angle),
            distance*Foam::sin(angle),
            (1 - part)*z[n - 1] + part*z[n]
        );
    }
    const closedSurface& surface = type_.surface();
    return
        Foam::sqrt(surface.area(type_.centres())/surface.area(result))*result;
}


Foam::pointField Foam::stressFreeState::positions() const
{
    if (!dict_.found("stressFree"))
    {
        return type_.centres();
    }
    const dictionary& dict = getDict(dict_, "stressFree");
    checkEntries(dict, {"type", "reducedVolume"});
    const word form(getEntry<word>(dict, "type"));
    const HashTable<label> choices({{"shape", 0}, {"sphere", 1}, {"spheroid", 2}});
    if (!choices.found(form))
    {
        FatalIOErrorInLookup(dict, "type", form, choices) << exit(FatalIOError);
    }
    if (form != "spheroid" && dict.found("reducedVolume"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'reducedVolume' is that of the type spheroid." << exit(FatalIOError);
    }
    return
        form == "shape" ? type_.centres()
      : spheroid(form == "sphere" ? 1 : getBetween(dict, "reducedVolume", 0.1, 1));
}
