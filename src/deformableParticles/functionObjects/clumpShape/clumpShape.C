/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpShape.H"
#include "addToRunTimeSelectionTable.H"
#include <Eigen/Dense>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clumpShape, 0);
    addToRunTimeSelectionTable(functionObject, clumpShape, dictionary);
}
}

namespace
{

using namespace Foam;

//- Principal axes of the sphere centres as rows, longest first
tensor principalAxes(const pointField& x, const point& centre)
{
    Eigen::Matrix3d moments(Eigen::Matrix3d::Zero());
    for (const point& p : x)
    {
        const Eigen::Vector3d r
        (
            p.x() - centre.x(), p.y() - centre.y(), p.z() - centre.z()
        );
        moments += r*r.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver
    (
        moments/max(moments.trace(), VSMALL)
    );
    const Eigen::Matrix3d& v = solver.eigenvectors();

    return tensor
    (
        v(0, 2), v(1, 2), v(2, 2),
        v(0, 1), v(1, 1), v(2, 1),
        v(0, 0), v(1, 0), v(2, 0)
    );
}


vector extents(const pointField& x, const scalarField& r, const tensor& axes)
{
    vector low(vector::uniform(GREAT)), high(vector::uniform(-GREAT));
    forAll(x, i)
    {
        const vector p(axes & x[i]);
        low = min(low, p - r[i]*vector::one);
        high = max(high, p + r[i]*vector::one);
    }
    return high - low;
}

}


Foam::functionObjects::clumpShape::clumpShape
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    clumpTable(name, runTime, dict, typeName)
{
    start(dict);
}


void Foam::functionObjects::clumpShape::writeHeader(Ostream& os) const
{
    os  << "# Shape of every clump" << nl
        << "# time [s]\tclump\ttype\tLx Ly Lz [m]\tL1 L2 L3 [m]"
        << "\taxis1x axis1y axis1z\tomegax omegay omegaz [rad/s]" << endl;
}


Foam::string Foam::functionObjects::clumpShape::row
(
    const clumpParcel& p,
    const clumpType& type
) const
{
    const clumpState& s = p.state();
    const tensor axes(principalAxes(s.x, s.centre(type)));

    return columns
    (
        {
            extents(s.x, type.radii(), tensor::I),
            extents(s.x, type.radii(), axes),
            axes.x(),
            s.angularVelocity(type)
        }
    );
}
