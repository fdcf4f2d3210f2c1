/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "mechanicalTest.H"

namespace Foam
{
    defineTypeNameAndDebug(mechanicalTest, 0);
    defineRunTimeSelectionTable(mechanicalTest, dictionary);
}
