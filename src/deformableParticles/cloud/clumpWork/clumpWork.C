/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpWork.H"
#include "foamCompat.H"
#include "IOmanip.H"
#include "volFields.H"

const Foam::scalar Foam::clumpWork::usualCellsPerSphere = 30;

const Foam::word Foam::clumpWork::fieldName("clumpWork");


Foam::clumpWork::clumpWork
(
    const clumpSuspension& cloud,
    const scalar cellsPerSphere
)
:
    cloud_(cloud),
    mesh_(cloud.mesh()),
    cellsPerSphere_(cellsPerSphere)
{}


Foam::label Foam::clumpWork::nSpheres() const
{
    label n = 0;
    for (const clumpParcel& p : cloud_)
    {
        n += cloud_.type(p).size();
    }
    return n;
}


Foam::scalar Foam::clumpWork::measuredCellsPerSphere() const
{
    const char* const parts[] =
    {
        "solid fraction", "rotation", "force integral", "ghosts", "clumps",
        "gravity", "loads", "contact", "walls"
    };
    scalar clumps = 0;
    for (const char* part : parts)
    {
        clumps += cloud_.timing().seconds(part);
    }
    const scalar flow =
        cloud_.timing().seconds("flow") + cloud_.timing().seconds("convection");

    // Of all processors
    scalarList sums
    ({
        clumps, flow, scalar(nSpheres()), scalar(mesh_.nCells())
    });
    reduceList(sums, plusEqOp<scalar>());
    return
        sums[1] > 0 && sums[2] > 0
      ? (sums[0]/sums[2])/(sums[1]/sums[3]) : 0;
}


Foam::tmp<Foam::volScalarField> Foam::clumpWork::field() const
{
    auto tresult = tmp<volScalarField>::New
    (
        IOobject
        (
            fieldName,
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar("work", dimless, 1)
    );
    scalarField& work = tresult.ref().primitiveFieldRef();
    for (const clumpParcel& p : cloud_)
    {
        work[p.cell()] += cellsPerSphere_*cloud_.type(p).size();
    }
    return tresult;
}


void Foam::clumpWork::print(Ostream& os) const
{
    const scalar cells = mesh_.nCells();
    const List<std::pair<const char*, scalar>> rows
    ({
        {"mesh cells", cells},
        {"clumps", scalar(cloud_.size())},
        {"work", cells + cellsPerSphere_*nSpheres()}
    });

    scalarList least(rows.size()), mean(rows.size()), most(rows.size());
    forAll(rows, i)
    {
        least[i] = mean[i] = most[i] = rows[i].second;
    }
    reduceList(least, minEqOp<scalar>());
    reduceList(mean, plusEqOp<scalar>());
    reduceList(most, maxEqOp<scalar>());

    const int precision = os.precision(6);
    os  << setw(18) << "of a processor" << setw(12) << "minimum" << setw(12)
        << "mean" << setw(12) << "maximum" << setw(16) << "maximum/mean" << nl;
    forAll(rows, i)
    {
        mean[i] /= Pstream::nProcs();
        os  << setw(18) << rows[i].first << setw(12) << least[i] << setw(12)
            << mean[i] << setw(12) << most[i] << setw(16)
            << (mean[i] > 0 ? most[i]/mean[i] : 1) << nl;
    }
    os  << "The work is in mesh cells; a sphere counts as "
        << cellsPerSphere_ << " of them." << nl << endl;
    os.precision(precision);
}
