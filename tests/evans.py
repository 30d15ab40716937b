"""Δ̂ = det [[S, −B], [Bᵀ, Ĝ + diag ĥ]] and its slope in σ, over any arithmetic; and R·Δ̂ without division."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from multiprecision import Multiprecision

from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.receptance import at_matrix, by_companions, companion
from mpsolve.characteristic.splitting import Splitting, monic
from mpsolve.characteristic.symbol import Symbols, product
from mpsolve.numbers.arithmetic import Arithmetic
from mpsolve.problem.reduced import Reduced


def delta(K: Arithmetic, border: Bordering, symbols: Symbols, split: Splitting, sigma: Any) -> tuple[Any, Any]:
    """Δ̂ and its slope in σ from the factors U and L, in any arithmetic; where Δ̂ is not 0."""
    xi, ahead = [K.number(x) for x in border.distances], [x >= 0 for x in border.distances]
    G, G_sigma = by_companions(K, symbols.at(K, sigma), split, xi, ahead, True)
    A = border.at(K, sigma, G)
    turn = K.solve(A, border.slope_at(K, sigma, G, G_sigma))
    value, trace = K.det(A), K.entry(turn, 0, 0)
    for i in range(1, len(border.cells)):
        trace = trace + K.entry(turn, i, i)
    return value, value * trace


def evans(K: Arithmetic, reduced: Reduced, symbols: Symbols, split: Splitting, sigma: Any) -> tuple[Any, Any]:
    """(R·Δ̂, R) with R = det L(C_U): every entry is entire in U and L, so upper and lower roots may meet."""
    like = sigma * 0
    U, L, m = split.upper, split.lower, len(split.upper)
    border = Bordering.of(reduced, eliminate=False, waves=m)
    places = [reduced.places[k] for k in reduced.index]
    middle = (places[0] + places[-1]) / 2
    N = [(like + c) / split.lead for c in symbols.N.at(K, sigma)]
    R, corner, ahead, back = like + 1, [], [], []
    if m:
        C = companion(K, [[like + c for c in U]])
        NU, LU = at_matrix(K, [N], C, m), at_matrix(K, [[*(like + c for c in L), like + 1]], C, m)
        R, corner = K.det(LU), [K.entry(LU, i, j) for i in range(m) for j in range(m)]
        moved = [like + K.number(x - middle) for x in places]
        grown = [K.product(K.exp(K.times(C, x)), NU) for x in moved]
        shrunk = [K.exp(K.times(C, -x)) for x in moved]
        ahead = [K.entry(A, 0, k) for k in range(m) for A in grown]
        back = [-K.entry(A, k, m - 1) for k in range(m) for A in shrunk]
    jump = _jumps(K, [like + c for c in product([*U, 1], [*L, 1])[:-1]], N, border.distances)
    return K.det(border.at(K, sigma, [*(-x for x in jump), *ahead, *back, *corner])), R


def _jumps(K: Arithmetic, D: Sequence[Any], N: Sequence[Any], distances: Sequence[Fraction]) -> list[Any]:
    """The sum of the residues at all roots of D where ξ < 0, and 0 where ξ ≥ 0."""
    n, like = len(D), D[0] * 0
    C = companion(K, [D])
    last = K.matrix([[like + int(i == n - 1)] for i in range(n)])
    tail = K.product(at_matrix(K, [N], C, n), last)
    return [
        like if x >= 0 else K.entry(K.product(K.exp(K.times(C, like + K.number(x))), tail), 0, 0) for x in distances
    ]


def split_digits(K: Multiprecision, symbols: Symbols, sigma: Any, upper: int) -> Splitting:
    """The splitting in mpmath, without proof: the `upper` roots of smallest real part are those of U."""
    D = symbols.D.at(K, sigma)
    roots = sorted(K.roots(D), key=lambda z: z.real)
    return Splitting(D[-1], monic(roots[:upper]), monic(roots[upper:]))
