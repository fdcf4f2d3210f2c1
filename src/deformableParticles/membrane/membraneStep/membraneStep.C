/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneFactors.H"
#include "membraneStep.H"

namespace
{

using namespace Foam;

//- c of the resistance to a difference between nodes: along the normals, and in space
constexpr scalar ofNormals = 0.25;
constexpr scalar ofAll = 0.05;

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

vectorField toField(const Eigen::VectorXd& v)
{
    vectorField result(v.size()/3);
    forAll(result, i)
    {
        result[i] = vector(v[3*i], v[3*i + 1], v[3*i + 2]);
    }
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
    tangent_(type.surface(), mechanics_.rings())
{}


void Foam::membraneStep::meet(clumpParcel& p, const pointField& x) const
{
    nodeFlow& flow = p.step().nodes;
    flow.areaVectors = surface().areaVectors(x);
    flow.areas = surface().nodeAreas(x);
}


Foam::Pair<Foam::scalar> Foam::membraneStep::partsOf
(
    const clumpParcel& p,
    const scalar dt,
    const scalar dt0
)
{
    // One that starts from rest has no last step
    const bool starts = max(mag(p.state().u)) == 0;
    const scalar q = dt/dt0;
    const scalar ofLast = starts ? 0 : q/(1 + 2*q);
    return Pair<scalar>(ofLast, 1 - ofLast);
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
        p.step().nodes.layer
    };
}


Foam::vectorField Foam::membraneStep::acceleration
(
    const clumpParcel& p,
    const scalar dt,
    const scalar dt0
)
{
    const vectorField& last = p.state().u;
    const bool starts = max(mag(last)) == 0;
    return (2*scalar(!starts)/(dt + dt0))*(p.step().end.u - last);
}


void Foam::membraneStep::impose
(
    clumpParcel& p,
    const scalar dt,
    const scalar dt0
) const
{
    clumpStep& step = p.step();
    const clumpState& s = p.state();
    vectorField F(s.nodeForces);
    if (step.guessed || F.empty())
    {
        const vectorField dx(dt*step.imposedU);
        const membraneModel::motion start(startOf(p, dt, dt0));
        F =
            mechanics_.forces(s.x + dx, &start)
          + step.forces.f - (step.forces.k & dx);
        contacts_.addForces(step.nodes.contacts, F);
    }
    else if (s.nodeForceRates.size())
    {
        F += dt*s.nodeForceRates;
    }
    step.nodes.force = step.nodes.withoutFlux(F);
    p.fluidForces() = -step.nodes.force;
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
        type.nominalVolume()/type.volume()*excess
       *(g & (x - p.state().centre(type)))*surface().areaVectors(x);
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
        if (atRest)
        {
            const scalar h = max(c.gap, contacts_.resolution());
            result[c.nodes[0]] += atWalls*mu*c.area/h*sqr(c.normal);
        }
    }
    return result;
}


