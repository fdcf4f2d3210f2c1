/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "impactStep.H"
#include "mathematicalConstants.H"
#include "rigidResponse.H"
#include "vector2D.H"

namespace
{

using namespace Foam;

//- Parts of a step per duration of a contact. An elastic collision loses less than 0.1 %
//  of the energy to the method with 16
constexpr scalar partsPerContact = 16;

//- Steps that are longer than so many durations are not divided
constexpr scalar longest = 10;

//- Stokes number below which nothing bounces
constexpr scalar leastStokes = 10;

//- Share below which a contact is left to its neighbours
constexpr scalar leastWeight = 1e-6;


//- Time in which a gap closes at this speed and acceleration
scalar closing(const scalar gap, const scalar v, const scalar a)
{
    const scalar square = sqr(v) + 2*a*gap;
    const scalar sum = v + Foam::sqrt(max(square, scalar(0)));
    return square < 0 || sum <= 0 ? GREAT : 2*gap/sum;
}

}


Foam::scalar Foam::impactStep::wholeMass(const sphereContact& t) const
{
    const clumpType& own = type(t.a);
    if (t.b < 0)
    {
        return own.mass();
    }
    const clumpType& other = types_[ghosts_.images()[t.b].typeId];
    return
        other.fixed() ? own.mass()
      : own.fixed() ? other.mass()
      : contactModel::reduced(own.mass(), other.mass());
}


bool Foam::impactStep::stokesAllows(const sphereContact& t, const scalar u) const
{
    const auto radius = [](const clumpType& ct)
    {
        return Foam::cbrt(0.75*ct.volume()/constant::mathematical::pi);
    };
    scalar R = radius(type(t.a));
    if (t.b >= 0)
    {
        R = contactModel::reduced
        (
            R, radius(types_[ghosts_.images()[t.b].typeId])
        );
    }
    return
        wholeMass(t)*u
      > leastStokes*6*constant::mathematical::pi*gaps_.viscosity()*sqr(R);
}


bool Foam::impactStep::hasEnergy
(
    const sphereContact& t,
    const scalar v,
    const scalar overlap
) const
{
    const scalar square = sqr(v) + 2*elastic(t, overlap)/wholeMass(t);
    return square > 0 && stokesAllows(t, Foam::sqrt(square));
}


Foam::scalar Foam::impactStep::elastic(const sphereContact& t, const scalar overlap)
{
    if (!t.hasLaw || overlap <= 0 || t.weight < leastWeight)
    {
        return 0;
    }
    // Slow enough for the damping to vanish
    const scalar depth = t.ratio*overlap;
    return t.weight/t.ratio*t.law->step(depth, depth, GREAT, t.R, t.m).energy;
}


Foam::scalar Foam::impactStep::acrossGap(const sphereContact& t) const
{
    if (!t.reaches || t.d <= -t.range)
    {
        return 0;
    }
    // The force stays as it is while the bodies overlap, see evaluate
    const scalar gap = max(-t.d, scalar(0));
    const auto w(gaps_.potential(gap, t.gapR, placeOf(t)));
    return t.gapWeight*(w.energy + w.force*(gap + t.d));
}


Foam::scalar Foam::impactStep::duration(const sphereContact& t, const scalar energy)
{
    // Newton's method for the largest overlap, of logarithms: the energy is nearly a
    // power of it
    scalar d = 0.01*t.R;
    for (label n = 0; n < 20; ++n)
    {
        const scalar depth = t.ratio*d;
        const auto w = t.law->step(depth, depth, GREAT, t.R, t.m);
        const scalar V = t.weight/t.ratio*w.energy;
        const scalar slope = t.weight*w.force*d;
        if (V <= 0 || slope <= 0)
        {
            return GREAT;
        }
        const scalar change = V/slope*Foam::log(energy/V);
        d *= Foam::exp(min(max(change, scalar(-5)), scalar(5)));
        if (mag(change) < 1e-3)
        {
            break;
        }
    }
    return 3*d/Foam::sqrt(2*energy/t.m);
}


