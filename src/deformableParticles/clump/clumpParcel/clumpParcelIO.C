/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "deformableCloud.H"
#include "compactFieldReader.H"

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
    {"angularVelocities", &clumpState::w},
    {"accelerations", &clumpState::a},
    {"angularAccelerations", &clumpState::b}
};

//- Fatal, naming the file and the clump
void refuse
(
    const Cloud<clumpParcel>& c,
    const word& name,
    const clumpParcel& p,
    const string& what
)
{
    FatalErrorInFunction
        << c.fieldIOobject(name, IOobject::NO_READ).objectPath()
        << ": clump " << p.origId() << ' ' << what.c_str() << exit(FatalError);
}

//- Fatal when a parcel is not in the tetrahedron of the mesh it names:
//  OpenFOAM reads it as it is and looks there at once
void checkPlace(const Cloud<clumpParcel>& c, const label index, const particle& p)
{
    const polyMesh& mesh = p.mesh();
    const label celli = p.cell();
    const label facei = p.tetFace();
    const barycentric& x = p.coordinates();

    const bool inside =
        celli >= 0 && celli < mesh.nCells()
     && mesh.cells()[celli].found(facei)
     && p.tetPt() > 0 && p.tetPt() < mesh.faces()[facei].size() - 1
     && physical(x) && cmptMin(x) > -1e-3 && mag(cmptSum(x) - 1) < 1e-3;

    if (!inside)
    {
        FatalErrorInFunction
            << c.fieldIOobject("coordinates", IOobject::NO_READ).objectPath()
            << ": clump " << index << " is in no cell of the mesh"
            << exit(FatalError);
    }
}

//- Fatal when a file has not one entry per clump
void checkNumber
(
    const Cloud<clumpParcel>& c, const regIOobject& file, const label number
)
{
    if (number != c.size())
    {
        FatalErrorInFunction
            << file.objectPath() << ": " << number << " entries for "
            << c.size() << " clumps" << exit(FatalError);
    }
}

template<class Type>
Field<Type> readValues(const Cloud<clumpParcel>& c, const word& name)
{
    const IOField<Type> field
    (
        c.fieldIOobject(name, IOobject::MUST_READ), c.size() > 0
    );
    checkNumber(c, field, field.size());
    return field;
}

//- Lists as long as the clump's own, which they replace; some may be empty
template<class Type, class Getter>
void readLists
(
    Cloud<clumpParcel>& c,
    const word& name,
    const Getter& own,
    const bool mayBeEmpty = false
)
{
    const compactFieldReader<Type> file
    (
        c.fieldIOobject(name, IOobject::MUST_READ), c.size() > 0
    );
    checkNumber(c, file, file.lists().size());

    label i = 0;
    for (clumpParcel& p : c)
    {
        const Field<Type>& list = file.lists()[i++];
        Field<Type>& field = own(p);

        if (list.size() != field.size() && !(mayBeEmpty && list.empty()))
        {
            refuse
            (
                c, name, p,
                "has " + Foam::name(list.size()) + " values, its type "
              + Foam::name(field.size())
            );
        }
        for (const Type& value : list)
        {
            if (!physical(value))
            {
                refuse(c, name, p, "has a value beyond every physical quantity");
            }
        }
        field = list;
    }
}

//- OpenFOAM's clouds do not ask whether their files are written
void writeFile(const regIOobject& file, const bool valid)
{
    if (!file.write(valid))
    {
        FatalErrorInFunction
            << "cannot write " << file.objectPath() << exit(FatalError);
    }
}

template<class Type, class Getter>
void writeLists(const Cloud<clumpParcel>& c, const word& name, const Getter& get)
{
    typename compactLists<Type>::type lists
    (
        c.fieldIOobject(name, IOobject::NO_READ), c.size()
    );

    label i = 0;
    for (const clumpParcel& p : c)
    {
        lists[i++] = get(p);
    }

    writeFile(lists, c.size() > 0);
}

}


