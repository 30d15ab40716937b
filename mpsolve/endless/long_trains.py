"""That all trains above some length grow, proved at one velocity: the middle roots have one modulus at a growing σ.

T is the map of one cell (a, b') → (a', b), see `bloch`; a decays ahead, b behind. Where the vehicle alone has no root
and b reaches through it, a train of N vehicles has a root at σ exactly if det (T^N)_bb = 0. With T = R diag(z) R⁻¹,
by Cauchy and Binet, and Jacobi's complementary minors,

    det (T^N)_bb = Σ_M C_M Π_{k in M} z_k^N,    C_M = ± det R[b, M] · det R[a, not M]/det R,    |M| = n − n₊.

Let a disc in Re σ > 0 be such that for all its σ the z are simple, the n₊ − 1 least moduli lie below those of two
roots x, y, and the others above; that C_M ≠ 0 for M = {x, others} and {y, others}; and that |x| < |y| at one of its
points and |x| > |y| at another. Then all trains of more than some number of vehicles have a root in the disc.

Proof. w = x/y is analytic, |w| takes values below and above 1, so |w| = 1 on infinitely many points of a smaller
closed disc, and w' ≠ 0 at one of them, σ*. Divided by the N-th power of y and the others, det (T^N)_bb is
C_y + C_x w^N + O(r^N), r < 1, near σ*, as any other M exchanges a root for a smaller one. At σ* + ζ/N it tends,
along each subsequence of N for which w(σ*)^N → u does, to C_y + C_x u e^{cζ}, c = w'/w at σ*, uniformly for bounded
ζ. That has a zero with |cζ| ≤ |log|C_y/C_x|| + π. By Hurwitz each subsequence has a part whose members have a zero at
such a distance /N from σ*; so all but finitely many N do. ∎ (docs/theory/infinite-train.md, 5, has the rest.)
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.characteristic.proved import Proved
from mpsolve.characteristic.splitting import upper_count
from mpsolve.characteristic.symbol import Symbols
from mpsolve.endless.bloch import scattered
from mpsolve.endless.row import Row
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import Balls, acb, acb_mat, precision, square

_K = Balls()
_BITS = 320
_RIGHT = 1e-8  # Re σ of the points, relative to |σ|
_STEPS, _HALVINGS = np.geomspace(1e-8, 1e-2, 13), 60  # of |σ|: where |x/y| is looked for on the other side of 1


@dataclass(frozen=True)
class LongTrains:
    """At the velocity `v` all trains that are long enough grow, proved; roots gather at σ = near (scaled) too."""

    v: Fraction
    near: complex


def cell(row: Row, sigma: Any) -> acb_mat:
    """T over a ball of σ; PrecisionError where the vehicle alone, or what reaches through it, may vanish."""
    proved = Proved(row.reduced, eliminate=False)
    split = proved.splitting(sigma)
    if split.roots is None:
        raise PrecisionError("two p-roots of one side may meet")
    A, _ = proved.matrices(sigma, slope=False, mean=False)
    waves, up = list(zip(split.roots, split.weights, strict=True)), proved.upper
    S, n = scattered(_K, row, A, waves, up, lambda x: x.exp()), len(waves)
    sides = slice(0, up), slice(up, n)
    (t, r), (b, u) = ([acb_mat([line[own] for line in S[rows]]) for own in sides] for rows in sides)
    over = _K.solve(u, acb_mat([[acb(int(i == j)) for j in range(n - up)] for i in range(n - up)]))
    low = over * b
    top = [[*p, *q] for p, q in zip((t - r * low).tolist(), (r * over).tolist(), strict=True)]
    return acb_mat(top + [[*p, *q] for p, q in zip((-low).tolist(), over.tolist(), strict=True)])


def roots_of(row: Row, sigma: Any) -> tuple[list[acb], acb_mat, int]:
    """(z as balls, ascending in modulus at the middle, R with its columns in this order, n₊)."""
    T = cell(row, sigma)
    try:
        z, R = T.eig(right=True)
    except ValueError:
        raise PrecisionError("two roots z may meet") from None
    order = sorted(range(len(z)), key=lambda k: abs(z[k]).mid())
    columns = R.tolist()
    return (
        [z[k] for k in order],
        acb_mat([[line[k] for k in order] for line in columns]),
        upper_count(Symbols.of(row.reduced.guide).D),
    )


def prove_long(row: Row, q: float) -> LongTrains | None:
    """The theorem in a disc next to σ = iq, where in floats the middle roots have one modulus; None if it fails."""
    try:
        with precision(_BITS):
            ends = _ends(row, q)
            if ends is None or not holds(row, *ends):
                return None
            return LongTrains(row.problem.v or Fraction(0), complex(ends[0]))
    except PrecisionError:
        return None


def holds(row: Row, one: Any, other: Any) -> bool:
    """Whether the theorem's premises are proved for the disc round two exact points, at the precision that is set."""
    disc = (one + other) / 2 + square(abs(one - other))
    if not disc.real > 0 or not all(disc.contains(end) for end in (one, other)):
        return False
    z, R, up = roots_of(row, disc)
    if not 0 < up < len(z):
        return False
    x, y = z[up - 1], z[up]
    middle = (x, y)
    if not all(abs(a) < abs(m) for a in z[: up - 1] for m in middle):
        return False
    if not all(abs(m) < abs(c) for m in middle for c in z[up + 1 :]):
        return False
    n = len(z)
    for first in (up - 1, up):
        M = [first, *range(up + 1, n)]
        rest = [k for k in range(n) if k not in M]
        for rows, columns in ((range(up, n), M), (range(up), rest)):
            if acb_mat([[R[i, k] for k in columns] for i in rows]).det().contains(0):
                return False
    return {_sign(row, one, x, y), _sign(row, other, x, y)} == {-1, 1}


def _sign(row: Row, sigma: Any, x: acb, y: Any) -> int | None:
    """Of |x| − |y| at σ, x and y in the balls given, which do not meet."""
    z, _, _ = roots_of(row, sigma)
    here = [[a for a in z if a.overlaps(ball)] for ball in (x, y)]
    if [len(found) for found in here] != [1, 1] or here[0][0].overlaps(here[1][0]):
        return None
    a, b = abs(here[0][0]), abs(here[1][0])
    return 1 if a > b else -1 if a < b else None


def _ends(row: Row, q: float) -> tuple[acb, acb] | None:
    """Two exact points with Re σ > 0, next to iq and to each other: |x| < |y| at one, > at the other, it seems."""
    start = acb(q * _RIGHT, q)
    z, _, up = roots_of(row, start)
    x, y = z[up - 1].mid(), z[up].mid()

    def sign(share: acb) -> bool:
        """Whether the one that is next to x is the larger one; in floats of many bits."""
        z, _, up = roots_of(row, start + acb(0, q) * share)
        a, b = z[up - 1].mid(), z[up].mid()
        return bool((abs(a - x) + abs(b - y)).mid() > (abs(a - y) + abs(b - x)).mid())

    low, first = acb(0), sign(acb(0))
    high = next((acb(step) for step in (*_STEPS, *-_STEPS) if sign(acb(step)) != first), None)
    if high is None:
        return None
    for _ in range(_HALVINGS):
        middle = ((low + high) / 2).mid()
        low, high = (middle, high) if sign(middle) == first else (low, middle)
    one, other = ((start + acb(0, q) * share).mid() for share in (low, high))
    return one, other
