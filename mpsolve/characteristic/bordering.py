"""The characteristic matrix [[S, −B], [Bᵀ, G + diag h]]: what stands in which entry, once for every arithmetic.

Direct contacts, tight and alone on a body with no other contact, are eliminated: y = −(Gλ)/b there. In the full
matrix (row of the contact, column of the body) holds b, alone in its row among the bodies; column operations clear
the rest of the row, so the determinants differ by the factor ±b. Rows: all bodies, then the contacts that are not
direct; columns: the bodies that are left, then λ.

An entry is a sum of terms f, g and f·g: f a polynomial in σ (and in free parameters), g a receptance, or what a wave
is at a contact. So `matrix` needs no more of an arithmetic than arrays with + and ×, and slopes are its product rule.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property, partial
from typing import Any

import numpy as np

from mpsolve.frozen import frozen
from mpsolve.numbers.arithmetic import Arithmetic
from mpsolve.numbers.several import Several
from mpsolve.problem.family import Family
from mpsolve.problem.reduced import Reduced

Term = tuple[Any, int | None]
"""A polynomial (its coefficients in σ) or None, and the number of a g or None: their product."""
Joined = Callable[[Sequence[Any]], Any]
arrays_joined = partial(np.concatenate, axis=-1)


def distances_of(
    places: Sequence[Any], others: Sequence[Any] | None = None
) -> tuple[Any, tuple[tuple[int, ...], ...]]:
    """(the different x − y of places x and y, ascending; of each pair the number of its own). others: the y."""
    apart = [[x - y for y in (places if others is None else others)] for x in places]
    distances = sorted({x for row in apart for x in row})
    number = {x: k for k, x in enumerate(distances)}
    return tuple(distances), tuple(tuple(number[x] for x in row) for row in apart)


@frozen
class Direct:
    """Contact `contact` moves with body `body` alone: Bᵀ has the single entry `b` there."""

    body: int
    contact: int
    b: Any


def direct_contacts(given: Reduced | Family) -> tuple[Direct, ...]:
    """The contacts that are tight and alone on a body that has no other contact, where b is a constant."""
    out = []
    for j, h in enumerate(given.h):
        bodies = [i for i, row in enumerate(given.B) if row[j]]
        if not h and len(bodies) == 1 and sum(map(bool, given.B[bodies[0]])) == 1:
            b = given.B[bodies[0]][j]
            if not isinstance(b, Several) or not any(any(e) for e, _ in b):
                out.append(Direct(bodies[0], j, b))
    return tuple(out)


@frozen
class Bordering:
    """The vehicle's part of the matrix, and which receptance stands in which entry; all exact.

    polynomials: the different f; the first is 0. distances: the different ξ_i − ξ_j of contacts, the first of the g.
    Behind them stand those of `waves` further unknowns μ, which have the last columns and rows: μ_k at contact i in
    the place of G (wave by wave), what λ_j does to μ_k, and μ_l to μ_k. cells: the terms of each entry.
    """

    polynomials: tuple[Any, ...]
    distances: tuple[Any, ...]
    which: tuple[tuple[int, ...], ...]
    direct: tuple[Direct, ...]
    kept: tuple[int, ...]
    waves: int
    cells: tuple[tuple[tuple[tuple[int | None, int | None], ...], ...], ...]

    @staticmethod
    def of(given: Reduced | Family, eliminate: bool = True, push: Any = None, waves: int = 0) -> Bordering:
        """push: B in the rows of bodies, where those are scaled; as it is if left out."""
        places = [given.places[k] for k in given.index]
        distances, which = distances_of(places)
        direct = direct_contacts(given) if eliminate else ()
        gone = {d.body for d in direct}
        kept = tuple(i for i in range(len(given.B)) if i not in gone)
        found: dict[Any, int] = {(places[0] * 0,): 0}
        rows = [
            tuple(tuple((f and found.setdefault(f, len(found)), g) for f, g in cell) for cell in row)
            for row in _rows(given, (direct, kept), push or given.B, which, waves)
        ]
        return Bordering(tuple(found), distances, which, direct, kept, waves, tuple(rows))

    @cached_property
    def signs(self) -> list[int]:
        """Of the distances; where the contacts keep their order they are the same for all values of parameters."""
        return [(x > 0) - (x < 0) for x in self.distances]

    @cached_property
    def one_each(self) -> tuple[list[int], list[int]]:
        """Two contacts for each distance."""
        found = {k: (i, j) for i, row in enumerate(self.which) for j, k in enumerate(row)}
        first, second = zip(*(found[k] for k in range(len(self.distances))), strict=True)
        return list(first), list(second)

    @cached_property
    def _plan(self) -> tuple[Any, ...]:
        """Numbers of f, of g, of f and g of products that stand in entries; of sums, by layers, their terms among
        these, one behind the other; and each entry's own among these and the sums."""
        zero = (0, None)
        cells = dict.fromkeys(cell or (zero,) for row in self.cells for cell in row)
        terms = sorted(dict.fromkeys([zero, *(term for cell in cells for term in cell)]), key=_kind)
        own = {term: k for k, term in enumerate(terms)}
        sums = [cell for cell in cells if len(cell) > 1]
        place = {cell: own[cell[0]] for cell in cells} | {cell: len(own) + k for k, cell in enumerate(sums)}
        where = [[place[cell or (zero,)] for cell in row] for row in self.cells]
        deepest = max(map(len, sums), default=0)
        layers = [[own[cell[n] if n < len(cell) else zero] for cell in sums] for n in range(deepest)]
        columns = [[term[k] for term in terms if _kind(term) == kind] for kind, k in ((0, 0), (1, 1), (2, 0), (2, 1))]
        return *(np.array(numbers, int) for numbers in columns), np.array(layers, int), np.array(where, int)

    def matrix(self, f: Any, g: Any, joined: Joined = arrays_joined) -> Any:
        """A from the values of the polynomials and of the g along the last axis: shape (…, rows, columns)."""
        _, _, factors, waves, *_ = self._plan
        return self._filled(f, g, _taken(f, factors) * _taken(g, waves), joined)

    def slope(self, f: Any, g: Any, f_slope: Any, g_slope: Any, joined: Joined = arrays_joined) -> Any:
        """The slope of A in anything, from those of the f and the g."""
        _, _, factors, waves, *_ = self._plan
        products = _taken(f, factors) * _taken(g_slope, waves) + _taken(f_slope, factors) * _taken(g, waves)
        return self._filled(f_slope, g_slope, products, joined)

    def _filled(self, f: Any, g: Any, products: Any, joined: Joined) -> Any:
        alone, received, _, _, layers, where = self._plan
        terms = joined([_taken(f, alone), _taken(g, received), products])
        if len(layers):
            total = _taken(terms, layers[0])
            for layer in layers[1:]:
                total = total + _taken(terms, layer)
            terms = joined([terms, total])
        return _taken(terms, where)

    def at(self, K: Arithmetic, sigma: Any, g: Sequence[Any]) -> Any:
        """The matrix A(σ) of an arithmetic."""
        return K.matrix(self.matrix(_values(K, sigma, self.polynomials), vector(g)))

    def slope_at(self, K: Arithmetic, sigma: Any, g: Sequence[Any], g_slope: Sequence[Any]) -> Any:
        """A'(σ)."""
        f, f_slope = (_values(K, sigma, rows) for rows in (self.polynomials, self._rates))
        return K.matrix(self.slope(f, vector(g), f_slope, vector(g_slope)))

    @cached_property
    def _rates(self) -> list[tuple[Fraction, ...]]:
        return [tuple(k * c for k, c in enumerate(row))[1:] or (Fraction(0),) for row in self.polynomials]


