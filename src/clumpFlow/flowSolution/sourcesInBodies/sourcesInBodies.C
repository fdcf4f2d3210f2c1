/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sourcesInBodies.H"

bool Foam::sourcesInBodies::resists(const fv::option& option)
{
    return option.type() == "explicitPorositySource";
}


void Foam::sourcesInBodies::remove
(
    PtrList<fv::option>& options,
    const volScalarField& lambda,
    fvVectorMatrix& sources
)
{
    const scalarField& part = lambda.primitiveField();
    const volVectorField& U = sources.psi();
    if (sources.hasDiag())
    {
        sources.diag() *= 1 - part;
    }
    for (fv::option& option : options)
    {
        const label fieldi = option.applyToField(U.name());
        if (fieldi >= 0 && option.isActive() && resists(option))
        {
            fvVectorMatrix matrix(U, sources.dimensions());
            option.addSup(matrix, fieldi);
            sources.source() -= part*matrix.source();
        }
    }
}


Foam::tmp<Foam::vectorField> Foam::sourcesInBodies::force
(
    fv::option& option,
    const label fieldi,
    const volVectorField& U,
    const volScalarField& lambda
)
{
    const scalarField& part = lambda.primitiveField();
    fvVectorMatrix matrix(U, U.dimensions()*dimVolume/dimTime);
    option.addSup(matrix, fieldi);
    tmp<vectorField> result(new vectorField(-matrix.source()));
    if (resists(option))
    {
        result.ref() *= 1 - part;
    }
    if (matrix.hasDiag())
    {
        result.ref() += (1 - part)*matrix.diag()*U.primitiveField();
    }
    return result;
}
