/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "clumpFields.H"
#include "ignoreOverflow.H"
#include "Cloud.H"
#include "compactFieldReader.H"
#include "compactFieldWriter.H"
#include "foamCompat.H"
#include "HashSet.H"
#include "labelPair.H"
#include "OSspecific.H"

namespace
{

using namespace Foam;

//- Where the vector lists of a clump stand on disk, and in the state
struct listField
{
    const char* name;
    vectorField clumpState::* member;
    bool mayBeEmpty;
};

const listField listFields[] =
{
    {"velocities", &clumpState::u, false},
    {"angularVelocities", &clumpState::w, false},
    {"accelerations", &clumpState::a, false},
    {"angularAccelerations", &clumpState::b, false},
    {"nodeForces", &clumpState::nodeForces, true},
    {"nodeForceRates", &clumpState::nodeForceRates, true}
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
        << fieldObject(c, name, IOobject::NO_READ).objectPath()
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
            << fieldObject(c, "coordinates", IOobject::NO_READ).objectPath()
            << ": clump " << index << " lies outside the mesh," << nl
            << "    or the mesh has changed since the file was written:"
            << " then run setClumps again." << exit(FatalError);
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
            << file.objectPath() << ": the file has " << number
            << " entries, but there are " << c.size() << " clumps"
            << exit(FatalError);
    }
}

template<class Type>
Field<Type> readValues(const Cloud<clumpParcel>& c, const word& name)
{
    const IOField<Type> field
    (
        fieldObject(c, name, IOobject::MUST_READ), c.size() > 0
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
        fieldObject(c, name, IOobject::MUST_READ), c.size() > 0
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
                "has " + Foam::name(list.size()) + " values; its type "
              + Foam::name(field.size())
            );
        }
        for (const Type& value : list)
        {
            if (!physical(value))
            {
                refuse(c, name, p, "has a value outside the physical range");
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
    compactFieldWriter<Type> file(fieldObject(c, name, IOobject::NO_READ));
    for (const clumpParcel& p : c)
    {
        file.append(get(p));
    }
    writeFile(file, c.size() > 0);
}

}


const Foam::clumpFields::vectorFile Foam::clumpFields::vectorFiles_[6] =
{
    {"offset", &clumpParcel::offset_, false},
    {"sinceMet", &clumpParcel::sinceMet_, false},
    {"acceleration", &clumpParcel::acceleration_, false},
    {"accelerationBefore", &clumpParcel::accelerationBefore_, false},
    {"surfaceForce", &clumpParcel::surfaceForce_, true},
    {"surfaceTorque", &clumpParcel::surfaceTorque_, true}
};


void Foam::clumpFields::checkNumbers(const Cloud<clumpParcel>& c)
{
    List<labelPairList> ids(Pstream::nProcs());
    labelPairList& mine = ids[Pstream::myProcNo()];
    for (const clumpParcel& p : c)
    {
        mine.append(labelPair(p.origProc(), p.origId()));
    }
    Pstream::gatherList(ids);

    HashSet<labelPair, Hash<labelPair>> seen;
    for (const labelPairList& part : ids)
    {
        for (const labelPair& id : part)
        {
            if (!seen.insert(id))
            {
                FatalErrorInFunction
                    << fieldObject(c, "origId", IOobject::NO_READ).objectPath()
                    << ": two clumps have the number " << id.second()
                    << " (origProcId " << id.first() << ')'
                    << exit(FatalError);
            }
        }
    }
}


void Foam::clumpFields::refuseRemains(const Cloud<clumpParcel>& c)
{
    const Time& time = c.time();
    const IOobject written(fieldObject(c, "typeId", IOobject::NO_READ));
    if (returnReduce(isFile(written.objectPath()), orOp<bool>()))
    {
        FatalErrorInFunction
            << written.path() << " contains clumps, but the file coordinates with their"
            << " positions, is missing or cannot be read" << exit(FatalError);
    }

    // A run that had clumps wrote both; after setClumps there is no state
    const fileName uniform(time.timePath()/"uniform");
    const bool had =
        isFile(uniform/"time")
     && isFile(uniform/cloud::prefix/c.name()/"cloudProperties");
    if (returnReduce(had, orOp<bool>()))
    {
        FatalErrorInFunction
            << "The run that wrote " << time.timePath()
            << " had clumps, but " << written.path() << " contains none." << nl
            << "    To place them anew, remove " << uniform/cloud::prefix
            << exit(FatalError);
    }
}


