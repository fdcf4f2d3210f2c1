/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpStart.H"
#include "clumpFields.H"
#include "clumpSource.H"
#include "clumpSuspension.H"
#include "clumpTotals.H"
#include "foamCompat.H"
#include "IOdictionary.H"

bool Foam::clumpStart::begin
(
    clumpSuspension& cloud,
    const clumpSource& source,
    clumpCount& count
)
{
    const bool restarts = returnReduce(cloud.size(), sumOp<label>()) > 0;
    if (restarts)
    {
        count.check(cloud.size(), Foam::cloud::prefix/cloud.name());
        restart(cloud);
    }
    else if (count.emptied())
    {
        Info<< "No clumps at time " << cloud.pMesh().time().timeName() << ": "
            << (count.left() ? "all have left the domain" : "none were placed")
            << ". The entry placement is not used; setClumps places clumps at this"
            << " time" << endl;
    }
    else
    {
        place(cloud, source, count);
    }
    count.start(cloud.size());
    reportFractions(cloud);
    return restarts;
}


void Foam::clumpStart::restart(clumpSuspension& cloud)
{
    const Time& time = cloud.pMesh().time();
    const dictionary& dict = cloud.properties();
    writtenTypes written(cloud.name(), time, cloud.types(), dict);
    written.addPieces
    (
        [&](const label whole, const labelList& spheres)
        {
            return cloud.pieceType(whole, spheres);
        }
    );
    clumpFields::read(cloud, cloud.types(), written);
    Info<< "Read " << returnReduce(cloud.size(), sumOp<label>())
        << " clumps from time " << time.timeName()
        << (dict.found("placement") ? "; the entry placement is not used" : "")
        << endl;

    // Written by setClumps, not by a run: at rest unless they were given a velocity
    const IOdictionary ofRun
    (
        IOobject
        (
            "time", time.timeName(), "uniform", time,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    starts_ = ofRun.empty();
    if (starts_)
    {
        for (const clumpParcel& p : cloud)
        {
            if (max(mag(p.state().u)) == 0)
            {
                followFlow_.insert(p.origId());
            }
        }
    }
}


void Foam::clumpStart::place
(
    clumpSuspension& cloud,
    const clumpSource& source,
    const clumpCount& count
)
{
    starts_ = true;
    clumpFields::refuseRemains(cloud);
    count.check(cloud.size(), Foam::cloud::prefix/cloud.name());
    const dictionary& properties = cloud.properties();
    if (!properties.found("placement") && properties.found("injection"))
    {
        return;
    }

    source.place(cloud, followFlow_);
    Info<< "Placed " << returnReduce(cloud.size(), sumOp<label>()) << " clumps" << endl;
}


void Foam::clumpStart::reportFractions(const clumpSuspension& cloud)
{
    const fvMesh& mesh = cloud.mesh();
    const PtrList<clumpType>& types = cloud.types();
    labelList numbers(types.size(), 0);
    for (const clumpParcel& p : cloud)
    {
        ++numbers[p.typeId()];
    }
    reduceList(numbers, plusEqOp<label>());
    if (!sum(numbers))
    {
        return;
    }

    const scalar volume = gSum(mesh.V());
    const Pair<scalar> fractions(volumeFractions(types, numbers, volume));
    bool someFixed = false;
    forAll(types, i)
    {
        someFixed = someFixed || types[i].fixed();
        labelList own(types.size(), 0);
        own[i] = numbers[i];
        const scalar haematocrit = volumeFractions(types, own, volume).first();
        Info<< "    " << types[i].name() << ": " << numbers[i]
            << " clumps, haematocrit " << Foam::name(haematocrit).c_str() << nl;
    }
    Info<< "Haematocrit " << Foam::name(fractions.first()).c_str()
        << ", volume fraction of the clumps " << (someFixed ? "that move " : "")
        << Foam::name(fractions.second()).c_str() << endl;
}
