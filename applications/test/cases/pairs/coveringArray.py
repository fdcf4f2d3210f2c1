"""Rows in which every pair of levels of two factors occurs that some row can have.

factors: {factor: [level, ...]}; forbidden: [({factor: levels, ...}, reason), ...]: no row has a
level of each of these sets. The same factors give the same rows, and
the first ones cover the most pairs.
"""

import random
from itertools import combinations

TRIES = 40          # candidates for each row, of which the one with most new pairs is taken


class CoveringArray:
    def __init__(self, factors, forbidden):
        self.factors = factors
        self.forbidden = [sets for sets, _ in forbidden]
        self.of = {factor: [sets for sets in self.forbidden if factor in sets]
                   for factor in factors}
        self.feasible = {
            pair for a, b in combinations(factors, 2) for x in factors[a] for y in factors[b]
            for pair in [((a, x), (b, y))]
            if self.allowed(dict(pair)) and self.complete(dict(pair)) is not None}
        self.rows = []
        self.fill(random.Random(1))

    def allowed(self, row):
        return not any(all(row.get(factor) in levels for factor, levels in sets.items())
                       for sets in self.forbidden)

    def fits(self, row, factor, level):
        """Whether an allowed row can have this level, too"""
        return not any(level in sets[factor] and all(
            row.get(other) in levels for other, levels in sets.items() if other != factor)
            for sets in self.of[factor])

    def complete(self, row, order=None, choose=None):
        """The first row that has these levels, which are allowed, in this order of the factors;
        None without one."""
        rest = [factor for factor in order or self.factors if factor not in row]
        if not rest:
            return row
        # A factor for which no level is left ends the search at once
        if not all(any(self.fits(row, factor, level) for level in self.factors[factor])
                   for factor in rest):
            return None
        levels = self.factors[rest[0]]
        for level in choose(row, rest[0], levels) if choose else levels:
            if self.fits(row, rest[0], level):
                found = self.complete({**row, rest[0]: level}, rest[1:], choose)
                if found is not None:
                    return found
        return None

    def pairs(self, row):
        names = [factor for factor in self.factors if factor in row]
        return {((a, row[a]), (b, row[b])) for a, b in combinations(names, 2)}

    def fill(self, rng):
        left = set(self.feasible)
        place = {factor: i for i, factor in enumerate(self.factors)}

        def pairs(row, factor, level):
            """The pairs of a level with those of a row."""
            own = factor, level
            return [(own, other) if place[factor] < place[other[0]] else (other, own)
                    for other in row.items()]

        def choose(row, factor, levels):
            """The level that covers most first; at random where they cover as many. No row has a
            level that forms a pair which no row can have."""
            found = [(pairs(row, factor, level), rng.random(), level) for level in levels]
            found = [(-len(left.intersection(new)), chance, level) for new, chance, level in found
                     if self.feasible.issuperset(new)]
            return [level for _, _, level in sorted(found)]

        while left:
            best = None
            for _ in range(TRIES):
                order = list(self.factors)
                rng.shuffle(order)
                row = self.complete(dict(rng.choice(sorted(left))), order, choose)
                if best is None or len(self.pairs(row) & left) > len(self.pairs(best) & left):
                    best = row
            left -= self.pairs(best)
            self.rows.append({factor: best[factor] for factor in self.factors})
