/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpShape.H"
#include "deformableCloud.H"
#include "sphereUnion.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
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


scalar polygonArea(const pointField& x)
{
    vector sum(Zero);
    forAll(x, i)
    {
        sum += (x[i] - x[0]) ^ (x[x.fcIndex(i)] - x[0]);
    }
    return 0.5*mag(sum);
}

}


Foam::functionObjects::clumpShape::clumpShape
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    clumpTable(name, runTime, dict, typeName, {"marked"}),
    marked_(0)
{
    read(dict);
}


bool Foam::functionObjects::clumpShape::read(const dictionary& dict)
{
    marked_ = 0;
    if (dict.found("marked"))
    {
        const label last =
            functionObject::postProcess
          ? labelMax
          : deformableCloud::find(mesh_, dict).mostSpheres() - 1;
        marked_ = getNumber(dict, "marked", 0, last);
    }
    return clumpTable::read(dict);
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpShape::header() const
{
    return
        tableHeader("Shape of each clump")
       .addVector("L", "m").add("L1", "m").add("L2", "m").add("L3", "m")
       .addVector("axis").addVector("omega", "rad/s")
       .add("TaylorDeformation").add("inclination", "rad").add("phase", "rad")
       .add("area", "m2").add("volume", "m3")
       .explain("Lx Ly Lz L1 L2 L3", "extents along the coordinate axes, and along the"
            " principal axes, longest first")
       .explain("axisx axisy axisz omegax omegay omegaz", "longest principal axis, and"
            " angular velocity")
       .explain("TaylorDeformation inclination", "|L1 - L2|/(L1 + L2), and angle of the"
            " longest axis to the flow")
       .explain("phase", "angle of the marked sphere to the flow, seen from the centre")
       .explain("area volume", "of the polygon of the sphere centres, and of the union of"
            " the spheres");
}


Foam::string Foam::functionObjects::clumpShape::row
(
    const clumpParcel& p,
    const clumpType& type
) const
{
    const clumpState& s = p.state();
    const point centre(s.centre(type));
    const tensor axes(principalAxes(s.x, centre));
    const vector lengths(extents(s.x, type.radii(), axes));

    // The longest axis has no sign
    scalar inclination = angle(axes.x());
    if (mag(inclination) > constant::mathematical::piByTwo)
    {
        inclination -= sign(inclination)*constant::mathematical::pi;
    }
    const label marked = min(marked_, type.size() - 1);

    return
        columns
        (
            {
                extents(s.x, type.radii(), tensor::I),
                lengths,
                axes.x(),
                s.angularVelocity(type)
            }
        )
      + columns
        (
            {
                mag(lengths.x() - lengths.y())/(lengths.x() + lengths.y()),
                inclination,
                angle(s.x[marked] - centre),
                polygonArea(s.x),
                sphereUnion::volume(s.x, type.radii(), 100)
            }
        );
}
