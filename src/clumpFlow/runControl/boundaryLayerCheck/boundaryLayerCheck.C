/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "boundaryLayerCheck.H"
#include "mathematicalConstants.H"
#include "StringStream.H"
#include "volFields.H"

Foam::boundaryLayerCheck::boundaryLayerCheck(const deformableCloud& cloud)
:
    cloud_(cloud),
    nClumps_(0),
    nThin_(0),
    thinnest_(GREAT),
    Re_(0),
    layer_(GREAT)
{}


Foam::scalar Foam::boundaryLayerCheck::ReynoldsNumber(const scalar f)
{
    // The iteration contracts by 0.687 at most
    scalar Re = f;
    for (label n = 0; n < 60; ++n)
    {
        Re = f/(1 + 0.15*pow(Re, 0.687));
    }
    return Re;
}


void Foam::boundaryLayerCheck::add
(
    const volVectorField& U,
    const volScalarField& nu
)
{
    const vector mean(U().weightedAverage(cloud_.mesh().V()).value());
    for (const clumpParcel& p : cloud_)
    {
        const clumpType& type = cloud_.type(p);
        if (!type.ofSpheres())
        {
            continue;
        }
        ++nClumps_;
        const scalar f =
            mag(sum(p.fluidForces()))
           /(3*constant::mathematical::pi*cloud_.fluidDensity()*sqr(nu[p.cell()]));
        const scalar ofVelocity =
            mag(p.state().velocity(type) - mean)*2*type.reach()/nu[p.cell()];

        // Re is at most f, so that it is rarely needed
        const scalar cells = 2*type.reach()/cbrt(cloud_.mesh().V()[p.cell()]);
        const scalar Re =
            min(f, ofVelocity) > sqr(cells) ? min(ReynoldsNumber(f), ofVelocity) : 0;
        if (Re > sqr(cells))
        {
            ++nThin_;
            const scalar layer = cells/sqrt(Re);
            if (layer < thinnest_)
            {
                thinnest_ = layer;
                Re_ = Re;
            }
            layer_ = min(layer_, 2*type.reach()/sqrt(Re));
        }
    }
}


void Foam::boundaryLayerCheck::end() const
{
    const scalar thinnest = returnReduce(thinnest_, minOp<scalar>());
    const scalar Re = returnReduce(thinnest_ == thinnest ? Re_ : 0, maxOp<scalar>());
    const scalar nThin = returnReduce(nThin_, sumOp<scalar>());
    const scalar nClumps = returnReduce(nClumps_, sumOp<scalar>());
    const scalar layer = returnReduce(layer_, minOp<scalar>());
    if (nThin > 0.1*nClumps)
    {
        OStringStream os;
        os.precision(3);
        os  << "The boundary layers of clumps, D/sqrt(Re) thick, were thinner than a mesh"
            << " cell for " << label(100*nThin/nClumps) << " % of all clumps and steps; the"
            << " thinnest had " << thinnest << " mesh cells, at the Reynolds number " << Re
            << ". Clumps are then too slow, by 4 to 8 % where a layer has 0.7 to 0.9 mesh"
            << " cells. Mesh cells of " << layer << " m resolve all of them.";
        WarningInFunction << os.str().c_str() << endl;
    }
}
