"""Δ̂ = det [[S, −B], [Bᵀ, Ĝ + diag ĥ]] and its slope in σ, over any arithmetic; and R·Δ̂ without division."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.characteristic.receptance import at_matrix, companion
from mpsolve.characteristic.splitting import Splitting
from mpsolve.characteristic.symbol import Symbols, product
from mpsolve.numbers.arithmetic import Arithmetic
from mpsolve.problem.reduced import Reduced


@dataclass(frozen=True)
class Bordering:
    """The vehicle's part of the matrix, and which distance stands in which entry.

    distances: the different ξ_i − ξ_j, exact; which[i][j] is the number of that of contacts i and j.
    """

    S: tuple[tuple[tuple[Fraction, ...], ...], ...]
    B: tuple[tuple[Fraction, ...], ...]
    h: tuple[Fraction, ...]
    distances: tuple[Fraction, ...]
    which: tuple[tuple[int, ...], ...]

    @staticmethod
    def of(reduced: Reduced) -> Bordering:
        places = [reduced.places[k] for k in reduced.index]
        distances = sorted({x - y for x in places for y in places})
        number = {x: k for k, x in enumerate(distances)}
        which = tuple(tuple(number[x - y] for y in places) for x in places)
        bodies = range(len(reduced.B))
        S = tuple(tuple(tuple(reduced.S[k][i][j] for k in range(3)) for j in bodies) for i in bodies)
        return Bordering(S, reduced.B, reduced.h, tuple(distances), which)

    def rows(self, K: Arithmetic, sigma: Any, G: Sequence[Any]) -> list[list[Any]]:
        """The matrix A(σ), from the receptances at `distances`."""
        like = sigma * 0
        vehicle = [
            [K.evaluate(cell, sigma) if any(cell) else like for cell in row]
            + [like - K.number(x) if x else like for x in self.B[i]]
            for i, row in enumerate(self.S)
        ]
        rail = [
            [like + K.number(row[i]) if row[i] else like for row in self.B]
            + [G[k] + K.number(self.h[i]) if i == j and self.h[i] else G[k] for j, k in enumerate(which)]
            for i, which in enumerate(self.which)
        ]
        return [*vehicle, *rail]

    def slopes(self, K: Arithmetic, sigma: Any, G_sigma: Sequence[Any]) -> list[list[Any]]:
        """A'(σ), from the slopes of the receptances."""
        like = sigma * 0
        zero = [like] * len(self.which)
        vehicle = [
            [K.evaluate((c[1], 2 * c[2]), sigma) if c[1] or c[2] else like for c in row] + zero for row in self.S
        ]
        rail = [[like] * len(self.S) + [G_sigma[k] for k in which] for which in self.which]
        return [*vehicle, *rail]


def evans(K: Arithmetic, reduced: Reduced, symbols: Symbols, split: Splitting, sigma: Any) -> tuple[Any, Any]:
    """(R·Δ̂, R) with R = det L(C_U): every entry is entire in U and L, so upper and lower roots may meet."""
    like = sigma * 0
    U, L, m = split.upper, split.lower, len(split.upper)
    border = Bordering.of(reduced)
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
