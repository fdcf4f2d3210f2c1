/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallMotion.H"
#include "fvMesh.H"

Foam::wallMotion::wallMotion(const fvPatchField<vector>& U)
{
    const scalar fastest = gMax(mag(U)());
    moves_ = fastest > 0;
    if (!moves_)
    {
        return;
    }
    const scalarField& A = U.patch().magSf();
    const scalar area = gSum(A);
    centre_ = gSum(A*U.patch().Cf())/area;
    u_ = gSum(A*U)/area;

    const vectorField x(U.patch().Cf() - centre_);
    const vector torque(gSum(A*(x ^ U)));
    const scalar sum = gSum(A*magSqr(x));
    if (sum > 0)
    {
        // A single face or a row of them does not tell its turn about the row
        const tensor J(sum*tensor::I - gSum(A*(x*x)));
        w_ = inv(J + 1e-12*sum*tensor::I) & torque;
        if (mag(w_)*Foam::sqrt(sum/area) < 1e-9*fastest)
        {
            // Rounding
            w_ = Zero;
        }
    }
    const scalar error = gMax(mag(u_ + (w_ ^ x) - U)());
    if (error > 0.01*fastest)
    {
        FatalErrorInFunction
            << "The wall patch " << U.patch().name() << " does not move as a rigid body:"
            << " its velocity differs from one by up to " << error << " m/s, "
            << label(100*error/fastest + 0.5) << " % of the largest." << nl
            << "    Friction and bonds need patches that translate and rotate as a whole."
            << " Divide the patch, or remove friction from it with an entry of 'pairs' in"
            << " wallContactModel, and laws of surfaceForces that form bonds."
            << exit(FatalError);
    }
}
