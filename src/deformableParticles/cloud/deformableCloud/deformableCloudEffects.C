/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "sphereGrid.H"
#include "uniformDimensionedFields.H"
#include "StringStream.H"

void Foam::deformableCloud::decideOnce()
{
    if (effects_.automatic("fluid"))
    {
        const bool found = IOobject
        (
            "transportProperties", mesh_.time().constant(), mesh_
        ).typeHeaderOk<IOdictionary>(false);

        effects_.decide
        (
            "fluid",
            found,
            found
          ? "constant/transportProperties is there"
          : "no constant/transportProperties"
        );
    }

    const bool fluid = effects_.active("fluid");
    const bool coupled = fluid && !effects_.frozen();
    effects_.decide
    (
        "feedback",
        coupled,
        coupled ? "the fluid flows around the clumps"
      : fluid ? "the flow is frozen"
      : "no fluid"
    );
    if (effects_.frozen() && effects_.active("feedback"))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'effects': fluid frozen cannot feel the clumps, feedback on"
            << exit(FatalIOError);
    }
    if (!coupled)
    {
        effects_.decide
        (
            "convection", false, fluid ? "the flow is frozen" : "no fluid"
        );
    }
    effects_.decide
    (
        "refinement",
        coupled && mesh_.dynamic(),
        mesh_.dynamic() ? "dynamic mesh" : "static mesh"
    );
    effects_.decide
    (
        "loads",
        dict_.found("loads") && getDict(dict_, "loads").size(),
        dict_.found("loads") ? "loads in clumpProperties" : "no loads"
    );
    decideForModel("damping", "dampingModel");
    decideForModel("conservation", "conservationModel");

    if (!effects_.active("feedback"))
    {
        effects_.decide("rotation", false, "the fluid does not feel the clumps");
    }
    else if (effects_.automatic("rotation"))
    {
        const word model(getDict(dict_, "rotation").get<word>("type"));
        effects_.decide("rotation", model != "none", model);
    }
}


void Foam::deformableCloud::decideForModel
(
    const char* effect,
    const word& family
)
{
    const dictionary& types = getDict(dict_, "types");
    for (const word& name : types.toc())
    {
        const dictionary& type = getDict(types, name);
        const dictionary list(type.subOrEmptyDict(family + 's'));
        word models
        (
            type.subOrEmptyDict(family).getOrDefault<word>("type", "none")
        );
        for (const word& entry : list.toc())
        {
            const word model
            (
                list.subOrEmptyDict(entry).getOrDefault<word>("type", "none")
            );
            models = models == "none" ? model : word(models + ", " + model, false);
        }
        if (models != "none")
        {
            effects_.decide(effect, true, name + " has " + models);
            return;
        }
    }
    effects_.decide(effect, false, "no " + family);
}


void Foam::deformableCloud::decideEffects()
{
    if (effects_.automatic("gravity"))
    {
        scalar excess = 0;
        for (const clumpType& ct : types_)
        {
            excess = max(excess, mag(ct.mass() - rho_*ct.volume())/ct.mass());
        }
        const bool on = mag(g_) > 0 && excess > 1e-6;
        effects_.decide
        (
            "gravity",
            on,
            mag(g_) == 0 ? "no gravity in constant/g"
          : on ? "densities differ" : "equal densities"
        );
    }

    if (effects_.automatic("contact"))
    {
        if (!contactModel_->active())
        {
            effects_.decide("contact", false, "contactModel none");
        }
        else if (nClumps_ < 2 && !ghosts_.meetsItself())
        {
            effects_.decide("contact", false, "one clump in the domain");
        }
        else
        {
            // Boxes meet, or may meet within this step
            const UList<clumpImage>& images = ghosts_.images();
            scalarField margins(ghosts_.nOwn());
            forAll(margins, a)
            {
                margins[a] =
                    2*max(mag(images[a].u))*mesh_.time().deltaTValue();
            }
            bool near = false;
            sphereGrid::forEachNear
            (
                images, ghosts_.nOwn(), margins,
                [&](const label, const label) { near = true; }
            );
            reduce(near, orOp<bool>());
            effects_.decide
            (
                "contact", near, near ? "clumps are near" : "no clumps are near"
            );
        }
    }

    decideWalls();
}


void Foam::deformableCloud::decideWalls()
{
    // Walls are those of the neighbouring processors, too
    if (wallsOf_ != ghosts_.neighbourhood())
    {
        wallsOf_ = ghosts_.neighbourhood();
        walls_.clear();
        wallClearance_ = 0;
    }

    if (!effects_.automatic("walls"))
    {
        if (effects_.active("walls") && !walls_.valid())
        {
            walls_.reset(new wallSurface(mesh_, ghosts_));
        }
        return;
    }
    if (!wallContactModel_->active())
    {
        effects_.decide("walls", false, "wallContactModel none");
        return;
    }

    // Measured anew only when a clump may have come near since
    wallClearance_ -= maxSpeed()*mesh_.time().deltaTValue();
    if (walls_.valid() && wallClearance_ > 0)
    {
        return;
    }
    if (!walls_.valid())
    {
        walls_.reset(new wallSurface(mesh_, ghosts_));
    }

    scalar gap = GREAT;
    scalar radius = 0;
    for (const clumpParcel& p : *this)
    {
        if (type(p).fixed())
        {
            continue;
        }
        const pointField centres(p.centres());
        forAll(centres, i)
        {
            const scalar r = type(p).radii()[i];
            gap = min(gap, walls_->distance(centres[i], 100*r) - r);
            radius = max(radius, r);
        }
    }
    reduce(gap, minOp<scalar>());
    reduce(radius, maxOp<scalar>());

    const bool near = gap < 0.5*radius;
    wallClearance_ = near ? 0 : gap - 0.5*radius;

    OStringStream reason;
    if (gap > 98*radius)
    {
        reason << "none near";
    }
    else
    {
        // Two digits: the number is for people
        reason.precision(2);
        reason << "nearest " << 1e6*gap << " um";
    }
    effects_.decide("walls", near, reason.str());
}
