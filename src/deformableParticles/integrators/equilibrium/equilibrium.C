/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "equilibrium.H"
#include "newtonMinimiser.H"
#include "SortableList.H"

Foam::equilibrium::equilibrium
(
    const scalar tolerance,
    const label maxIterations
)
:
    tolerance_(tolerance),
    maxIterations_(maxIterations)
{}


bool Foam::equilibrium::find
(
    const clumpBonds& bonds,
    const externalForces& ext,
    clumpState& s
) const
{
    const clumpState start(s);
    const incrementalPotential potential(bonds, ext, 0, start);

    // Makes free rigid motions solvable and is small against any stiffness
    scalar shift = 0;
    for (const clumpBonds::bond& b : bonds.bonds())
    {
        shift = max(shift, 1e-8*b.stiffness.normal);
    }

    newtonMinimiser newton(tolerance_, maxIterations_);
    const bool found = newton.minimise(potential, s, shift);

    s.u = Zero;
    s.w = Zero;
    potential.forces().breakBonds(s);
    return found;
}


Foam::scalarField Foam::equilibrium::spectrum
(
    const clumpBonds& bonds,
    const externalForces& ext,
    const clumpState& s
)
{
    const clumpType& type = bonds.type();
    const incrementalPotential potential(bonds, ext, 0, s);
    const label n = 6*type.size();
    const scalar r = max(type.radii());
    const scalar h = 1e-5;
    Eigen::VectorXd gradient(n);
    Eigen::MatrixXd K(n, n);

    const auto gradientAt = [&](const label c, const scalar step)
    {
        clumpState moved(s);
        vector e(Zero);
        e[c % 3] = step;
        if (c % 6 < 3)
        {
            moved.x[c/6] += r*e;
        }
        else
        {
            moved.q[c/6] = rotation(e)*moved.q[c/6];
        }
        potential.value(moved, &gradient);
        for (label i = 0; i < type.size(); ++i)
        {
            gradient.segment<3>(6*i + 3) /= r;
        }
        return gradient;
    };

    // By differences, since some models give no complete tangent
    for (label c = 0; c < n; ++c)
    {
        K.col(c) = gradientAt(c, h);
        K.col(c) = (K.col(c) - gradientAt(c, -h)).eval()/(2*h*r);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver
    (
        0.5*(K + K.transpose())
    );

    scalarField result(n);
    forAll(result, i)
    {
        result[i] = solver.eigenvalues()[i];
    }
    return result;
}


Foam::externalForces Foam::equilibrium::stretch
(
    const clumpType& type,
    const vector& F,
    const scalar part
)
{
    externalForces ext(type.size());
    if (mag(F) < VSMALL)
    {
        return ext;
    }

    const scalarField along(type.centres() & (F/mag(F)));
    const scalar reach = max(mag(along));

    for (const scalar sign : {1.0, -1.0})
    {
        SortableList<scalar> outwards(sign*along);
        outwards.reverseSort();
        const label last = max(label(part*type.size() + 0.5), label(1)) - 1;
        labelList ends;
        forAll(along, i)
        {
            if (sign*along[i] > outwards[last] - 1e-6*reach)
            {
                ends.append(i);
            }
        }
        if (ends.empty() || reach <= 0)
        {
            FatalErrorInFunction
                << "Clump type " << type.name() << " cannot be stretched along "
                << F << ", because it has no extent in this direction."
                << exit(FatalError);
        }
        for (const label i : ends)
        {
            ext.f[i] += sign*F/ends.size();
        }
    }
    return ext;
}