void Foam::clumpFields::readTypes
(
    Cloud<clumpParcel>& c,
    const PtrList<clumpType>& types,
    const writtenTypes& written
)
{
    // At rest first: the lists of a type have their lengths
    const labelList typeIds
    (
        written.present(readValues<label>(c, "typeId"))
    );
    const IOField<label> pieces
    (
        fieldObject(c, "pieceOf", IOobject::READ_IF_PRESENT), c.size() > 0
    );
    if (pieces.size())
    {
        checkNumber(c, pieces, pieces.size());
    }
    const scalarField factors(readValues<scalar>(c, "couplingFactor"));
    const labelField overshoots(readValues<label>(c, "couplingOvershoots"));
    label i = 0;
    for (clumpParcel& p : c)
    {
        p.typeId_ = typeIds[i];
        if (p.typeId_ < 0 || p.typeId_ >= types.size())
        {
            refuse
            (
                c, "typeId", p,
                "has the type " + Foam::name(p.typeId_) + "; the types are 0 to "
              + Foam::name(types.size() - 1)
            );
        }
        const clumpType& type = types[p.typeId_];
        p.pieceOf_ = pieces.size() ? pieces[i] : -1;
        p.state_ = clumpState(type);
        p.state_.broken.setSize(type.pairs().size(), 0);
        if (!type.ofSpheres())
        {
            p.state_.nodeForces.setSize(type.size(), Zero);
            p.state_.nodeForceRates.setSize(type.size(), Zero);
        }
        p.couplingFactor_ = factors[i];
        p.overshoots_ = overshoots[i];
        ++i;
        if (!(physical(p.couplingFactor_) && p.couplingFactor_ >= 1))
        {
            refuse(c, "couplingFactor", p, "has a factor that is not 1 or above");
        }
        p.fluidForces_ = vectorField(p.state_.x.size(), Zero);
        p.fluidTorques_ = p.fluidForces_;
    }
}


void Foam::clumpFields::readOrientations(Cloud<clumpParcel>& c)
{
    // Four numbers a sphere
    List<scalarField> quaternions(c.size());
    label i = 0;
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


void Foam::clumpFields::read
(
    Cloud<clumpParcel>& c,
    const PtrList<clumpType>& types,
    const writtenTypes& written
)
{
    // What is too large for the machine becomes infinite, and is refused here
    const ignoreOverflow overflow;

    // Before OpenFOAM reads and takes them as they are
    label i = 0;
    for (const clumpParcel& p : c)
    {
        checkPlace(c, i++, p);
    }
    readValues<label>(c, "origProcId");
    readValues<label>(c, "origId");

    particle::readFields(c);

    readTypes(c, types, written);
    bool ofEarlierVersion = false;
    for (const vectorFile& file : vectorFiles_)
    {
        const IOField<vector> values
        (
            fieldObject
            (
                c, file.name,
                file.mayBeAbsent ? IOobject::READ_IF_PRESENT : IOobject::MUST_READ
            ),
            c.size() > 0
        );
        if (file.mayBeAbsent && values.empty())
        {
            ofEarlierVersion = true;
            continue;
        }
        checkNumber(c, values, values.size());
        i = 0;
        for (clumpParcel& p : c)
        {
            p.*(file.member) = values[i++];
            if (!physical(p.*(file.member)))
            {
                refuse(c, file.name, p, "has a value outside the physical range");
            }
        }
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
            },
            field.mayBeEmpty
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
    if (ofEarlierVersion)
    {
        // There is nothing better: with the inertia of the fluid inside
        for (clumpParcel& p : c)
        {
            const point centre(p.state_.centre(types[p.typeId_]));
            p.surfaceForce_ = sum(p.fluidForces_);
            p.surfaceTorque_ = sum(p.fluidTorques_);
            forAll(p.fluidForces_, k)
            {
                p.surfaceTorque_ += (p.state_.x[k] - centre) ^ p.fluidForces_[k];
            }
        }
    }
    readLists<scalar>
    (
        c, "brokenBonds",
        [](clumpParcel& p) -> scalarField& { return p.state_.broken; },
        true
    );

    readOrientations(c);
    checkNumbers(c);
}


void Foam::clumpFields::writeTypes
(
    const Cloud<clumpParcel>& c,
    const PtrList<clumpType>& types
)
{
    const bool valid = c.size() > 0;

    IOField<label> typeIds
    (
        fieldObject(c, "typeId", IOobject::NO_READ), c.size()
    );
    IOField<label> pieces(fieldObject(c, "pieceOf", IOobject::NO_READ), c.size());
    IOField<vector> U(fieldObject(c, "U", IOobject::NO_READ), c.size());
    IOField<scalar> factors
    (
        fieldObject(c, "couplingFactor", IOobject::NO_READ), c.size()
    );
    IOField<label> overshoots
    (
        fieldObject(c, "couplingOvershoots", IOobject::NO_READ), c.size()
    );

    label i = 0;
    for (const clumpParcel& p : c)
    {
        typeIds[i] = p.typeId_;
        pieces[i] = p.pieceOf_;
        U[i] = p.state_.velocity(types[p.typeId_]);
        factors[i] = p.couplingFactor_;
        overshoots[i] = p.overshoots_;
        ++i;
    }
    writeFile(typeIds, valid);
    writeFile(pieces, valid);
    writeFile(U, valid);
    writeFile(factors, valid);
    writeFile(overshoots, valid);
}


void Foam::clumpFields::write
(
    const Cloud<clumpParcel>& c,
    const PtrList<clumpType>& types
)
{
    particle::writeFields(c);

    writeTypes(c, types);

    const bool valid = c.size() > 0;
    for (const vectorFile& file : vectorFiles_)
    {
        IOField<vector> values
        (
            fieldObject(c, file.name, IOobject::NO_READ), c.size()
        );
        label i = 0;
        for (const clumpParcel& p : c)
        {
            values[i++] = p.*(file.member);
        }
        writeFile(values, valid);
    }

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
