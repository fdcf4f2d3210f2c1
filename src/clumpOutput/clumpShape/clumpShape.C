/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpShape.H"
#include "clumpTotals.H"
#include "deformableCloud.H"
#include "sphereUnion.H"
#include "symmTensorField.H"
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

//- Principal axes of second moments as rows, longest first
tensor principalAxes(const symmTensor& M)
{
    Eigen::Matrix3d moments;
    moments <<
        M.xx(), M.xy(), M.xz(),
        M.xy(), M.yy(), M.yz(),
        M.xz(), M.yz(), M.zz();
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
          : mostSpheres(deformableCloud::find(mesh_, dict)) - 1;
        marked_ = getNumber(dict, "marked", 0, last);
    }
    return clumpTable::read(dict);
}


Foam::functionObjects::tableHeader
Foam::functionObjects::clumpShape::header() const
{
    // NOTE: a new column has its name and unit here, its meaning in explain, and its value at the
    // same place in row
    return
        tableHeader("Shape of each clump")
       .addVector("L", "m").add("L1", "m").add("L2", "m").add("L3", "m")
       .addVector("axis").addVector("omega", "rad/s")
       .add("TaylorDeformation").add("inclination", "rad").add("phase", "rad")
       .add("area", "m2").add("volume", "m3")
       .explain("Lx Ly Lz L1 L2 L3", "extents along the coordinate axes, and along the"
            " principal axes, the one with the largest second moment first; L1, L2 and L3 of"
            " a membrane are the axes of the ellipsoid with the second moments of its inside")
       .explain("axisx axisy axisz omegax omegay omegaz", "longest principal axis, and"
            " angular velocity")
       .explain("TaylorDeformation inclination", "|L1 - L2|/(L1 + L2), and angle of the"
            " longest axis to the flow; of a membrane those of its section by the plane"
            " of flow and gradient")
       .explain("phase", "angle of the marked sphere to the flow, seen from the centre")
       .explain("area volume", "of the polygon of the sphere centres, and of the union of"
            " the spheres; of a membrane those of its surface");
}


Foam::string Foam::functionObjects::clumpShape::row
(
    const clumpParcel& p,
    const clumpType& type
) const
{
    if (type.hasTriangles())
    {
        return membraneRow(p, type);
    }
    const clumpState& s = p.state();
    const point centre(s.centre(type));
    const tensor axes(principalAxes(sum(sqr(s.x - centre))));
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


Foam::string Foam::functionObjects::clumpShape::membraneRow
(
    const clumpParcel& p,
    const clumpType& type
) const
{
    const clumpState& s = p.state();
    const scalar V = type.surface().volume(s.x);

    // An ellipsoid has the moments V a^2/5
    const symmTensor squares(5/V*type.surface().secondMoments(s.x));
    const tensor R(principalAxes(squares));
    const auto length = [&squares](const vector& e)
    {
        return 2*Foam::sqrt(e & (squares & e));
    };
    const vector lengths(length(R.x()), length(R.y()), length(R.z()));

    // Of the section by the plane of flow and gradient
    const vector& ex = flow();
    const vector& ey = gradient();
    const scalar xx = ex & (squares & ex);
    const scalar xy = ex & (squares & ey);
    const scalar yy = ey & (squares & ey);
    const scalar apart = Foam::sqrt(sqr(0.5*(xx - yy)) + sqr(xy));
    const scalar L = Foam::sqrt(0.5*(xx + yy) + apart);
    const scalar B = Foam::sqrt(0.5*(xx + yy) - apart);

    const label marked = min(marked_, type.size() - 1);
    return
        columns
        (
            {
                extents(s.x, scalarField(s.x.size(), Zero), tensor::I),
                lengths,
                R.x(),
                s.angularVelocity(type)
            }
        )
      + columns
        (
            {
                (L - B)/(L + B),
                apart > 0 ? 0.5*Foam::atan2(2*xy, xx - yy) : 0,
                angle(s.x[marked] - s.centre(type)),
                type.surface().area(s.x),
                V
            }
        );
}
