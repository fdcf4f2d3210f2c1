/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "remoteClumps.H"
#include "Map.H"

void Foam::remoteClumps::find
(
    const ghostExchange& ghosts,
    const label nOwn,
    const UList<bool>& used
)
{
    neighbours_ = ghosts.neighbours();
    wanted_.setSize(neighbours_.size());
    nAsked_.setSize(neighbours_.size());
    nOwn_ = nOwn;
    nClumps_ = nOwn_;

    const UList<clumpImage>& images = ghosts.images();
    localIndices_ = labelList(images.size(), -1);
    forAll(images, b)
    {
        if (images[b].owner == Pstream::myProcNo())
        {
            localIndices_[b] = images[b].index;
        }
    }
    sentMessages messages(neighbours_.size());
    forAll(neighbours_, n)
    {
        Map<label> known;
        DynamicList<label> asked;
        forAll(images, b)
        {
            const label index = images[b].index;
            if (used[b] && images[b].owner == neighbours_[n])
            {
                if (known.insert(index, nClumps_))
                {
                    asked.append(index);
                    ++nClumps_;
                }
                localIndices_[b] = known[index];
            }
        }
        nAsked_[n] = asked.size();
        sentMessages::stream os(messages, n, neighbours_[n]);
        os << labelList(asked);
    }
    forAll(neighbours_, n)
    {
        IPstream is(UPstream::commsTypes::blocking, neighbours_[n]);
        is >> wanted_[n];
    }
}
