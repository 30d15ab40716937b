"""Δ̂ = det [[S, −B], [Bᵀ, Ĝ + diag ĥ]] and its slope in σ, over any arithmetic; and R·Δ̂ without division."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from mpsolve.characteristic.bordered import direct_contacts
from mpsolve.characteristic.receptance import at_matrix, by_companions, companion
from mpsolve.characteristic.splitting import Splitting
from mpsolve.characteristic.symbol import Symbols, product
from mpsolve.frozen import frozen
from mpsolve.numbers.arithmetic import Arithmetic
from mpsolve.problem.reduced import Reduced

Share = tuple[tuple[Fraction, ...], tuple[Fraction, ...]]
"""The coefficients of a share in σ, and of its slope."""


@frozen
class Bordering:
    """The vehicle's part of the matrix, and which distance stands in which entry.

    S[i][j]: the coefficients of that entry in σ. distances: the different ξ_i − ξ_j, exact; which[i][j] is the
    number of that of contacts i and j. direct: contacts (body, contact, b) that are tight and alone on a body with
    no other contact; their bodies are eliminated by y = −(Gλ)/b, which divides the determinant by ±b.
    """

    S: tuple[tuple[tuple[Fraction, ...], ...], ...]
    B: tuple[tuple[Fraction, ...], ...]
    h: tuple[Fraction, ...]
    distances: tuple[Fraction, ...]
    which: tuple[tuple[int, ...], ...]
    direct: tuple[tuple[int, int, Fraction], ...]

    @staticmethod
    def of(reduced: Reduced, eliminate: bool = True) -> Bordering:
        places = [reduced.places[k] for k in reduced.index]
        distances = sorted({x - y for x in places for y in places})
        number = {x: k for k, x in enumerate(distances)}
        which = tuple(tuple(number[x - y] for y in places) for x in places)
        bodies = range(len(reduced.B))
        S = tuple(tuple(tuple(reduced.S[k][i][j] for k in range(3)) for j in bodies) for i in bodies)
        direct = tuple((d.body, d.contact, d.b) for d in direct_contacts(reduced)) if eliminate else ()
        return Bordering(S, reduced.B, reduced.h, tuple(distances), which, direct)

    @cached_property
    def kept(self) -> tuple[int, ...]:
        """The bodies whose motions are unknowns."""
        gone = {body for body, _, _ in self.direct}
        return tuple(i for i in range(len(self.S)) if i not in gone)

    @cached_property
    def indirect(self) -> tuple[int, ...]:
        """The contacts whose equations remain."""
        gone = {contact for _, contact, _ in self.direct}
        return tuple(j for j in range(len(self.which)) if j not in gone)

    @cached_property
    def cells(self) -> tuple[tuple[tuple[int, tuple[Fraction, ...]], ...], ...]:
        """For each row the entries of S that are not 0, by their columns."""
        return tuple(tuple((j, cell) for j, cell in enumerate(row) if any(cell)) for row in self.S)

    @cached_property
    def shares(self) -> tuple[list[Share], list[list[tuple[int, int]]]]:
        """(the different S_ij y_j/λ, for each body (contact, the number of its own))."""
        kinds: dict[tuple[tuple[Fraction, ...], Fraction], int] = {}
        links = []
        for row in self.cells:
            here = dict(row)
            found = [(contact, (here[body], b)) for body, contact, b in self.direct if body in here]
            links.append([(contact, kinds.setdefault(key, len(kinds))) for contact, key in found])
        shares = [tuple(-x / b for x in cell) for cell, b in kinds]
        return [(cell, _rate(cell)) for cell in shares], links

    @cached_property
    def rates(self) -> tuple[tuple[tuple[int, tuple[Fraction, ...]], ...], ...]:
        """The slopes of `cells`."""
        return tuple(tuple((j, _rate(cell)) for j, cell in row) for row in self.cells)

    @cached_property
    def loads(self) -> tuple[tuple[tuple[int, Fraction], ...], ...]:
        """For each row of B the entries that are not 0, by their columns."""
        return tuple(tuple((j, x) for j, x in enumerate(row) if x) for row in self.B)

    def rows(self, K: Arithmetic, sigma: Any, G: Sequence[Any]) -> list[list[Any]]:
        """The matrix A(σ), from the receptances at `distances`: rows of bodies, then of contacts that remain."""
        factors = [K.evaluate(cell, sigma) for cell, _ in self.shares[0]]
        shared = [[factor * g for g in G] for factor in factors]
        return self._filled(K, sigma, G, shared, self.cells, False)

    def slopes(self, K: Arithmetic, sigma: Any, G: Sequence[Any], G_sigma: Sequence[Any]) -> list[list[Any]]:
        """A'(σ), from the receptances and their slopes."""
        shared = []
        for cell, slope in self.shares[0]:
            factor, rate = K.evaluate(cell, sigma), K.evaluate(slope, sigma)
            shared.append([factor * x + rate * g for x, g in zip(G_sigma, G, strict=True)])
        return self._filled(K, sigma, G_sigma, shared, self.rates, True)

    def _filled(
        self,
        K: Arithmetic,
        sigma: Any,
        G: Sequence[Any],
        shared: list[list[Any]],
        all_cells: Sequence[Sequence[tuple[int, tuple[Fraction, ...]]]],
        rate: bool,
    ) -> list[list[Any]]:
        """The rows, where those of a body take `shared` at the distances of its own contacts; rate: of the slopes."""
        like = sigma * 0
        out = []
        for i, cells in enumerate(all_cells):
            row = [like] * len(self.which)
            for n, (contact, kind) in enumerate(self.shares[1][i]):
                here = shared[kind]
                row = [x + here[k] if n else here[k] for x, k in zip(row, self.which[contact], strict=True)]
            for j, x in () if rate else self.loads[i]:
                row[j] = row[j] - K.number(x)
            entries = dict(cells)
            kept = (K.evaluate(entries[j], sigma) if j in entries else like for j in self.kept)
            out.append([*kept, *row])
        for i in self.indirect:
            own = [
                G[k] + K.number(self.h[i]) if i == j and self.h[i] and not rate else G[k]
                for j, k in enumerate(self.which[i])
            ]
            B = [self.B[j][i] if not rate else Fraction(0) for j in self.kept]
            out.append([*(like + K.number(x) if x else like for x in B), *own])
        return out