Foam::scalar Foam::impactStep::approach
(
    const sphereContact& t,
    const List<vectorField>& u,
    const label i,
    const label j
) const
{
    const vector& own = u[t.a][i];
    return
        -t.n & (t.b < 0 ? own : vector(own - ofImage(t, u[t.otherIndex][j])));
}


void Foam::impactStep::setMasses
(
    UList<sphereContact>& contacts,
    const List<vectorField>& u,
    const scalar interval
) const
{
    bool bounces = false;
    DynamicList<label> acting;
    forAll(contacts, k)
    {
        sphereContact& t = contacts[k];
        if (t.hasLaw)
        {
            evaluate(t);
            const scalar v = approach(t, u, t.i, t.j);
            bounces = bounces || hasEnergy(t, v, t.d);
            if (t.weight > leastWeight && t.d + max(v, scalar(0))*interval > 0)
            {
                acting.append(k);
            }
        }
    }
    if (!bounces)
    {
        return;
    }

    const sphereContact& any = contacts[0];
    const pointField xA(clumps_[any.a].centres() + moved_[any.a]);
    const rigidResponse a(type(any.a), xA);
    pointField xB;
    autoPtr<rigidResponse> b;
    if (any.b >= 0)
    {
        const clumpImage& B = ghosts_.images()[any.b];
        xB = places(any.b, any.otherIndex);
        b.reset(new rigidResponse(types_[B.typeId], xB));
    }
    const auto response = [&](const sphereContact& s, const sphereContact& t)
    {
        return
            a(xA[s.i], s.n, xA[t.i], t.n)
          + (b.valid() ? (*b)(xB[s.j], s.n, xB[t.j], t.n) : 0);
    };
    for (sphereContact& t : contacts)
    {
        t.m = t.hasLaw ? 1/response(t, t) : t.m;
    }
    for (const label k : acting)
    {
        // Bodies that are squeezed between others have a negative sum
        sphereContact& t = contacts[k];
        scalar othersResponse = 0;
        for (const label l : acting)
        {
            const sphereContact& s = contacts[l];
            othersResponse += l == k ? 0 : s.weight*s.ratio*response(t, s);
        }
        const scalar own = acting.size() > 1 ? t.weight*t.ratio : 1;
        t.m = 1/(own/t.m + max(othersResponse, scalar(0)));
    }
}


bool Foam::impactStep::mayBounce() const
{
    for (const sphereContact& t : sphereContacts_)
    {
        if (!t.hasLaw)
        {
            continue;
        }
        vector v(clumps_[t.a].state().u[t.i]);
        if (t.b >= 0)
        {
            v -= ghosts_.images()[t.b].u[t.j];
        }
        if (hasEnergy(t, mag(v), t.first))
        {
            return true;
        }
    }
    return false;
}


void Foam::impactStep::endSearch()
{
    contactStep::endSearch();
    // A wall that moves is where it ends the step, in none of its parts
    bounces_ = !wallsMove() && returnReduce(mayBounce(), orOp<bool>());
    if (!bounces_)
    {
        return;
    }
    scalar unresolved = GREAT;
    bounces_ = toNext(wholeDt_, unresolved).x() < GREAT;
    if (bounces_)
    {
        // An explicit integrator needs the masses, too
        search_.contacts = sphereContacts_;
    }
    else
    {
        sphereContacts_ = search_.contacts;
    }
    reduce(unresolved, minOp<scalar>());
    if (unresolved < GREAT && !told_)
    {
        told_ = true;
        Info<< "A contact of " << unresolved << " s in a step of " << wholeDt_
            << " s: bodies keep their restitution in steps of up to " << longest
            << " times that, and bounce less in longer ones" << endl;
    }
}


