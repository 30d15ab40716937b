"""The physical sheet as one branch of a cubic: D(p, q) = (p² − s p + t)(p² + s p + t').

On the physical sheet two p-roots of D, eq. (18), lie above the real axis (their sum is s) and two below.
Everything that the kernel needs of them is rational in s: y = s² is a root of the resolvent cubic

    g(y) = y³ + 2 c2 y² + (c2² − 4 c0) y − c1²,   c2 = −4A, c1 = 8αr, c0 = 4β² − 4r²,   r = q − iη_b.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import flint
import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.fields import Ball, Field, Float64
from mpsolve.problem.case import Case


@dataclass(frozen=True)
class Track:
    """A case's numbers in one arithmetic (ends of merged masses; `positions` as given)."""

    field: Any
    alpha: Any
    axial: Any  # N = η_N − η_S
    eta_b: Any
    eta_m: tuple[Any, ...]
    positions: tuple[Any, ...]
    cuts_on_line: bool  # η_b < 1 and N < β: the cuts lie on Im q = η_b

    @cached_property
    def A(self) -> Any:
        return self.axial + self.alpha * self.alpha

    @cached_property
    def beta2(self) -> Any:
        return 1 - self.eta_b * self.eta_b


def track(case: Case, field: Field) -> Track:
    """The numbers of `case` (masses at one place merged) in the arithmetic `field`."""
    case = case.merged
    return Track(
        field,
        field.number(case.alpha),
        field.number(case.axial),
        field.number(case.eta_b),
        tuple(field.number(eta) for eta in case.eta_m),
        tuple(field.number(x) for x in case.positions),
        case.cuts_on_line,
    )


@dataclass(frozen=True)
class Pairing:
    """The factors of D: s, y = s², h = t − t' = c1/s, c2 = t + t' − y, and R = res(U, L) = g'(y)."""

    s: Any
    y: Any
    h: Any
    c2: Any
    R: Any

    def discriminant(self, side: int) -> Any:
        """δ² (side = +1, the upper roots s/2 ± δ) or δ'² (side = −1, the lower roots −s/2 ± δ')."""
        return -self.y / 4 - (self.c2 + side * self.h) / 2


def pairing(track: Track, q: Any) -> Pairing:
    """The factors of D at q on the physical sheet; with balls, proved to be the physical ones.

    Raises `PrecisionError` where balls cannot decide (q near the cut, or a ball too wide).
    """
    pair = factors(track, q)
    if isinstance(track.field, Ball) and not _is_physical(pair):
        # y is one simple root all over the ball: it is enough to look at one point, if no cut is met
        q = flint.acb(q)
        middle = factors(track, q.mid())
        same = pair.s.contains(middle.s) and _one_root(track, q.mid(), pair)
        if not (_off_the_cut(track, q) and same and _is_physical(middle)):
            raise PrecisionError("the ball of q meets the cut, or is too wide to tell upper from lower p-roots")
    return pair


def factors(track: Track, q: Any) -> Pairing:
    field, r = track.field, q - track.field.i * track.eta_b
    c2, c1, c0 = -4 * track.A, 8 * track.alpha * r, 4 * track.beta2 - 4 * r * r
    s = field.dominant_sum(2 * c2, c2 * c2 - 4 * c0, -c1 * c1)
    total = s * s + c2
    if isinstance(field, Float64):
        s, total = _sharpened(field, s, total, c2, c1, c0)
    y, h = s * s, c1 / s
    return Pairing(s, y, h, c2, 2 * y * total + h * h)


def _sharpened(field: Float64, s: Any, total: Any, c2: Any, c1: Any, c0: Any) -> tuple[Any, Any]:
    """s and u = t + t' where y + c2 cancels, as under strong tension: by Newton's method for u itself,
    (u − c2)(u² − 4 c0) = c1², whose terms do not cancel there.
    """
    small = np.abs(total) < np.abs(s * s) / 4
    if not np.any(small):
        return s, total
    u = total
    for _ in range(2):
        y, z = u - c2, u * u - 4 * c0
        slope = z + 2 * u * y
        u = u - np.where(slope == 0, 0, y * z - c1 * c1) / np.where(slope == 0, 1, slope)
    small = small & np.isfinite(u)
    return np.where(small, field.upper(field.sqrt(u - c2)), s)[()], np.where(small, u, total)[()]


def _one_root(track: Track, q: Any, pair: Pairing) -> bool:
    """At q the resolvent has one root at most in the ball of y: a mean of its slopes there is not zero."""
    r, y, c2 = q - track.field.i * track.eta_b, pair.y, pair.c2
    slope = 3 * y * y + 4 * c2 * y + c2 * c2 - 16 * (track.beta2 - r * r)
    return bool(slope.is_finite() and not slope.contains(0))


def _is_physical(pair: Pairing) -> bool:
    """Both roots s/2 ± δ are above the real axis, both roots −s/2 ± δ' below it: |Im δ| < Im s/2."""
    height2 = (pair.s / 2).imag ** 2
    deltas = (pair.discriminant(1), pair.discriminant(-1))
    return all(height2 > (abs(delta2) - delta2.real) / 2 for delta2 in deltas)  # |Im δ|², free of any branch


def _off_the_cut(track: Track, q: Any) -> bool:
    """D has no real p-root for any q of the ball: off the line Im q = η_b, or Im q ≤ 0 when the cuts have left it."""
    height = q.imag - track.eta_b
    if track.cuts_on_line:
        return bool(height > 0 or height < 0)
    return bool(q.imag <= 0 and track.eta_b > 0)


@dataclass(frozen=True)
class Motion:
    """A direction of differentiation: how fast the arguments of Δ move along it (merged masses, as in `Track`)."""

    q: Any = 0
    alpha: Any = 0
    eta_b: Any = 0
    eta_m: tuple[Any, ...] | None = None  # None: the masses, or their positions, stand still
    positions: tuple[Any, ...] | None = None


ALONG_Q = Motion(q=1)
ALONG_ALPHA = Motion(alpha=1)
ALONG_DAMPING = Motion(eta_b=1)


@dataclass(frozen=True)
class PairingRate:
    """The derivatives of a `Pairing` along a `Motion`."""

    s: Any
    y: Any
    h: Any
    c2: Any
    R: Any

    def discriminant(self, side: int) -> Any:
        return -self.y / 4 - (self.c2 + side * self.h) / 2


def pairing_rate(track: Track, q: Any, pair: Pairing, motion: Motion = ALONG_Q) -> PairingRate:
    """Implicit differentiation of g(y; r, α, η_b) = 0, with g_y = R, g_r = 32 r (y − 4α²)."""
    i, alpha, y = track.field.i, track.alpha, pair.y
    r, r_rate = q - i * track.eta_b, motion.q - i * motion.eta_b if motion.eta_b else motion.q
    g, c1, c2 = 32 * r * (y - 4 * alpha * alpha) * r_rate, 8 * alpha * r_rate, y * 0
    if motion.alpha:
        g = g - 16 * alpha * (8 * r * r + y * (y + pair.c2)) * motion.alpha
        c1, c2 = c1 + 8 * r * motion.alpha, c2 - 8 * alpha * motion.alpha
    if motion.eta_b:
        g = g + 32 * y * track.eta_b * motion.eta_b
    y_rate = -g / pair.R
    s = y_rate / (2 * pair.s)
    h = (c1 - pair.h * s) / pair.s
    R = (4 * y + 2 * pair.c2) * y_rate + 2 * y * c2 + 2 * pair.h * h
    return PairingRate(s, y_rate, h, c2, R)
