/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "soluteType.H"
#include "checkedEntries.H"

Foam::soluteType::soluteType(const dictionary& dict, const scalar diffusivity)
:
    diffusivity_(getPositiveOrDefault(dict, "diffusivity", diffusivity)),
    partition_(getPositiveOrDefault(dict, "partition", 1)),
    source_(getFiniteOrDefault<scalar>(dict, "source", 0)),
    rate_(getNonNegativeOrDefault(dict, "rate", 0)),
    maxUptake_(getNonNegativeOrDefault(dict, "maxUptake", 0))
{
    checkEntries
    (
        dict,
        {
            "permeability", "diffusivity", "partition", "initial", "concentration",
            "source", "rate", "maxUptake", "halfConcentration", "bound",
            "boundDiffusivity"
        }
    );
    if (dict.found("initial"))
    {
        initial_ = getNonNegative(dict, "initial");
    }
    if (dict.found("concentration"))
    {
        concentration_ = getNonNegative(dict, "concentration");
        for (const word key : {"initial", "source", "rate", "maxUptake", "bound"})
        {
            if (dict.found(key))
            {
                FatalIOErrorInFunction(dict)
                    << "Entries 'concentration' and '" << key << "': the concentration"
                    << " inside is kept, and " << key << " would have no effect. Remove"
                    << " one of them." << exit(FatalIOError);
            }
        }
    }
    if (dict.found("bound"))
    {
        bound_.reset(selectModel<boundModel>(getDict(dict, "bound")).ptr());
        boundDiffusivity_ = getNonNegativeOrDefault(dict, "boundDiffusivity", 0);
    }
    else if (dict.found("boundDiffusivity"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'boundDiffusivity' is that of what the entry 'bound' binds, which is"
            << " absent." << exit(FatalIOError);
    }
    permeability_ = getNonNegativeOrDefault
    (
        dict, "permeability", fixed() ? largestEntry : 0
    );
    if (maxUptake_ > 0)
    {
        halfConcentration_ = getPositive(dict, "halfConcentration");
    }
}


Foam::scalar Foam::soluteType::conductance
(
    const scalar d,
    const scalar diffusivity,
    const scalar least,
    const scalar c
) const
{
    if (impermeable())
    {
        return 0;
    }
    const scalar outside = max(d, least)/diffusivity;
    scalar D = diffusivity_;
    if (boundDiffusivity_ > 0)
    {
        D += boundDiffusivity_*bound_->capacity(max(c, scalar(0)));
    }
    const scalar inside = fixed() ? 0 : max(-d, scalar(0))/(partition_*D);
    return 1/(1/permeability_ + outside + inside);
}
