"""D = lead · U · L: the p-roots that decay ahead (U) and behind (L) of a force, as two monic factors.

Upper are the n₊ roots of smallest Re P, where n₊ is the number of roots with Re P < 0 for Re σ > 0: it is proved in
balls at one point there, and constant since no p-root becomes real (Re P = 0) for Re σ > 0 and the leading
coefficient does not vanish. "Re P < 0" itself is never decided by rounded numbers.

In balls, where roots of one side meet, U and L are proved by Krawczyk's test on their coefficients.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from mpsolve.characteristic.roots import Orders, leading
from mpsolve.characteristic.symbol import Symbol, product
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arithmetic import Arithmetic
from mpsolve.numbers.balls import (
    Balls,
    acb,
    acb_mat,
    acb_poly,
    arb,
    bits_now,
    exact_ball,
    precision,
    rational_ball,
    square,
)
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


_K = Balls()
_GAPS = (0.0, 2.0**-20, 2.0**-14, 2.0**-8, 2.0**-5, 2.0**-3, 2.0**-2)
Factors = tuple[tuple[Any, ...], tuple[Any, ...]]


def factor_balls(symbol: Symbol, sigma: Any, z: Any, upper: int) -> Factors:
    """The factors with the roots near z, the first `upper` of them in U, for every σ of the ball.

    U·L = D/lead is bilinear: with the derivative at the middle between the centre and a point of the box the first
    order is exact. Interior containment gives one pair in the box for each σ. `PrecisionError` where it fails.
    """
    local = Orders(symbol, sigma)
    n, D = local.size - 1, local.wide
    lead = leading(D, n)
    U, L = _centre([D[i].mid() for i in range(n + 1)], z, upper)
    found = product([*U, 1], [*L, 1])
    rest = acb_mat([[D[i] / lead - found[i]] for i in range(n)])
    try:
        inverse = acb_mat(sylvester(U, L)).inv()
    except ZeroDivisionError:
        raise PrecisionError("an upper and a lower p-root are too close: split the piece") from None
    Y = acb_mat(n, n, [e.mid() for e in inverse.entries()])
    step = Y * rest
    one = acb_mat(n, n, [int(i == j) for i in range(n) for j in range(n)])
    spread = [2 * abs(step[i, 0]) + arb(2) ** (8 - bits_now()) for i in range(n)]
    for _ in range(6):
        X = [square(r) for r in spread]
        half = [c + x / 2 for c, x in zip((*U, *L), X, strict=True)]
        J = acb_mat(sylvester(half[:upper], half[upper:]))
        image = step + (one - Y * J) * acb_mat([[x] for x in X])
        if all(x.contains_interior(image[i, 0]) for i, x in enumerate(X)):
            whole = [c + image[i, 0] for i, c in enumerate((*U, *L))]
            return tuple(whole[:upper]), tuple(whole[upper:])
        spread = [2 * r for r in spread]
    raise PrecisionError("the factors U and L cannot be proved over the ball: split the piece")


def _centre(D: list[Any], z: Any, upper: int) -> tuple[list[acb], list[acb]]:
    """Newton's method for the factors of the midpoint polynomial."""
    nodes = [exact_ball(complex(x)) for x in z]
    U, L = list(monic(nodes[:upper])), list(monic(nodes[upper:]))
    for _ in range(max(4, bits_now().bit_length())):
        moved = sharpened(_K, D, U, L)
        U, L = ([acb(c).mid() for c in part] for part in moved)
        if not all(c.is_finite() for c in (*U, *L)):
            raise PrecisionError("an upper and a lower p-root are too close: split the piece")
    return U, L


def sides(factors: Factors, z: Any, upper: int) -> bool:
    """Whether all roots of U have Re P < 0 and all of L Re P > 0, proved; z: near the roots, those of U first."""
    size = float(max(abs(x) for x in z))
    return all(
        any(_on_side(part, _spread_out(near, gap * size), sign) for gap in _GAPS)
        for part, near, sign in ((factors[0], z[:upper], -1), (factors[1], z[upper:], 1))
    )


def _on_side(part: Sequence[acb], nodes: Sequence[acb], sign: int) -> bool:
    """By Gershgorin's discs of the monic polynomial about the nodes."""
    polynomial = acb_poly([*part, 1])
    for k, x in enumerate(nodes):
        gap = arb(1)
        for i, other in enumerate(nodes):
            gap = gap if i == k else gap * abs(x - other)
        if not sign * x.real > len(nodes) * abs(polynomial(x)) / gap:
            return False
    return True


def _spread_out(nodes: Sequence[Any], gap: float) -> list[acb]:
    """Nodes that keep a distance, moved a little along the imaginary axis where they do not."""
    points = sorted((complex(x) for x in nodes), key=lambda x: (x.imag, x.real))
    for _ in range(len(points)):
        for a, b in pairwise(range(len(points))):
            if abs(points[b] - points[a]) < gap:
                points[b] += 1j * gap
    return [exact_ball(x) for x in points]