void Foam::clumpParcel::readFields(Cloud<clumpParcel>& c)
{
    // What is too large for the machine becomes infinite, and is refused here
    const anyNumber overflow;

    // Before OpenFOAM reads and takes them as they are
    label i = 0;
    for (const clumpParcel& p : c)
    {
        checkPlace(c, i++, p);
    }
    readValues<label>(c, "origProcId");
    readValues<label>(c, "origId");

    particle::readFields(c);

    // At rest first: the lists of a type have their lengths
    const auto& cloud = dynamic_cast<const deformableCloud&>(c);
    const labelField typeIds(readValues<label>(c, "typeId"));
    const scalarField exchange(readValues<scalar>(c, "exchangeFactor"));
    const labelField overshoots(readValues<label>(c, "exchangeOvershoots"));
    i = 0;
    for (clumpParcel& p : c)
    {
        p.typeId_ = typeIds[i];
        if (p.typeId_ < 0 || p.typeId_ >= cloud.types().size())
        {
            refuse
            (
                c, "typeId", p,
                "has the type " + Foam::name(p.typeId_) + ", the types are 0 to "
              + Foam::name(cloud.types().size() - 1)
            );
        }
        p.state_ = clumpState(cloud.type(p));
        p.state_.broken.setSize(cloud.type(p).pairs().size(), 0);
        p.state_.exchange = exchange[i];
        p.state_.overshoots = overshoots[i];
        ++i;
        if (!(physical(p.state_.exchange) && p.state_.exchange >= 1))
        {
            refuse(c, "exchangeFactor", p, "has a factor that is not 1 or above");
        }
        p.fluidForces_ = vectorField(p.state_.x.size(), Zero);
        p.fluidTorques_ = p.fluidForces_;
    }

    readLists<vector>
    (
        c, "centres", [](clumpParcel& p) -> vectorField& { return p.state_.x; }
    );
    for (const listField& field : listFields)
    {
        readLists<vector>
        (
            c, field.name,
            [&](clumpParcel& p) -> vectorField&
            {
                return p.state_.*(field.member);
            }
        );
    }
    readLists<vector>
    (
        c, "hydrodynamicForces",
        [](clumpParcel& p) -> vectorField& { return p.fluidForces_; }
    );
    readLists<vector>
    (
        c, "hydrodynamicTorques",
        [](clumpParcel& p) -> vectorField& { return p.fluidTorques_; }
    );
    readLists<scalar>
    (
        c, "brokenBonds",
        [](clumpParcel& p) -> scalarField& { return p.state_.broken; },
        true
    );

    // Four numbers a sphere
    List<scalarField> quaternions(c.size());
    i = 0;
    for (const clumpParcel& p : c)
    {
        quaternions[i++].setSize(4*p.state_.q.size());
    }
    i = 0;
    readLists<scalar>
    (
        c, "orientations",
        [&](clumpParcel&) -> scalarField& { return quaternions[i++]; }
    );
    i = 0;
    for (clumpParcel& p : c)
    {
        const scalarField& f = quaternions[i++];
        forAll(p.state_.q, k)
        {
            p.state_.q[k] = quaternion
            (
                f[4*k], vector(f[4*k + 1], f[4*k + 2], f[4*k + 3])
            );
            if (mag(mag(p.state_.q[k]) - 1) > 1e-3)
            {
                refuse
                (
                    c, "orientations", p, "has one that is no rotation"
                );
            }
        }
    }
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
    IOField<label> overshoots
    (
        c.fieldIOobject("exchangeOvershoots", IOobject::NO_READ), c.size()
    );

    const auto& cloud = dynamic_cast<const deformableCloud&>(c);
    label i = 0;
    for (const clumpParcel& p : c)
    {
        typeIds[i] = p.typeId_;
        U[i] = p.state_.velocity(cloud.type(p));
        exchange[i] = p.state_.exchange;
        overshoots[i] = p.state_.overshoots;
        ++i;
    }
    writeFile(typeIds, valid);
    writeFile(U, valid);
    writeFile(exchange, valid);
    writeFile(overshoots, valid);

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
