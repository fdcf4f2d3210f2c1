/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "membraneContacts.H"

void Foam::membraneContacts::readInside
(
    const dictionary& clumpProperties,
    const scalar rho
)
{
    const dictionary dict(clumpProperties.subOrEmptyDict("membraneContact"));
    List<Pair<word>> names;
    dict.readIfPresent("inside", names);
    for (const Pair<word>& pair : names)
    {
        labelPair types(-1, -1);
        wordList membranes;
        forAll(types_, typei)
        {
            if (!types_[typei].hasTriangles())
            {
                continue;
            }
            membranes.append(types_[typei].name());
            for (label n = 0; n < 2; ++n)
            {
                if (types_[typei].name() == pair[n])
                {
                    types[n] = typei;
                }
            }
        }
        if
        (
            types.first() < 0
         || types.second() < 0
         || types.first() == types.second()
        )
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'inside': (" << pair.first() << ' ' << pair.second()
                << ") are not two types of membranes. Valid types: "
                << flatOutput(membranes) << exit(FatalIOError);
        }
        const clumpType& outerType = types_[types.second()];
        const scalar inner = types_[types.first()].viscosityRatio();
        const scalar outer = outerType.viscosityRatio();
        if (inner != 1 && inner != outer)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'inside': the viscosityRatio of " << pair.first() << " is "
                << inner << "; inside " << pair.second() << " it can be 1, the fluid of"
                << " that type, or " << outer << '.' << exit(FatalIOError);
        }
        const scalar density = outerType.mass()/outerType.volume();
        if (mag(density - rho) > 1e-6*rho)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'inside': the density of " << pair.second() << " is " << density
                << " kg/m3. Around another membrane it must be that of the fluid, " << rho
                << " kg/m3." << exit(FatalIOError);
        }
        inside_.append(types);
    }
}


bool Foam::membraneContacts::isInside
(
    const clumpImage& inner,
    const pointField& x,
    const clumpImage& outer,
    const surfaceDistance& distance
) const
{
    if (!inside_.found(labelPair(inner.typeId, outer.typeId)))
    {
        return false;
    }
    const pointField centre(1, average(x));
    return distance.inside(centre, distance.nearest(centre, typeOf(outer).reach()))[0];
}
