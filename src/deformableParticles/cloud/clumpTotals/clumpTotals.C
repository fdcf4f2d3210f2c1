/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpTotals.H"

bool Foam::someFixed(const clumpSuspension& clumps)
{
    bool result = false;
    for (const clumpParcel& p : clumps)
    {
        result = result || clumps.type(p).fixed();
    }
    return returnReduce(result, orOp<bool>());
}


Foam::vector Foam::meanVelocity(const clumpSuspension& clumps)
{
    vector momentum(Zero);
    scalar mass = 0;
    for (const clumpParcel& p : clumps)
    {
        momentum += clumps.type(p).mass()*p.state().velocity(clumps.type(p));
        mass += clumps.type(p).mass();
    }
    reduce(momentum, sumOp<vector>());
    reduce(mass, sumOp<scalar>());
    return momentum/max(mass, VSMALL);
}


Foam::vector Foam::excessMomentum(const clumpSuspension& clumps)
{
    const scalar dt = clumps.mesh().time().deltaTValue();
    vector result(Zero);
    for (const clumpParcel& p : clumps)
    {
        const clumpType& ct = clumps.type(p);
        const clumpState& s = p.state();
        if (!ct.ofSpheres())
        {
            continue;
        }
        result +=
            p.step().fadeFactor
           *sum
            (
                ct.masses()*s.u - clumps.fluidDensity()*ct.volumes()*(s.u - dt*s.a)
            );
    }
    return result;
}


Foam::scalar Foam::excessMass(const clumpSuspension& clumps)
{
    scalar result = 0;
    for (const clumpParcel& p : clumps)
    {
        if (!clumps.type(p).ofSpheres())
        {
            continue;
        }
        result += clumps.type(p).mass() - clumps.fluidDensity()*sum(clumps.type(p).volumes());
    }
    return result;
}


Foam::scalar Foam::maxSpeed(const clumpSuspension& clumps)
{
    scalar result = 0;
    for (const clumpParcel& p : clumps)
    {
        result = max(result, max(mag(p.state().u)));
    }
    return returnReduce(result, maxOp<scalar>());
}


Foam::scalar Foam::largestDiameter(const clumpSuspension& clumps)
{
    scalar result = 0;
    for (const clumpType& ct : clumps.types())
    {
        result = max(result, 2*ct.reach());
    }
    return result;
}


Foam::Pair<Foam::scalar> Foam::volumeFractions
(
    const PtrList<clumpType>& types,
    const labelUList& numbers,
    const scalar volume
)
{
    Pair<scalar> result(0, 0);
    forAll(types, i)
    {
        if (!types[i].fixed())
        {
            result.first() += numbers[i]*types[i].nominalVolume()/volume;
            result.second() += numbers[i]*types[i].volume()/volume;
        }
    }
    return result;
}


Foam::scalar Foam::maxSpeedOverRadius(const clumpSuspension& clumps)
{
    scalar result = 0;
    for (const clumpParcel& p : clumps)
    {
        const vectorField u(p.state().u - clumps.meshVelocity());
        result = max(result, max(mag(u)/clumps.type(p).bodyRadii()));
    }
    return returnReduce(result, maxOp<scalar>());
}


Foam::label Foam::mostSpheres(const clumpSuspension& clumps)
{
    label result = 0;
    for (const clumpType& type : clumps.types())
    {
        result = max(result, type.size());
    }
    return result;
}


Foam::scalar Foam::cellsPerDiameter(const clumpSuspension& clumps)
{
    scalar result = GREAT;
    for (const clumpParcel& p : clumps)
    {
        result = min
        (
            result, 2*clumps.type(p).halfWidth()/cbrt(clumps.mesh().V()[p.cell()])
        );
    }
    return returnReduce(result, minOp<scalar>());
}
