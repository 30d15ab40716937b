"""The argument at which a count from the real axis closes: pivots of an accretive matrix (SPEC, closing).

M(σ) = [[S/σ, −B], [Bᵀ, σ(G + h)]] has a positive semidefinite Hermitian part wherever V = σG has a positive definite
one, Re σ ≥ 0 and the vehicle is passive. All its pivots then have Re ≥ 0, under any symmetric order, so the sum of
their principal arguments is a continuous argument of det M.
"""

from __future__ import annotations

from typing import Any

from flint import acb, arb, fmpq

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.problem.reduced import Reduced


def closing_argument(reduced: Reduced, rho: float, middle: Any, radius: Any) -> arb:
    """Σ Arg(pivots of M) at q̂ = ρ from G between the places; PrecisionError where a pivot is not told from 0."""
    with precision(96):
        M = _accretive(reduced, acb(0, rho), middle, radius)
        total = arb(0)
        while M:
            k = max(range(len(M)), key=lambda i: float(abs(M[i][i]).mid()))
            pivot = M[k][k]
            if pivot.contains(0):
                raise PrecisionError("the mobility at the corner of the contour is singular to within its error")
            total += pivot.arg()
            rest = [i for i in range(len(M)) if i != k]
            M = [[M[i][j] - M[i][k] * M[k][j] / pivot for j in rest] for i in rest]
        return total


def _accretive(reduced: Reduced, sigma: acb, middle: Any, radius: Any) -> list[list[acb]]:
    n, contacts = reduced.bodies, reduced.contacts
    kept = n - reduced.neutral
    out = [[acb(0)] * (n + contacts) for _ in range(n + contacts)]
    for i in range(n):
        for j in range(n):
            entry = acb(0)
            for k in (2, 1, 0):
                entry = entry * sigma + _ball(reduced.S[k][i][j])
            out[i][j] = entry / sigma if i < kept else entry  # the row of a neutral mode has been divided by σ
        for j in range(contacts):
            out[i][n + j] = -acb(_ball(reduced.B[i][j]))
            out[n + j][i] = acb(_ball(reduced.B[i][j]))
    for i, a in enumerate(reduced.index):
        for j, b in enumerate(reduced.index):
            error = arb(0, float(radius[a, b]))
            out[n + i][n + j] = sigma * (acb(complex(middle[a, b])) + acb(error, error))
        out[n + i][n + i] += sigma * _ball(reduced.h[i])
    return out


def _ball(x: Any) -> arb:
    return arb(fmpq(x.numerator, x.denominator))