def _kind(term: tuple[int | None, int | None]) -> int:
    """0: f alone, 1: g alone, 2: a product."""
    return 0 if term[1] is None else 1 if term[0] is None else 2


def _taken(x: Any, numbers: Any) -> Any:
    """Along the last axis; unlike x[..., numbers] in the order in which what follows is quick."""
    return np.take(x, numbers, -1) if isinstance(x, np.ndarray) else x.taken(numbers)


def _values(K: Arithmetic, sigma: Any, rows: Sequence[Sequence[Fraction]]) -> Any:
    return vector([K.evaluate(row, sigma) for row in rows])


def vector(scalars: Sequence[Any]) -> Any:
    """An array of scalars of any kind."""
    return np.fromiter(scalars, object, len(scalars))


def _rows(given: Any, bodies: Any, push: Any, which: Any, waves: int) -> Iterator[list[list[Term]]]:
    """The terms of the entries, row by row."""
    (direct, kept), contacts = bodies, range(len(which))
    first = 1 + max(map(max, which))

    def received(i: int) -> list[int]:
        """G between contact i and each, and the waves there."""
        return [*which[i], *(first + k * len(which) + i for k in range(waves))]

    for i, loads in enumerate(push):
        pencil = [[rows[i][j] for rows in given.S] for j in range(len(push))]
        row = (
            [_alone(*pencil[j]) for j in kept] + [_alone(-x if x else x) for x in loads] + [[] for _ in range(waves)]
        )
        for one in direct:
            for f, _ in _alone(*(-x / one.b if x else x for x in pencil[one.body])):
                for cell, g in zip(row[len(kept) :], received(one.contact), strict=True):
                    cell.append((f, g))
        yield row
    for i in contacts:
        if i not in {one.contact for one in direct}:
            row = [_alone(given.B[j][i]) for j in kept] + [[(None, g)] for g in received(i)]
            row[len(kept) + i] += _alone(given.h[i])
            yield row
    for k in range(waves):
        back = first + (waves + k) * len(which)
        corner = first + 2 * waves * len(which) + k * waves
        yield [[]] * len(kept) + [[(None, back + j)] for j in contacts] + [[(None, corner + j)] for j in range(waves)]


def _alone(*coefficients: Any) -> list[Term]:
    """The terms of an entry that is a polynomial in σ: one, without powers that are not there, or none."""
    last = max((k for k, c in enumerate(coefficients) if c), default=None)
    return [] if last is None else [(coefficients[: last + 1], None)]
