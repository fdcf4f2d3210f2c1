/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpBonds.H"

namespace
{

using namespace Foam;

//- A sphere that bonds do not join to sphere 0; -1 if there is none
label loose(const clumpType& type)
{
    boolList joined(type.size(), false);
    joined[0] = true;
    for (bool grows = true; grows; )
    {
        grows = false;
        for (const labelPair& pair : type.pairs())
        {
            if (joined[pair.first()] != joined[pair.second()])
            {
                joined[pair.first()] = true;
                joined[pair.second()] = true;
                grows = true;
            }
        }
    }
    return joined.find(false);
}

}


Foam::clumpBonds::clumpBonds(const clumpType& type, const dictionary& dict)
:
    type_(type),
    damped_(false),
    pattern_(type.size(), type.pairs())
{
    const label i = loose(type);
    if (i >= 0 && !type.fixed() && type.ofSpheres())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shape': bonds join sphere " << i << " to sphere 0 neither"
            << " directly nor through others. The spheres of a clump that moves"
            << " must hold together." << exit(FatalIOError);
    }
    if (type.pairs().size())
    {
        makeBonds(dict);
    }
    selectConservation(dict);
}


Foam::clumpBonds::clumpBonds(const clumpType& piece, const clumpBonds& whole)
:
    type_(piece),
    law_(whole.law_),
    damped_(false),
    thinning_(whole.thinning_),
    pattern_(piece.size(), piece.pairs())
{
    for (const label b : piece.bondsOf(whole.type_))
    {
        bond part(whole.bonds_[b]);
        part.i = piece.sphere(part.i);
        part.j = piece.sphere(part.j);
        damped_ = damped_ || part.damping.any();
        bonds_.append(part);
    }
}


void Foam::clumpBonds::makeBonds(const dictionary& dict)
{
    law_.reset(selectModel<bondModel>(getDict(dict, "bondModel")).ptr());
    const autoPtr<dampingModel> damping
    (
        selectModel<dampingModel>(getDict(dict, "dampingModel"))
    );
    thinning_ = damping->thinning();

    const pointField& x = type_.centres();
    const scalarField& r = type_.radii();
    const scalarField& m = type_.masses();
    const scalarField& I = type_.inertias();

    bonds_.setSize(type_.pairs().size());

    forAll(bonds_, b)
    {
        const label i = type_.pairs()[b].first();
        const label j = type_.pairs()[b].second();
        const vector d(x[j] - x[i]);
        const scalar length = mag(d);

        if (length < SMALL*max(r[i], r[j]))
        {
            FatalIOErrorInFunction(dict)
                << "Bond " << b << " joins spheres " << i << " and " << j
                << ", whose centres coincide." << exit(FatalIOError);
        }

        const bondCoefficients k(law_->stiffness(length, 0.5*(r[i] + r[j])));
        const bondCoefficients c
        (
            damping->coefficients(k, 0.5*(m[i] + m[j]), 0.5*(I[i] + I[j]))
        );
        damped_ = damped_ || c.any();

        scalar thinning = 0;
        if (thinning_.active() && c.any())
        {
            if (!(c.normal > 0))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry 'dampingModel': the damping of bond " << b
                    << " depends on the rate of strain, which needs a damping of the"
                    << " stretch above 0." << exit(FatalIOError);
            }
            thinning = 1/(c.normal*sqr(length*thinning_.rate()));
        }

        bonds_[b] = {i, j, d/length, length, k, c, 0.5*(r[i] + r[j]), thinning};
    }
}


void Foam::clumpBonds::selectConservation(const dictionary& dict)
{
    const auto add = [&](const dictionary& d)
    {
        auto model
        (
            selectModel<conservationModel>(d, type_.centres(), type_.radii())
        );
        if (model->active())
        {
            conservation_.append(model.ptr());
        }
    };

    if (dict.found("conservationModel"))
    {
        if (dict.found("conservationModels"))
        {
            FatalIOErrorInFunction(dict)
                << "Give 'conservationModel' or 'conservationModels', but not both."
                << exit(FatalIOError);
        }
        add(getDict(dict, "conservationModel"));
    }
    else if (dict.found("conservationModels"))
    {
        const dictionary& models = getDict(dict, "conservationModels");
        for (const word& name : models.toc())
        {
            add(getDict(models, name));
        }
    }
}
