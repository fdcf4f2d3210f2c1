/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneFactors.H"
#include "membraneStep.H"
#include "unresolvedFlow.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- c of the resistance to a difference between nodes: along the normals, and in space
constexpr scalar normalCoefficient = 0.25;
constexpr scalar edgeCoefficient = 0.05;

//- Largest eigenvalue of L in a hexagonal lattice, over 8 mu d/sqrt(3)
constexpr scalar shortest = 9;

//- Iterations, several times what a step with a solution takes
constexpr label most = 50;

//- w of the resistance at what is at rest
constexpr scalar atWalls = 4;

Eigen::Matrix3d asMatrix(const tensor& t)
{
    Eigen::Matrix3d result;
    result <<
        t.xx(), t.xy(), t.xz(),
        t.yx(), t.yy(), t.yz(),
        t.zx(), t.zy(), t.zz();
    return result;
}

}


Foam::membraneStep::membraneStep
(
    const clumpType& type,
    const dictionary& dict,
    const membraneContacts& contacts
)
:
    mechanics_(type, dict),
    contacts_(contacts),
    minimiser_(type, mechanics_.neighbourOrder(), mechanics_.neighbours())
{}


void Foam::membraneStep::setFlowGeometry(clumpParcel& p, const pointField& x) const
{
    nodeFlow& flow = nodesOf(p);
    flow.areaVectors = surface().areaVectors(x);
    flow.areas = surface().nodeAreas(x);

    // Of nodes inside, those of their resistance
    const clumpType& type = mechanics_.type();
    for (label i = surface().nNodes(); i < x.size(); ++i)
    {
        flow.areas[i] =
            0.75*constant::mathematical::pi*type.halfWidth()*type.dragRadii()[i];
    }
}


Foam::Pair<Foam::scalar> Foam::membraneStep::partsOf
(
    const clumpParcel& p,
    const scalar dt,
    const scalar dt0
)
{
    const scalar q = dt/dt0;
    const scalar lastWeight = starts(p) ? 0 : q/(1 + 2*q);
    return Pair<scalar>(lastWeight, 1 - lastWeight);
}


Foam::membraneModel::motion Foam::membraneStep::startOf
(
    const clumpParcel& p,
    const scalar dt,
    const scalar dt0
) const
{
    const Pair<scalar> parts(partsOf(p, dt, dt0));
    return
    {
        p.state().x + parts.first()*dt*p.state().u,
        parts.second()*dt,
        nodesOf(p).layer
    };
}


Foam::vectorField Foam::membraneStep::acceleration
(
    const clumpParcel& p,
    const scalar dt,
    const scalar dt0
)
{
    return (2*scalar(!starts(p))/(dt + dt0))*(p.step().end.u - p.state().u);
}


void Foam::membraneStep::impose
(
    clumpParcel& p,
    const scalar dt,
    const scalar dt0
) const
{
    const clumpStep& step = p.step();
    nodeFlow& nodes = nodesOf(p);
    const clumpState& s = p.state();
    vectorField F(s.nodeForces);
    if (step.hasGuess || F.empty())
    {
        const vectorField dx(dt*step.imposedU);
        const membraneModel::motion start(startOf(p, dt, dt0));
        F =
            mechanics_.forces(s.x + dx, &start)
          + step.forces.f - (step.forces.k & dx);
        contacts_.addForces(nodes.contacts, F);
        contacts_.addForces(nodes.bonds, F);
    }
    else if (s.nodeForceRates.size())
    {
        F += dt*s.nodeForceRates;
    }
    nodes.force = nodes.withoutFlux(F);
    p.fluidForces() = -nodes.force;
}


Foam::vectorField Foam::membraneStep::weight
(
    const clumpParcel& p,
    const scalar rho,
    const vector& g
) const
{
    const clumpType& type = mechanics_.type();
    const pointField& x = p.state().x;
    const scalar excess = type.mass()/type.volume() - rho;
    return
        type.nominalRatio()*excess
       *(g & (x - p.state().centre(type)))*surface().areaVectors(x);
}


Foam::vectorField Foam::membraneStep::unsmeared
(
    const clumpParcel& p,
    const vectorField& n,
    const scalarField& smeared,
    const scalar dt,
    const scalar mu
) const
{
    const nodeFlow& flow = nodesOf(p);
    const vectorField& F = flow.force;
    vectorField u(flow.u + smeared*(F - n*(n & F)));
    if (flow.unresolved > 0)
    {
        const unresolvedFlow addition(flow.unresolved);
        const pointField x(p.state().x + dt*p.step().imposedU);
        u += flow.withoutFlux(addition(x, F, n, flow.areas, surface().nNodes())/mu);
    }
    return u;
}


Foam::symmTensorField Foam::membraneStep::resistances
(
    const nodeFlow& flow,
    const vectorField& n,
    const scalarField& smeared,
    const scalar mu
) const
{
    const scalarField zeta(8*mu*flow.areas/mechanics_.type().halfWidth());
    const scalarField along(1/(1/zeta + smeared));
    symmTensorField result(along*symmTensor(I) + (zeta - along)*sqr(n));
    for (const nodeContact& c : flow.contacts)
    {
        const bool atRest = c.moves < 2;
        if (atRest && contacts_.repels(c))
        {
            const scalar h = max(c.gap, contacts_.resolution());
            result[c.nodes[0]] += atWalls*mu*c.area/h*sqr(c.normal);
        }
    }
    return result;
}


