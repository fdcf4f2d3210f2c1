/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "squeezeFilm.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace gapModels
{
    defineTypeNameAndDebug(squeezeFilm, 0);
    addToRunTimeSelectionTable(gapModel, squeezeFilm, dictionary);
}
}


namespace
{

using namespace Foam;

//- c, its integral C and the integral of C over the gap, each over 3 mu R, of the pressure
struct integrals
{
    scalar c, C, sum;

    integrals(const scalar gap, const gapModel::layer& between)
    {
        const scalar limit = between.limit;
        const scalar g = min(max(gap, min(between.roughness, limit)), limit);
        const scalar beyond = gap - g;
        c = gap < limit ? 1/sqr(g) - 1/sqr(limit) : 0;
        const scalar atG = -1/g - g/sqr(limit);
        C = atG + c*beyond;
        sum =
            -Foam::log(g/limit) - 0.5*sqr(g/limit) + (atG + 0.5*c*beyond)*beyond;
    }
};

}


Foam::gapModels::squeezeFilm::squeezeFilm(const dictionary& dict)
:
    roughness_(dict.found("roughness") ? getPositive(dict, "roughness") : 0)
{
    checkEntries(withoutRemoved(dict, {"cutOff"}), {"type", "roughness"});
}


Foam::string Foam::gapModels::squeezeFilm::idleReason
(
    const scalar cellWidth
) const
{
    const scalar limit = range(cellWidth, true);
    if (roughness_ < limit)
    {
        return "";
    }
    OStringStream os;
    os  << "Entry 'roughness' is " << roughness_ << " m, but the film acts below the"
        << " gap " << limit << " m (" << wallLimit << " widths of the mesh cells) and"
        << " above the roughness only. Reduce the roughness; tens of nanometres are"
        << " usual.";
    return os.str();
}


Foam::scalar Foam::gapModels::squeezeFilm::resistance
(
    const scalar gap,
    const radii& R,
    const medium& between
) const
{
    const scalar limit = range(between.cellWidth, between.atWall);
    const scalar g = min(max(gap, roughness(R)), limit);
    return factor(R, between)*(1 - Foam::sqrt(g/limit))/g;
}


Foam::scalar Foam::gapModels::squeezeFilm::roughness(const radii& R) const
{
    return roughness_ > 0 ? roughness_ : 0.02*Foam::sqrt(R.first*R.second);
}


Foam::scalar Foam::gapModels::squeezeFilm::factor
(
    const radii& R,
    const medium& between
)
{
    const scalar product = R.first*R.second;
    return
        12*constant::mathematical::pi*between.viscosity
       *product*Foam::sqrt(product)/(R.first + R.second);
}


Foam::contactModel::increment Foam::gapModels::squeezeFilm::step
(
    const scalar gap,
    const scalar start,
    const scalar dt,
    const radii& R,
    const medium& between
) const
{
    const scalar limit = range(between.cellWidth, between.atWall);
    const scalar rough = min(roughness(R), limit);
    const scalar K = factor(R, between);

    // Integrals of c and of (C - C(start)), piece by piece from start to gap
    scalar C = 0, W = 0, from = start;
    const auto addPiece = [&](const scalar to)
    {
        const scalar d = to - from;
        const scalar middle = 0.5*(from + to);
        W += C*d;
        if (middle < rough)
        {
            const scalar c = resistance(rough, R, between);
            C += c*d;
            W += 0.5*c*sqr(d);
        }
        else if (middle < limit)
        {
            const scalar s = d/from;
            const scalar log = std::log1p(s);
            const scalar a = Foam::sqrt(from/limit), b = Foam::sqrt(to/limit);
            const scalar ba = d/limit/(b + a);      // b - a
            C += K*(log - 2*ba);
            W += K*(from*((1 + s)*log - s) - 2*limit*sqr(ba)*(2*b + a)/3);
        }
        from = to;
    };
    const bool opens = gap > start;
    for (const scalar bound : {opens ? rough : limit, opens ? limit : rough})
    {
        if (min(start, gap) < bound && bound < max(start, gap))
        {
            addPiece(bound);
        }
    }
    addPiece(gap);

    return {W/dt, -C/dt, resistance(gap, R, between)/dt};
}


Foam::contactModel::pressure Foam::gapModels::squeezeFilm::surfacePressure
(
    const scalar gap,
    const scalar start,
    const scalar dt,
    const scalar R,
    const layer& between
) const
{
    if (min(gap, start) >= between.limit)
    {
        return {0, 0, 0};
    }
    const integrals from(start, between);
    const integrals to(gap, between);
    const scalar K = 3*between.viscosity*R/dt;
    return
    {
        K*(to.sum - from.sum - from.C*(gap - start)), -K*(to.C - from.C), K*to.c
    };
}
