/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "placement.H"
#include "Random.H"
#include "labelVector.H"
#include "boundBox.H"
#include "unitConversion.H"
#include <cmath>

Foam::placement::placement
(
    const dictionary& dict,
    const PtrList<clumpType>& types,
    const HashTable<label>& typeIds
)
:
    types_(types),
    typeIds_(typeIds)
{
    const word type(dict.get<word>("type"));
    const HashTable<label> kinds({{"list", 0}, {"lattice", 1}, {"random", 2}});

    if (!kinds.found(type))
    {
        FatalIOErrorInLookup(dict, "placement", type, kinds)
            << exit(FatalIOError);
    }
    switch (kinds[type])
    {
        case 0: readList(dict); break;
        case 1: makeLattice(dict); break;
        case 2: packRandomly(dict); break;
    }
}


Foam::label Foam::placement::typeId
(
    const dictionary& dict,
    const word& entry
) const
{
    const word name(dict.get<word>(entry));
    if (!typeIds_.found(name))
    {
        FatalIOErrorInLookup(dict, entry, name, typeIds_) << exit(FatalIOError);
    }
    return typeIds_[name];
}


void Foam::placement::checkNumber
(
    const dictionary& dict,
    const word& entry,
    const scalar number
)
{
    if (!(number >= 1 && number <= 1e7))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << entry << "' requests " << number
            << " clumps; the number must be between 1 and 10 million."
            << exit(FatalIOError);
    }
}


void Foam::placement::checkBox(const dictionary& dict, const boundBox& mesh)
{
    if (dict.get<word>("type") != "random")
    {
        return;
    }
    boundBox allowed(mesh);
    allowed.inflate(1e-6);
    const boundBox box(dict.get<point>("min"), dict.get<point>("max"));
    if (!allowed.contains(box))
    {
        FatalIOErrorInFunction(dict)
            << "The box from 'min' " << box.min() << " to 'max' " << box.max()
            << " extends outside the mesh, which reaches from " << mesh.min()
            << " to " << mesh.max() << '.' << exit(FatalIOError);
    }
}


void Foam::placement::readList(const dictionary& dict)
{
    checkEntries(dict, {"type", "clumps"});

    for (const dictionary& d : getDictList(dict, "clumps"))
    {
        checkEntries
        (
            d,
            {
                "type", "position", "axis", "angle", "velocity",
                "angularVelocity"
            }
        );
        const label id = typeId(d, "type");

        quaternion turn(quaternion::I);
        if (d.found("axis") || d.found("angle"))
        {
            const vector axis(getFinite<vector>(d, "axis"));
            if (mag(axis) < VSMALL)
            {
                FatalIOErrorInFunction(d)
                    << "Entry 'axis' must not be zero." << exit(FatalIOError);
            }
            turn = rotation(degToRad(getFinite<scalar>(d, "angle"))*axis/mag(axis));
        }

        placed p
        {
            id,
            getFinite<point>(d, "position"),
            clumpState(types_[id], turn),
            !d.found("velocity") && !d.found("angularVelocity")
        };
        p.state.setRigidMotion
        (
            types_[id],
            getFiniteOrDefault<vector>(d, "velocity", Zero),
            getFiniteOrDefault<vector>(d, "angularVelocity", Zero)
        );
        clumps_.append(p);
    }
}


void Foam::placement::makeLattice(const dictionary& dict)
{
    checkEntries(dict, {"type", "clumpType", "origin", "spacing", "number"});

    const label id = typeId(dict, "clumpType");
    const point origin(getFinite<point>(dict, "origin"));
    const vector spacing(getFinite<vector>(dict, "spacing"));
    const labelVector number(dict.get<labelVector>("number"));

    if (cmptMin(number) < 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'number' is " << number << "; every component must be"
            << " above 0." << exit(FatalIOError);
    }
    checkNumber
    (
        dict, "number", scalar(number.x())*number.y()*number.z()
    );

    for (label k = 0; k < number.z(); ++k)
    {
        for (label j = 0; j < number.y(); ++j)
        {
            for (label i = 0; i < number.x(); ++i)
            {
                clumps_.append
                (
                    placed
                    {
                        id,
                        origin + cmptMultiply(vector(i, j, k), spacing),
                        clumpState(types_[id]),
                        true
                    }
                );
            }
        }
    }
}