Foam::vector2D Foam::impactStep::toNext
(
    const scalar left,
    scalar& unresolved
)
{
    // Velocities, and the accelerations without and with the contacts
    List<vectorField> u(moved_.size());
    List<vectorField> accelerations(moved_.size());
    List<const externalForces*> forces(clumps_.size(), nullptr);
    forAll(coupled_, m)
    {
        forces[clumpOf_[m]] = coupled_[m].ext;
    }
    for (label a = 0; a < clumps_.size(); ++a)
    {
        const clumpParcel& p = clumps_[a];
        u[a] = inPart_ ? p.step().end.u : p.state().u;
        accelerations[a] = vectorField(2, Zero);
        if (type(a).fixed() || !type(a).ofSpheres())
        {
            u[a] = Zero;
            continue;
        }
        if (!inPart_)
        {
            forces[a] = &p.step().forces;
        }
        vector f(Zero);
        symmTensor held(Zero);
        scalar mass = type(a).mass();
        if (forces[a])
        {
            // In parts the coupling is inertia alone
            const externalForces& ext = *forces[a];
            f = sum(ext.f);
            if (!inPart_)
            {
                f -= sum(ext.zeta*(u[a] - ext.imposedU));
            }
            held = ext.held;
            mass += dt_*sum(ext.zeta);
        }
        accelerations[a][0] = (f - (held & f))/mass;
        for (label k = begins_[a]; k < begins_[a + 1]; ++k)
        {
            sphereContact t(sphereContacts_[k]);
            evaluate(t);
            t.first = t.d;
            evaluate(t);
            f += t.w.force*t.n;
        }
        accelerations[a][1] = (f - (held & f))/mass;
    }
    remote_.exchange(u);
    remote_.exchange(accelerations);

    vector2D result(GREAT, GREAT);
    for (label a = 0; a < clumps_.size(); ++a)
    {
        label next = begins_[a];
        for (label k = next; k < begins_[a + 1]; k = next)
        {
            while
            (
                next < begins_[a + 1]
             && sphereContacts_[next].b == sphereContacts_[k].b
            )
            {
                ++next;
            }
            if (inPart_ && !isCoupled_[a])
            {
                continue;
            }
            SubList<sphereContact> contacts(sphereContacts_, next - k, k);
            setMasses(contacts, u, min(left, wholeDt_/partsPerContact));
            for (const sphereContact& t : contacts)
            {
                if (!t.hasLaw || t.weight < leastWeight)
                {
                    continue;
                }
                const scalar v = approach(t, u, t.i, t.j);
                const scalar V = elastic(t, t.d);
                const scalar E = 0.5*t.m*sqr(v) + V;
                if (E <= 0 || (V <= 0 && v <= 0))
                {
                    continue;
                }
                const scalar T = duration(t, E);
                const scalar own = max
                (
                    mag(accelerations[a][0]),
                    t.b < 0 ? 0 : mag(accelerations[t.otherIndex][0])
                );
                const scalar turning =
                    V > 0
                  ? approach(t, accelerations, 1, 1)*T/constant::mathematical::pi
                  : 0;
                const scalar speed = Foam::sqrt(sqr(v) + sqr(turning));
                const scalar begins =
                    V > 0
                  ? 0
                  : closing(max(-t.d, 0.0), v, approach(t, accelerations, 0, 0));
                if
                (
                    begins >= left
                 || !stokesAllows(t, speed)
                 || speed <= own*wholeDt_
                 || speed*wholeDt_ <= 1e-6*t.R
                )
                {
                    continue;
                }
                if (wholeDt_ > longest*T)
                {
                    unresolved = min(unresolved, T);
                    continue;
                }
                const scalar h = T/partsPerContact;
                result =
                    min(result, vector2D(V > 0 ? h : max(begins, 0.05*h), h));
            }
        }
    }
    return returnReduce(result, minOp<vector2D>());
}


Foam::scalar Foam::impactStep::part(const scalar left, bool& resolves)
{
    beginPart();
    scalar unresolved = GREAT;
    const vector2D h(toNext(left, unresolved));
    resolves = h.x() < GREAT;
    return left - h.x() > 0.1*h.y() ? h.x() : left;
}


Foam::scalar Foam::impactStep::elasticEnergy() const
{
    scalar result = 0;
    for (const label a : clumpOf_)
    {
        for (label k = begins_[a]; k < begins_[a + 1]; ++k)
        {
            const sphereContact& t = sphereContacts_[k];
            const bool both = t.b >= 0 && isCoupled_[t.otherIndex];
            result += (both ? 0.5 : 1)*(elastic(t, t.d) + acrossGap(t));
        }
    }
    return result + bondEnergy();
}
