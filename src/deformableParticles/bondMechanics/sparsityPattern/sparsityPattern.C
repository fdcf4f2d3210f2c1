/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sparsityPattern.H"
#include "DynamicList.H"
#include "HashSet.H"

Foam::sparsityPattern::sparsityPattern
(
    const label n,
    const UList<labelPair>& pairs
)
:
    start_(n + 1),
    pairBlock_(pairs.size())
{
    List<labelHashSet> rows(n);
    for (const labelPair& p : pairs)
    {
        rows[min(p.first(), p.second())].insert(max(p.first(), p.second()));
    }

    // Eliminating a column couples all its rows
    DynamicList<label> row;
    for (label j = 0; j < n; ++j)
    {
        const labelList below(rows[j].sortedToc());
        start_[j] = row.size();
        row.append(j);
        row.append(below);
        forAll(below, a)
        {
            for (label b = a + 1; b < below.size(); ++b)
            {
                rows[below[a]].insert(below[b]);
            }
        }
    }
    start_[n] = row.size();
    row_.transfer(row);

    forAll(pairs, k)
    {
        const labelPair& p = pairs[k];
        pairBlock_[k] =
            find(max(p.first(), p.second()), min(p.first(), p.second()));
    }

    DynamicList<label> target;
    for (label j = 0; j < n; ++j)
    {
        for (label b = start_[j] + 1; b < start_[j + 1]; ++b)
        {
            for (label a = b; a < start_[j + 1]; ++a)
            {
                target.append(find(row_[a], row_[b]));
            }
        }
    }
    target_.transfer(target);
}


Foam::label Foam::sparsityPattern::find(const label row, const label column) const
{
    label k = start_[column];
    while (row_[k] != row)
    {
        ++k;
    }
    return k;
}