Foam::scalarField Foam::membraneStep::edgeResistances
(
    const nodeFlow& flow,
    const scalarField& smeared,
    const scalar mu,
    const scalar d
) const
{
    const scalarField zeta(8*mu*flow.areas/mechanics_.type().halfWidth());
    const scalar edge = edgeCoefficient*8*mu*d/Foam::sqrt(scalar(3));

    // (1/zeta + S)^-1 and L do not exceed 1/S together
    return edge/max(scalar(1), smeared*shortest*edge*(1 + smeared*zeta));
}


Foam::scalar Foam::membraneStep::addResistance
(
    const problem& step,
    const vectorField& deviation,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    const scalar kn = normalCoefficient*step.edgeK;

    vectorField force(step.K & deviation);
    for (const closedSurface::hinge& h : surface().hinges())
    {
        const label i = max(h.i, h.j);
        const label j = min(h.i, h.j);
        const vector& ni = step.normals[i];
        const vector& nj = step.normals[j];
        const scalar along = kn*((ni & deviation[i]) - (nj & deviation[j]));
        const scalar k = 0.5*(step.allK[i] + step.allK[j]);
        const vector edgeForce(k*(deviation[i] - deviation[j]));
        force[i] += along*ni + edgeForce;
        force[j] -= along*nj + edgeForce;
        if (tangent)
        {
            tangent->add(i, i, asMatrix(kn*(ni*ni) + k*tensor::I));
            tangent->add(j, j, asMatrix(kn*(nj*nj) + k*tensor::I));
            tangent->add(i, j, asMatrix(-kn*(ni*nj) - k*tensor::I));
        }
    }
    if (tangent)
    {
        forAll(step.K, i)
        {
            tangent->add(i, i, asMatrix(tensor(step.K[i] + step.ext.k[i])));
        }
    }
    gradient += force;
    return 0.5*sum(force & deviation);
}


Foam::scalar Foam::membraneStep::value
(
    const problem& step,
    const vectorField& y,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    const vectorField deviation(y - step.target);
    const vectorField moved(y - step.x);
    const vectorField given(step.F - step.ext.f);
    const vectorField tetherForces(step.ext.k & moved);

    gradient = given + tetherForces;
    return
        addResistance(step, deviation, gradient, tangent)
      + mechanics_.add(y, gradient, tangent, &step.start)
      + contacts_.add(step.contacts, y - step.imposed, gradient, tangent)
      + contacts_.add(step.bonds, y - step.imposed, gradient, tangent)
      + sum((given + 0.5*tetherForces) & moved);
}


void Foam::membraneStep::advance
(
    clumpParcel& p,
    const scalar mu,
    const scalar dt,
    const scalar dt0
) const
{
    const clumpType& type = mechanics_.type();
    nodeFlow& flow = nodesOf(p);
    const clumpState& s = p.state();
    clumpState& end = p.step().end;

    const membraneModel::motion start(startOf(p, dt, dt0));

    // The viscosity of B, and the inverse of the mean of the inverse viscosities
    const scalar ratio = type.viscosityRatio();
    const scalar resisting = min(scalar(1), 0.5*(1 + ratio))*mu;
    const scalar harmonic = 2*mu*ratio/(1 + ratio);

    const scalarField smeared(flow.smoothing/(2*harmonic*flow.areas));
    const vectorField n(flow.normals());
    const scalar d = surface().edgeLength(s.x);
    const problem step
    {
        n,
        s.x,
        start.from
      + start.duration*unsmeared(p, n, smeared, dt, 0.5*(1 + ratio)*mu),
        flow.force,
        resistances(flow, n, smeared, resisting)/start.duration,
        8*resisting*d/Foam::sqrt(scalar(3))/start.duration,
        edgeResistances(flow, smeared, resisting, d)/start.duration,
        p.step().forces,
        start,
        flow.contacts,
        flow.bonds,
        s.x + dt*p.step().imposedU
    };

    // From the end of the last outer corrector, or as in the last step, unless the start
    // of the step is better
    vectorField y(step.imposed);
    vectorField unused(y.size());
    if (!(value(step, y, unused) < value(step, s.x, unused)))
    {
        y = s.x;
    }
    autoPtr<membraneFactors>& factors = flow.factors;
    if (!factors.valid())
    {
        factors.reset(new membraneFactors(minimiser_.tangent()));
    }
    if (!p.step().hasGuess)
    {
        factors->forget();
    }
    const auto potential = [&]
    (
        const vectorField& x, vectorField& gradient, membraneTangent* tangent
    )
    {
        return value(step, x, gradient, tangent);
    };
    p.step().solved = minimiser_.minimise(potential, *factors, y, 1e-2, most);

    vectorField F(flow.force);
    addResistance(step, y - step.target, F, nullptr);

    end = s;
    end.x = y;
    end.u = (y - s.x)/dt;
    end.nodeForces = flow.withoutFlux(F);
    if (s.nodeForces.size())
    {
        end.nodeForceRates = (end.nodeForces - s.nodeForces)/dt;
    }
}
