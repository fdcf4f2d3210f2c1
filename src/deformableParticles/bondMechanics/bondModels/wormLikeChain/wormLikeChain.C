/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wormLikeChain.H"

namespace Foam
{
namespace bondModels
{
    defineTypeNameAndDebug(wormLikeChain, 0);
    addToRunTimeSelectionTable(bondModel, wormLikeChain, dictionary);
}
}


Foam::bondModels::wormLikeChain::wormLikeChain(const dictionary& dict)
:
    bondModel(dict, {"restExtension"}),
    x0_(getBetween(dict, "restExtension", 0.001, 0.99))
{}


Foam::scalar Foam::bondModels::wormLikeChain::W(const scalar x)
{
    return 0.25/sqr(1 - x) - 0.25 + x;
}


Foam::scalar Foam::bondModels::wormLikeChain::slope(const scalar x)
{
    return 0.5/pow3(1 - x) + 1;
}


Foam::scalar Foam::bondModels::wormLikeChain::integral(const scalar x)
{
    return 0.25/(1 - x) - 0.25 - 0.25*x + 0.5*sqr(x);
}


Foam::bondModel::axialResponse Foam::bondModels::wormLikeChain::axial
(
    const scalar a,
    const scalar length,
    const scalar Kn
) const
{
    const scalar contour = length/x0_;
    const scalar A = Kn*contour/slope(x0_);
    const scalar x = (length + a)/contour;

    // The part of x within the range of the formula, and the part beyond
    const scalar y = min(max(x, 0), 0.99);
    const scalar z = x - y;

    return
    {
        A*(W(y) + slope(y)*z - W(x0_)),
        A*slope(y)/contour,
        A*contour
       *(
            integral(y) - integral(x0_) - W(x0_)*(x - x0_)
          + W(y)*z + 0.5*slope(y)*sqr(z)
        )
    };
}
