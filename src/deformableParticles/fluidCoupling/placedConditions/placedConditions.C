/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "placedConditions.H"
#include "cellSetOption.H"
#include "volFields.H"

namespace
{

using namespace Foam;

template<class Type>
bool uniform(const fvPatchField<Type>& field)
{
    const scalar most = gMax(mag(field));
    const Type mean(gAverage(field));
    return gMax(mag(field - mean)()) <= 1e-9*most;
}


template<class Type>
word placed(const GeometricField<Type, fvPatchField, volMesh>& field)
{
    const wordHashSet anywhere
    ({
        "fixedValue", "noSlip", "slip", "uniformFixedValue", "zeroGradient",
        "fixedFluxPressure", "symmetryPlane", "symmetry"
    });
    const label n = field.mesh().boundaryMesh().nNonProcessor();
    for (label patchi = 0; patchi < n; ++patchi)
    {
        const fvPatchField<Type>& pf = field.boundaryField()[patchi];
        const bool same =
            pf.coupled()
          ? pf.type() == pf.patch().type() || pf.type() == "uniformJump"
          : anywhere.found(pf.type()) && (!pf.fixesValue() || uniform(pf));
        if (!same)
        {
            return pf.patch().name();
        }
    }
    return word::null;
}

}


Foam::word Foam::placedCondition(const volScalarField& field)
{
    return placed(field);
}


Foam::word Foam::placedCondition(const volVectorField& field)
{
    return placed(field);
}


Foam::word Foam::placedSource(PtrList<fv::option>& options, const word& field)
{
    const wordHashSet anywhere
    ({
        "meanVelocityGradient", "vectorSemiImplicitSource",
        "scalarSemiImplicitSource"
    });
    for (fv::option& option : options)
    {
        const bool acts = option.isActive() && option.applyToField(field) >= 0;
        const fv::cellSetOption* part =
            isA<fv::cellSetOption>(option)
          ? &refCast<const fv::cellSetOption>(option) : nullptr;
        const bool everywhere =
            anywhere.found(option.type()) && part
         && returnReduce
            (
                part->cells().size() == part->mesh().nCells(),
                andOp<bool>()
            );
        if (acts && !everywhere)
        {
            return option.name();
        }
    }
    return word::null;
}