def _rate(cell: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    return cell[1], 2 * cell[2]


def delta(K: Arithmetic, border: Bordering, symbols: Symbols, split: Splitting, sigma: Any) -> tuple[Any, Any]:
    """Δ̂ and its slope in σ from the factors U and L, in any arithmetic; where Δ̂ is not 0."""
    G, G_sigma = by_companions(K, symbols, split, sigma, border.distances, True)
    A = K.matrix(border.rows(K, sigma, G))
    turn = K.solve(A, K.matrix(border.slopes(K, sigma, G, G_sigma)))
    value, n = K.det(A), len(border.kept) + len(border.which)
    trace = K.entry(turn, 0, 0)
    for i in range(1, n):
        trace = trace + K.entry(turn, i, i)
    return value, value * trace


def evans(K: Arithmetic, reduced: Reduced, symbols: Symbols, split: Splitting, sigma: Any) -> tuple[Any, Any]:
    """(R·Δ̂, R) with R = det L(C_U): every entry is entire in U and L, so upper and lower roots may meet."""
    like = sigma * 0
    U, L, m = split.upper, split.lower, len(split.upper)
    border = Bordering.of(reduced, eliminate=False)
    zero = [like] * len(border.distances)
    base = border.rows(K, sigma, zero)
    bodies, contacts = len(border.S), len(border.which)
    places = [reduced.places[k] for k in reduced.index]
    middle = (places[0] + places[-1]) / 2
    N = [(like + c) / split.lead for c in symbols.N.at(K, sigma)]
    ahead, back, block = [], [], []
    if m:
        C = companion(K, [like + c for c in U])
        NU, LU = at_matrix(K, N, C, m), at_matrix(K, [*(like + c for c in L), like + 1], C, m)
        block = [[K.entry(LU, i, j) for j in range(m)] for i in range(m)]
        for x in places:
            grown = K.product(K.exp(K.times(C, like + K.number(x - middle))), NU)
            ahead.append([K.entry(grown, 0, j) for j in range(m)])
            shrunk = K.exp(K.times(C, like - K.number(x - middle)))
            back.append([K.entry(shrunk, i, m - 1) for i in range(m)])
    jump = _jumps(K, [like + c for c in product([*U, 1], [*L, 1])[:-1]], N, border.distances)
    rows = [[*base[i][:bodies], *[like] * m, *base[i][bodies:]] for i in range(bodies)]
    rows += [[*[like] * bodies, *block[i], *[-back[j][i] for j in range(contacts)]] for i in range(m)]
    for i in range(contacts):
        own = base[bodies + i]
        corner = [own[bodies + j] - jump[border.which[i][j]] for j in range(contacts)]
        rows.append([*own[:bodies], *(ahead[i] if m else []), *corner])
    R = K.det(K.matrix(block)) if m else like + 1
    return K.det(K.matrix(rows)), R


def _jumps(K: Arithmetic, D: Sequence[Any], N: Sequence[Any], distances: Sequence[Fraction]) -> list[Any]:
    """The sum of the residues at all roots of D where ξ < 0, and 0 where ξ ≥ 0."""
    n, like = len(D), D[0] * 0
    C = companion(K, D)
    last = K.matrix([[like + int(i == n - 1)] for i in range(n)])
    tail = K.product(at_matrix(K, N, C, n), last)
    return [
        like if x >= 0 else K.entry(K.product(K.exp(K.times(C, like + K.number(x))), tail), 0, 0) for x in distances
    ]