void Foam::placement::packRandomly(const dictionary& dict)
{
    checkEntries
    (
        dict,
        {
            "type", "clumpType", "haematocrit", "min", "max", "periodic", "seed"
        }
    );

    const label id = typeId(dict, "clumpType");
    const clumpType& type = types_[id];
    const boundBox box
    (
        getFinite<point>(dict, "min"), getFinite<point>(dict, "max")
    );
    if (cmptMin(box.span()) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'max' is " << box.max() << "; it must be above min, "
            << box.min() << exit(FatalIOError);
    }
    const labelVector periodic(dict.get<labelVector>("periodic"));
    if (cmptMin(periodic) < 0 || cmptMax(periodic) > 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'periodic' is " << periodic << "; every component must be"
            << " 0 or 1." << exit(FatalIOError);
    }
    const scalar haematocrit = getBetween(dict, "haematocrit", 0, 1);
    Random random(dict.get<label>("seed"));

    const scalar number =
        std::round(haematocrit*box.volume()/type.nominalVolume());
    checkNumber(dict, "haematocrit", number);
    const label wanted(number);
    const vector span(box.span());

    const auto nearest = [&](vector d)
    {
        for (direction c = 0; c < 3; ++c)
        {
            if (periodic[c])
            {
                d[c] -= span[c]*std::round(d[c]/span[c]);
            }
        }
        return d;
    };

    const auto overlaps = [&](const placed& a, const placed& b)
    {
        if (mag(nearest(a.position - b.position)) > 2*type.reach())
        {
            return false;
        }
        forAll(a.state.x, i)
        {
            forAll(b.state.x, j)
            {
                const vector d
                (
                    a.position + a.state.x[i] - b.position - b.state.x[j]
                );
                if (mag(nearest(d)) < type.radii()[i] + type.radii()[j])
                {
                    return true;
                }
            }
        }
        return false;
    };

    const auto fits = [&](const placed& p)
    {
        // Whole between the faces that do not repeat
        forAll(p.state.x, i)
        {
            const point x(p.position + p.state.x[i]);
            const scalar r = type.radii()[i];
            for (direction c = 0; c < 3; ++c)
            {
                if
                (
                    !periodic[c]
                 && (x[c] - r < box.min()[c] || x[c] + r > box.max()[c])
                )
                {
                    return false;
                }
            }
        }
        for (const placed& other : clumps_)
        {
            if (overlaps(p, other))
            {
                return false;
            }
        }
        return true;
    };

    while (clumps_.size() < wanted)
    {
        bool found = false;
        for (label tries = 0; tries < 10000 && !found; ++tries)
        {
            // Uniform over all rotations: a normalised Gaussian quaternion
            quaternion q
            (
                random.GaussNormal<scalar>(),
                vector
                (
                    random.GaussNormal<scalar>(),
                    random.GaussNormal<scalar>(),
                    random.GaussNormal<scalar>()
                )
            );
            q.normalize();

            const placed p
            {
                id, random.position(box.min(), box.max()), clumpState(type, q),
                true
            };
            if (fits(p))
            {
                clumps_.append(p);
                found = true;
            }
        }
        if (!found)
        {
            FatalIOErrorInFunction(dict)
                << "Haematocrit " << haematocrit << " cannot be reached: only "
                << clumps_.size() << " of " << wanted
                << " clumps could be placed without overlap."
                << exit(FatalIOError);
        }
    }
}


Foam::Pair<Foam::scalar> Foam::placement::fractions
(
    const PtrList<clumpType>& types,
    const labelUList& numbers,
    const scalar volume
)
{
    Pair<scalar> result(0, 0);
    forAll(types, i)
    {
        if (!types[i].fixed())
        {
            result.first() += numbers[i]*types[i].nominalVolume()/volume;
            result.second() += numbers[i]*types[i].volume()/volume;
        }
    }
    return result;
}
