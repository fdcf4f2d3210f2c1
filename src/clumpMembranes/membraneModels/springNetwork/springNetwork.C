/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "springNetwork.H"
#include "EdgeMap.H"

namespace Foam
{
namespace membraneModels
{
    defineTypeNameAndDebug(springNetwork, 0);
    addToRunTimeSelectionTable(membraneModel, springNetwork, dictionary);
}
}

namespace
{

//- Of a worm-like chain at a part y of its largest length: the force and its derivative
Foam::scalar chainForce(const Foam::scalar y)
{
    return 0.25/Foam::sqr(1 - y) - 0.25 + y;
}

Foam::scalar chainStiffness(const Foam::scalar y)
{
    return 0.5/Foam::pow3(1 - y) + 1;
}

}


Foam::membraneModels::springNetwork::springNetwork
(
    const dictionary& dict,
    const closedSurface& surface,
    const pointField& x0
)
:
    surface_(surface),
    largest_(getPositiveOrDefault(dict, "largestStretch", 2.2)),
    lengths_(surface.hinges().size()),
    energies_(surface.hinges().size())
{
    checkEntries(dict, {"type", "shearModulus", "largestStretch"});
    if (largest_ < 1.1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'largestStretch' must be at least 1.1 (1 is the stretch at rest): "
            << largest_ << exit(FatalIOError);
    }
    const scalar y = 1/largest_;
    scale_ = 1/(chainStiffness(y)/largest_ + 2*chainForce(y));

    const scalar modulus = getPositive(dict, "shearModulus");
    forAll(lengths_, e)
    {
        const closedSurface::hinge& h = surface.hinges()[e];
        const vector along(x0[h.j] - x0[h.i]);
        const scalar areas =
            0.5*(mag(along ^ (x0[h.left] - x0[h.i])) + mag(along ^ (x0[h.right] - x0[h.i])));
        lengths_[e] = mag(along);
        energies_[e] = 8.0/3*modulus*areas;
    }
}


Foam::FixedList<Foam::scalar, 3> Foam::membraneModels::springNetwork::spring
(
    const scalar s
) const
{
    // Without a length, the energy is infinite
    const scalar within = min(max(s, SMALL), 0.95*largest_);
    const scalar y = within/largest_;
    const scalar repulsion = chainForce(1/largest_);
    const scalar force = scale_*(chainForce(y) - repulsion/sqr(within));
    const scalar stiffness =
        scale_*(chainStiffness(y)/largest_ + 2*repulsion/pow3(within));

    // The integral of chainForce from y = 1/m to y, times m
    const auto chainEnergy = [&](const scalar z)
    {
        return largest_*(0.25/(1 - z) - 0.25*z + 0.5*sqr(z));
    };
    const scalar energy =
        scale_
       *(
            chainEnergy(y) - chainEnergy(1/largest_)
          + repulsion*(1/within - 1)
        );

    const scalar beyond = max(s - within, scalar(0));
    return
    {
        energy + (force + 0.5*stiffness*beyond)*beyond,
        force + stiffness*beyond,
        stiffness
    };
}


Foam::scalar Foam::membraneModels::springNetwork::add
(
    const pointField& x,
    vectorField& gradient,
    membraneTangent* tangent
) const
{
    scalar energy = 0;
    forAll(lengths_, e)
    {
        const closedSurface::hinge& h = surface_.hinges()[e];
        const vector along(x[h.j] - x[h.i]);
        const scalar length = max(mag(along), SMALL*lengths_[e]);
        const vector n(along/length);
        const auto psi = spring(length/lengths_[e]);
        energy += energies_[e]*psi[0];

        const scalar tension = energies_[e]*psi[1]/lengths_[e];
        gradient[h.j] += tension*n;
        gradient[h.i] -= tension*n;
        if (tangent)
        {
            // Springs that are shorter than at rest would turn away: a negative stiffness
            const scalar across = tangent->kept(tension)/length;
            const scalar stiffness = energies_[e]*psi[2]/sqr(lengths_[e]);
            const Eigen::Vector3d t(n.x(), n.y(), n.z());
            const Eigen::Matrix3d K
            (
                across*Eigen::Matrix3d::Identity() + (stiffness - across)*t*t.transpose()
            );
            tangent->add(h.i, h.i, K);
            tangent->add(h.j, h.j, K);
            tangent->add(max(h.i, h.j), min(h.i, h.j), -K);
        }
    }
    return energy;
}


void Foam::membraneModels::springNetwork::addTensions
(
    const pointField& x,
    symmTensorField& tensions
) const
{
    EdgeMap<label> springs(2*lengths_.size());
    forAll(lengths_, e)
    {
        const closedSurface::hinge& h = surface_.hinges()[e];
        springs.insert(edge(h.i, h.j), e);
    }
    forAll(tensions, n)
    {
        const triFace& t = surface_.triangles()[n];
        const scalar area = max(t.mag(x), VSMALL);
        forAll(t, k)
        {
            const edge nodes(t[k], t[t.fcIndex(k)]);
            const label e = springs[nodes];
            const vector along(nodes.vec(x));
            const scalar length = max(mag(along), SMALL*lengths_[e]);
            const scalar force =
                energies_[e]*spring(length/lengths_[e])[1]/lengths_[e];
            tensions[n] += 0.5*force/(length*area)*sqr(along);
        }
    }
}
