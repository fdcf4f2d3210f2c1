/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpSolute.H"

Foam::tmp<Foam::surfaceScalarField> Foam::functionObjects::clumpSolute::flux() const
{
    const auto* phi = mesh_.findObject<surfaceScalarField>("phi");
    if (!phi)
    {
        FatalErrorInFunction
            << name() << ": there is no flow (phi) that a solute could go with"
            << exit(FatalError);
    }
    tmp<surfaceScalarField> result(new surfaceScalarField("soluteFlux", *phi));
    const vector& V = cloud().meshVelocity();
    if (V != vector::zero)
    {
        surfaceScalarField& f = result.ref();
        f.primitiveFieldRef() -= V & mesh_.Sf().primitiveField();
        forAll(mesh_.boundary(), patchi)
        {
            if (mesh_.boundary()[patchi].coupled())
            {
                f.boundaryFieldRef()[patchi] -= V & mesh_.boundary()[patchi].Sf();
            }
        }
    }
    return result;
}


void Foam::functionObjects::clumpSolute::takeAlong()
{
    if (!mesh_.moving())
    {
        return;
    }
    const scalarField ratio(mesh_.V0().field()/mesh_.V().field());
    outside_->stretch(ratio);
    inside_->stretch(ratio);
    outerContent_->primitiveFieldRef() *= ratio;
    innerContent_->primitiveFieldRef() *= ratio;
}


void Foam::functionObjects::clumpSolute::moveClumps()
{
    const bool changed =
        mesh_.topoChanging() || surfaces_->type().size() != mesh_.nCells();
    if (changed || mesh_.moving())
    {
        surfaces_.reset(new bodySurfaces(mesh_));
    }
    surfaces_->update(cloud());
    const scalarField& alpha = surfaces_->fraction();
    const surfaceScalarField& theta = surfaces_->faceFraction();
    const surfaceScalarField phi(flux());

    // Clumps that have come bring their content and take the place of fluid
    const scalarField change(inside_->update(alpha, theta*phi));
    scalarField& inner = innerContent_->primitiveFieldRef();
    scalarField& outer = outerContent_->primitiveFieldRef();
    scalar entered = 0;
    forAll(change, celli)
    {
        const scalar c = (*outer_)[celli];
        const scalar initial = type(celli).initial(c);
        const scalar in = change[celli]
           *(
                change[celli] > 0
              ? initial + type(celli).bound(initial)
              : (*inner_)[celli] + (*bound_)[celli]
            );
        const scalar out = -change[celli]*c;
        inner[celli] += in;
        outer[celli] += out;
        entered += (in + out)*mesh_.V()[celli];
    }
    entered_ += returnReduce(entered, sumOp<scalar>());
    outside_->add(-change);

    // A pocket of fluid that opens or closes between the spheres of a clump
    const scalarField opened(outside_->update(1 - alpha, (1 - theta)*phi));
    inside_->add(-opened);
    forAll(opened, celli)
    {
        const scalar moved =
            opened[celli]
           *(
                opened[celli] > 0
              ? (*inner_)[celli] + (*bound_)[celli] : (*outer_)[celli]
            );
        inner[celli] -= moved;
        outer[celli] += moved;
    }
}


void Foam::functionObjects::clumpSolute::fillEmpty()
{
    scalarField& out = outer_->primitiveFieldRef();
    scalarField& in = inner_->primitiveFieldRef();
    scalarField& outerContent = outerContent_->primitiveFieldRef();
    scalarField& innerContent = innerContent_->primitiveFieldRef();
    forAll(out, celli)
    {
        const scalar K = type(celli).partition();
        if (!inside_->active(celli))
        {
            inside_->give(celli, *outside_);
            outerContent[celli] += innerContent[celli];
            innerContent[celli] = 0;
            in[celli] = K*out[celli];
        }
        else if (!outside_->active(celli))
        {
            outside_->give(celli, *inside_);
            innerContent[celli] += outerContent[celli];
            outerContent[celli] = 0;
            out[celli] = in[celli]/K;
        }
    }
}
