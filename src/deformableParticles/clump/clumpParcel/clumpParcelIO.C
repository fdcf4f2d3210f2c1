/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"

Foam::clumpParcel::clumpParcel
(
    const polyMesh& mesh,
    Istream& is,
    bool readFields,
    bool newFormat
)
:
    particle(mesh, is, readFields, newFormat),
    typeId_(-1),
    displacement_(Zero),
    target_(Zero)
{
    if (readFields)
    {
        is  >> typeId_ >> displacement_ >> target_ >> state_
            >> fluidForces_
            >> fluidTorques_;
    }
    is.check(FUNCTION_NAME);
}


Foam::Ostream& Foam::operator<<(Ostream& os, const clumpParcel& p)
{
    os  << static_cast<const particle&>(p)
        << token::SPACE << p.typeId_
        << token::SPACE << p.displacement_
        << token::SPACE << p.target_
        << token::SPACE << p.state_
        << token::SPACE << p.fluidForces_
        << token::SPACE << p.fluidTorques_;
    os.check(FUNCTION_NAME);
    return os;
}


namespace
{

using namespace Foam;

//- Where the vector lists of a clump stand on disk, and in the state
struct listField
{
    const char* name;
    vectorField clumpState::* member;
};

const listField listFields[] =
{
    {"velocities", &clumpState::u},
    {"spins", &clumpState::w},
    {"accelerations", &clumpState::a},
    {"angularAccelerations", &clumpState::b},
    {"bondForces", &clumpState::n},
    {"bondMoments", &clumpState::m}
};

template<class Type, class Setter>
void readLists(Cloud<clumpParcel>& c, const word& name, const Setter& set)
{
    CompactIOField<Field<Type>, Type> lists
    (
        c.fieldIOobject(name, IOobject::MUST_READ), c.size() > 0
    );
    c.checkFieldFieldIOobject(c, lists);

    label i = 0;
    for (clumpParcel& p : c)
    {
        set(p, lists[i++]);
    }
}

template<class Type, class Getter>
void writeLists(const Cloud<clumpParcel>& c, const word& name, const Getter& get)
{
    CompactIOField<Field<Type>, Type> lists
    (
        c.fieldIOobject(name, IOobject::NO_READ), c.size()
    );

    label i = 0;
    for (const clumpParcel& p : c)
    {
        lists[i++] = get(p);
    }

    lists.write(c.size() > 0);
}

}


void Foam::clumpParcel::readFields(Cloud<clumpParcel>& c)
{
    particle::readFields(c);

    IOField<label> typeIds
    (
        c.fieldIOobject("typeId", IOobject::MUST_READ), c.size() > 0
    );
    c.checkFieldIOobject(c, typeIds);

    IOField<scalar> exchange
    (
        c.fieldIOobject("exchangeFactor", IOobject::MUST_READ), c.size() > 0
    );
    c.checkFieldIOobject(c, exchange);

    label i = 0;
    for (clumpParcel& p : c)
    {
        p.typeId_ = typeIds[i];
        p.state_.exchange = exchange[i++];
    }

    readLists<vector>
    (
        c, "centres",
        [](clumpParcel& p, const vectorField& f) { p.state_.x = f; }
    );
    for (const listField& field : listFields)
    {
        readLists<vector>
        (
            c, field.name,
            [&](clumpParcel& p, const vectorField& f)
            {
                p.state_.*(field.member) = f;
            }
        );
    }
    readLists<vector>
    (
        c, "hydrodynamicForces",
        [](clumpParcel& p, const vectorField& f) { p.fluidForces_ = f; }
    );
    readLists<vector>
    (
        c, "hydrodynamicTorques",
        [](clumpParcel& p, const vectorField& f) { p.fluidTorques_ = f; }
    );
    readLists<scalar>
    (
        c, "brokenBonds",
        [](clumpParcel& p, const scalarField& f) { p.state_.broken = f; }
    );
    readLists<scalar>
    (
        c, "orientations",
        [](clumpParcel& p, const scalarField& f)
        {
            p.state_.q.setSize(f.size()/4);
            forAll(p.state_.q, k)
            {
                p.state_.q[k] = quaternion
                (
                    f[4*k], vector(f[4*k + 1], f[4*k + 2], f[4*k + 3])
                );
            }
        }
    );
}


void Foam::clumpParcel::writeFields(const Cloud<clumpParcel>& c)
{
    particle::writeFields(c);

    const bool valid = c.size() > 0;

    IOField<label> typeIds
    (
        c.fieldIOobject("typeId", IOobject::NO_READ), c.size()
    );
    IOField<vector> U(c.fieldIOobject("U", IOobject::NO_READ), c.size());
    IOField<scalar> exchange
    (
        c.fieldIOobject("exchangeFactor", IOobject::NO_READ), c.size()
    );

    const auto& cloud = dynamic_cast<const deformableCloud&>(c);
    label i = 0;
    for (const clumpParcel& p : c)
    {
        typeIds[i] = p.typeId_;
        U[i] = p.state_.velocity(cloud.type(p));
        exchange[i] = p.state_.exchange;
        ++i;
    }
    typeIds.write(valid);
    U.write(valid);
    exchange.write(valid);

    writeLists<vector>
    (
        c, "centres", [](const clumpParcel& p) { return p.state_.x; }
    );
    for (const listField& field : listFields)
    {
        writeLists<vector>
        (
            c, field.name,
            [&](const clumpParcel& p) { return p.state_.*(field.member); }
        );
    }
    writeLists<vector>
    (
        c, "hydrodynamicForces",
        [](const clumpParcel& p) { return p.fluidForces_; }
    );
    writeLists<vector>
    (
        c, "hydrodynamicTorques",
        [](const clumpParcel& p) { return p.fluidTorques_; }
    );
    writeLists<scalar>
    (
        c, "brokenBonds",
        [](const clumpParcel& p) { return p.state_.broken; }
    );
    writeLists<scalar>
    (
        c, "orientations",
        [](const clumpParcel& p)
        {
            scalarField f(4*p.state_.q.size());
            forAll(p.state_.q, k)
            {
                const quaternion& q = p.state_.q[k];
                f[4*k] = q.w();
                f[4*k + 1] = q.v().x();
                f[4*k + 2] = q.v().y();
                f[4*k + 3] = q.v().z();
            }
            return f;
        }
    );
}
