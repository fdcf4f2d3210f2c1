/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "bondForces.H"
#include "clumpContacts.H"
#include "clumpPieces.H"

using namespace Foam;

namespace
{

//- A ring of eight overlapping spheres that stands for something larger
dictionary ringDict()
{
    dictionary dict(cellDict("type dampingRatio; beta 1500;", "type elastic;", 8));
    dict.set("nominalVolume", 9e-17);
    return dict;
}

//- Disturbed, with the bonds that join the spheres 1 and 2, and 6 and 7, broken
clumpState brokenState(const clumpType& type, Random& random)
{
    clumpState s(type, randomRotation(random));
    disturb(type, s, 0.2, random);
    s.broken = scalarField(type.pairs().size(), Zero);
    forAll(type.pairs(), b)
    {
        const labelPair sorted
        (
            min(type.pairs()[b].first(), type.pairs()[b].second()),
            max(type.pairs()[b].first(), type.pairs()[b].second())
        );
        s.broken[b] = sorted == labelPair(1, 2) || sorted == labelPair(6, 7);
    }
    return s;
}

}


TEST_CASE("pieces: together they have what the clump had", "[pieces][serial]")
{
    const clumpType type("ring", ringDict());
    Random random(3);
    const clumpState s(brokenState(type, random));
    const clumpPieces pieces(type, s);
    REQUIRE(pieces.size() == 2);

    scalar mass = 0;
    scalar volume = 0;
    scalar nominal = 0;
    scalar part = 0;
    vector momentum(Zero);
    vector angular(Zero);
    for (label n = 0; n < 2; ++n)
    {
        const clumpType piece(type, 0, pieces[n]);
        const clumpState p(s.part(pieces[n], piece.bondsOf(type)));
        CHECK(piece.name() == (n ? "ring.2-6" : "ring.0-1+7"));
        CHECK(piece.family() == "ring");
        CHECK(mag(sum(piece.masses()*piece.centres())) < 1e-12*piece.mass()*piece.reach());

        mass += piece.mass();
        volume += piece.volume();
        nominal += piece.nominalVolume();
        part += piece.part();
        momentum += piece.mass()*p.velocity(piece);
        angular +=
            p.angularMomentum(piece)
          + (p.centre(piece) ^ (piece.mass()*p.velocity(piece)));
        CHECK(p.broken.empty());
    }
    CHECK(mass == Approx(type.mass()).epsilon(1e-14));
    CHECK(volume == Approx(type.volume()).epsilon(1e-14));
    CHECK(nominal == Approx(9e-17).epsilon(1e-14));
    CHECK(part == Approx(1).epsilon(1e-14));
    CHECK(mag(momentum - type.mass()*s.velocity(type)) < 1e-14*mag(momentum));
    const vector L
    (
        s.angularMomentum(type)
      + (s.centre(type) ^ (type.mass()*s.velocity(type)))
    );
    CHECK(mag(angular - L) < 1e-13*mag(L));
}


TEST_CASE("pieces: bonds have the forces that they had", "[pieces][serial]")
{
    const bondedClump ring("ring", ringDict());
    Random random(4);
    const clumpState s(brokenState(ring.type, random));
    vectorField F(8), T(8);
    const scalar energy = bondForces(ring.bonds, s).explicitForces(s, F, T);

    const clumpPieces pieces(ring.type, s);
    scalar ofPieces = 0;
    for (label n = 0; n < pieces.size(); ++n)
    {
        const clumpType type(ring.type, 0, pieces[n]);
        const clumpBonds bonds(type, ring.bonds);
        const clumpState p(s.part(pieces[n], type.bondsOf(ring.type)));
        vectorField f(type.size()), t(type.size());
        ofPieces += bondForces(bonds, p).explicitForces(p, f, t);
        forAll(f, i)
        {
            CHECK(mag(f[i] - F[pieces[n][i]]) <= 1e-14*max(mag(F)));
            CHECK(mag(t[i] - T[pieces[n][i]]) <= 1e-14*max(mag(T)));
        }
    }
    CHECK(ofPieces == Approx(energy).epsilon(1e-14));
}


TEST_CASE("pieces: pieces of pieces are those of the whole clump", "[pieces][serial]")
{
    PtrList<clumpType> types;
    types.append(new clumpType("ring", ringDict()));
    const clumpType arc(types[0], 0, labelList({2, 3, 4, 5, 6}));
    const clumpType end(types[0], 0, labelList({5, 6}));

    CHECK(end.whole(7) == 0);
    CHECK(types[0].whole(0) == 0);
    CHECK(arc.sphere(5) == 3);
    CHECK(arc.sphere(1) == -1);
    CHECK(types[0].sphere(5) == 5);

    // Of the bonds of the arc, the one of spheres 5 and 6
    const labelList kept(end.bondsOf(arc));
    REQUIRE(kept.size() == 1);
    CHECK(arc.pairs()[kept[0]] == labelPair(3, 4));
    CHECK(end.pairs() == List<labelPair>(1, labelPair(0, 1)));
}


TEST_CASE("pieces: they touch where they were joined", "[pieces][serial]")
{
    PtrList<clumpType> types;
    types.append(new clumpType("ring", ringDict()));
    types.append(new clumpType(types[0], 0, labelList({0, 1, 7})));
    types.append(new clumpType(types[0], 0, labelList({2, 3, 4, 5, 6})));
    const clumpContacts contacts
    (
        types, dictOf("contactModel { type hertz; reducedModulus 100; restitution 1; }")
    );
    clumpImage A, B;
    A.typeId = 1;
    A.id = labelPair(0, 3);
    A.pieceOf = 3;
    B.typeId = 2;
    B.id = labelPair(0, 4);
    B.pieceOf = 3;

    // Spheres 1 and 2 were bonded, 0 and 4 are on opposite sides
    const pointField& c = types[0].centres();
    const scalar r = types[0].radii()[0];
    REQUIRE(mag(c[1] - c[2]) < 2*r);
    CHECK(contacts.distance(A, 1, B, 0) == Approx(mag(c[1] - c[2])).epsilon(1e-14));
    CHECK(contacts.distance(B, 0, A, 1) == contacts.distance(A, 1, B, 0));
    CHECK(contacts.distance(A, 0, B, 2) == Approx(min(2*r, mag(c[0] - c[4]))));

    // Of another clump, and a piece with its own periodic image
    B.pieceOf = 5;
    CHECK(contacts.distance(A, 1, B, 0) == 2*r);
    CHECK(contacts.distance(A, 1, A, 1) == 2*r);
}
