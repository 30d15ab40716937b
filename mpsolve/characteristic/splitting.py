"""D = lead · U · L: the p-roots that decay ahead (U) and behind (L) of a force, as two monic factors.

Upper are the n₊ roots of smallest Re P, where n₊ is the number of roots with Re P < 0 for Re σ > 0: it is proved in
balls at one point there, and constant since no p-root becomes real (Re P = 0) for Re σ > 0 and the leading
coefficient does not vanish. "Re P < 0" itself is never decided by rounded numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from mpsolve.characteristic.symbol import Symbol, product
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arithmetic import Arithmetic
from mpsolve.numbers.balls import acb_poly, arb, precision, rational_ball
from mpsolve.numbers.float64 import Float64

_FLOATS = Float64()
_STARTS = [Fraction(2) ** k for k in (0, 1, -1, 2, -2, 3, -3, 5, -5, 8, -8)]


@frozen
class Splitting:
    """lead, and the coefficients of the monic U and L from the constant term up, without their leading 1."""

    lead: Any
    upper: tuple[Any, ...]
    lower: tuple[Any, ...]


def upper_count(D: Symbol, bits: int = 96) -> int:
    """n₊: the proved number of roots with Re P < 0 at a point σ > 0; `PrecisionError` where balls decide at none."""
    with precision(bits):
        for start in _STARTS:
            sigma = rational_ball(start)
            coefficients = [sum((rational_ball(c) * sigma**j for j, c in enumerate(row)), arb(0)) for row in D.rows]
            if coefficients[-1].contains(0):
                continue
            try:
                roots = acb_poly(coefficients).roots()
            except ValueError:  # two roots are too close to be told apart
                continue
            if all(z.real < 0 or z.real > 0 for z in roots):
                return sum(1 for z in roots if z.real < 0)
    raise PrecisionError("the p-roots cannot be told apart from real ones at any start: the track's k or c may be 0")


def monic(roots: Sequence[Any]) -> tuple[Any, ...]:
    """Π (P − z), without its leading 1."""
    out: list[Any] = [1]
    for z in roots:
        out = product(out, [-z, 1])
    return tuple(out[:-1])


def sylvester(U: Sequence[Any], L: Sequence[Any]) -> list[list[Any]]:
    """The derivative of (U, L) → U·L at monic factors without their leading 1."""
    m, k = len(U), len(L)
    rows: list[list[Any]] = [[0] * (m + k) for _ in range(m + k)]
    for j in range(m):
        for i, c in enumerate([*L, 1]):
            rows[i + j][j] = c
    for j in range(k):
        for i, c in enumerate([*U, 1]):
            rows[i + j][m + j] = c
    return rows


def sharpened(K: Arithmetic, D: Sequence[Any], U: Sequence[Any], L: Sequence[Any]) -> tuple[list[Any], list[Any]]:
    """One Newton step for U·L = D/D_n: well conditioned where only roots of one side meet."""
    found = product([*U, 1], [*L, 1])
    rest = [[d / D[-1] - f] for d, f in zip(D[:-1], found[:-1], strict=True)]
    step = K.solve(K.matrix(sylvester(U, L)), K.matrix(rest))
    moved = [c + K.entry(step, i, 0) for i, c in enumerate([*U, *L])]
    return moved[: len(U)], moved[len(U) :]


def float_splitting(D: Sequence[Any], z: Any, upper: int) -> Splitting:
    """The splitting in float64 from floats near the p-roots, (points, degree), the upper ones first."""
    U, L = (list(monic(side.T)) for side in (z[:, :upper], z[:, upper:]))
    for _ in range(2):
        U, L = sharpened(_FLOATS, D, U, L)
    return Splitting(D[-1], tuple(U), tuple(L))