Foam::scalar Foam::membraneStep::addResistance
(
    const problem& step,
    const vectorField& strayed,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    const scalar kn = ofNormals*step.edgeK;
    const scalar k = ofAll*step.edgeK;

    vectorField force(step.K & strayed);
    for (const closedSurface::hinge& h : surface().hinges())
    {
        const label i = max(h.i, h.j);
        const label j = min(h.i, h.j);
        const vector& ni = step.normals[i];
        const vector& nj = step.normals[j];
        const scalar along = kn*((ni & strayed[i]) - (nj & strayed[j]));
        const vector ofEdge(k*(strayed[i] - strayed[j]));
        force[i] += along*ni + ofEdge;
        force[j] -= along*nj + ofEdge;
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
    return 0.5*sum(force & strayed);
}


Foam::scalar Foam::membraneStep::value
(
    const problem& step,
    const vectorField& y,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    const vectorField strayed(y - step.target);
    const vectorField moved(y - step.x);
    const vectorField given(step.F - step.ext.f);
    const vectorField ofTethers(step.ext.k & moved);

    gradient = given + ofTethers;
    return
        addResistance(step, strayed, gradient, tangent)
      + mechanics_.add(y, gradient, tangent, &step.start)
      + contacts_.add(step.contacts, y - step.imposed, gradient, tangent)
      + sum((given + 0.5*ofTethers) & moved);
}


Foam::scalar Foam::membraneStep::linearise
(
    const problem& step,
    const vectorField& y,
    const scalar p,
    const bool exact,
    vectorField& gradient
) const
{
    tangent_.clear(exact);
    const scalar result = value(step, y, gradient, &tangent_);
    if (exact)
    {
        tangent_.addPressure(surface(), y, p);
    }
    return result;
}


bool Foam::membraneStep::solve
(
    const vectorField& left,
    const vectorField& ofVolume,
    membraneFactors& factors,
    Eigen::VectorXd& free
) const
{
    const auto asVector = membraneTangent::asVector;
    free.resize(0);
    return
        tangent_.solve(-asVector(left), factors, free)
     && tangent_.solve(asVector(ofVolume), factors, factors.ofPressure);
}


Foam::scalar Foam::membraneStep::lineSearch
(
    const problem& step,
    const vectorField& dy,
    const scalar merit,
    const scalar slope,
    const scalar penalty,
    vectorField& y
) const
{
    const scalar V0 = mechanics_.type().volume();

    // Near the minimum the difference of two values is round-off
    const bool near = max(mag(dy)) < 1e-6*mechanics_.type().halfWidth();
    for (scalar part = 1; part > 1e-6; part *= 0.5)
    {
        vectorField unused(y.size());
        const vectorField tried(y + part*dy);
        const scalar there =
            value(step, tried, unused)
          + penalty*mag(surface().volume(tried) - V0);
        if (near || there <= merit + 1e-4*part*slope)
        {
            y = tried;
            return part;
        }
    }
    return 0;
}


bool Foam::membraneStep::minimise
(
    const problem& step,
    membraneFactors& factors,
    vectorField& y
) const
{
    constexpr label most = 100;
    constexpr scalar tolerance = 1e-6;
    const clumpType& type = mechanics_.type();
    scalar& p = factors.pressure;
    scalar change = GREAT;

    scalar allowed = tolerance;
    bool maySuffice = true;
    for (label n = 0; n < most && !(maySuffice && change <= allowed); ++n)
    {
        const vectorField ofVolume(surface().areaVectors(y));
        vectorField gradient(y.size());
        const scalar value0 = linearise(step, y, p, true, gradient);

        // What is left with the last pressure: of the whole gradient, even a small
        // error would hide what the volume leaves of it
        const vectorField left(gradient - p*ofVolume);

        // The last factors do, unless the tangent has changed too much
        Eigen::VectorXd free;
        if (!(factors.usable() && solve(left, ofVolume, factors, free)))
        {
            if (!factors.factorise(tangent_))
            {
                linearise(step, y, p, false, gradient);
                if (!factors.factorise(tangent_))
                {
                    break;
                }
            }
            if (!solve(left, ofVolume, factors, free))
            {
                break;
            }
        }

        // With the pressure that brings the volume back
        const scalar excess = surface().volume(y) - type.volume();
        const auto g = membraneTangent::asVector(ofVolume);
        const scalar dp = -(excess + g.dot(free))/g.dot(factors.ofPressure);
        const vectorField dy(toField(free + dp*factors.ofPressure));
        p += dp;

        const scalar penalty = 2*mag(p);
        const scalar part = lineSearch
        (
            step, dy,
            value0 + penalty*mag(excess),
            sum(gradient & dy) - penalty*mag(excess),
            penalty, y
        );
        change = max(mag(dy))/type.halfWidth();
        allowed = max(allowed, 1e-2*part*change);
        const scalar off = mag(surface().volume(y) - type.volume());
        maySuffice = part == 0 || (part == 1 && off <= 1e-10*type.volume());
        if (part == 0)
        {
            break;
        }
    }
    return maySuffice && change <= allowed;
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
    nodeFlow& flow = p.step().nodes;
    const clumpState& s = p.state();
    clumpState& end = p.step().end;

    const membraneModel::motion start(startOf(p, dt, dt0));

    // The viscosity of B, and the inverse of the mean of the inverse viscosities
    const scalar ratio = type.viscosityRatio();
    const scalar resisting = min(scalar(1), 0.5*(1 + ratio))*mu;
    const scalar harmonic = 2*mu*ratio/(1 + ratio);

    const scalarField smeared(flow.smoothing/(2*harmonic*flow.areas));
    const vectorField n(flow.areaVectors/mag(flow.areaVectors));
    const vectorField unsmeared
    (
        flow.u + smeared*(flow.force - n*(n & flow.force))
    );
    const scalar d = surface().edgeLength(s.x);
    const problem step
    {
        n,
        s.x,
        start.from + start.span*unsmeared,
        flow.force,
        resistances(flow, n, smeared, resisting)/start.span,
        8*resisting*d/Foam::sqrt(scalar(3))/start.span,
        p.step().forces,
        start,
        flow.contacts,
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
    std::shared_ptr<membraneFactors>& factors = p.step().factors;
    if (!factors)
    {
        factors = std::make_shared<membraneFactors>(tangent_);
    }
    if (!p.step().guessed)
    {
        factors->forget();
    }
    flow.solved = minimise(step, *factors, y);

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
