"""The sections of the cut line Im q = η_b, and the sheet that continues each of them upward from below.

Below the line two p-roots are upper and two lower. On the line D is real in p: its real roots, 0, 2 or 4 of them,
change in number at the branch points. Just above the line a real root has moved by iε/q'(p), so that the upper and
lower ones among them have changed sides. With the four p-roots in the order of their imaginary parts the upper two
of the continued factorisation D = U·L are therefore

    0 real roots (the gap): 1, 2 (the physical sheet);   2: 1, 3;   4: 3, 4.

In terms of s, the sum of the upper roots: the largest |Im s|, the second, and the largest with the other sign.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.fields import cardano
from mpsolve.model.branch import Pairing, Track
from mpsolve.model.limits import branch_points
from mpsolve.model.parameters import Case

_CLOSE = 0.4  # the nearest sum must be nearer than this part of the distance of the next one


@dataclass(frozen=True)
class Sheet:
    """Which s belongs to the upper p-roots: the one of `rank` by |Im s| (0: the largest), Im s of this `sign`."""

    rank: int
    sign: int


PHYSICAL = Sheet(0, 1)
_BY_REAL_ROOTS = {0: PHYSICAL, 2: Sheet(1, 1), 4: Sheet(0, -1)}


@dataclass(frozen=True)
class Section:
    """A part start < Re q < end of the cut line between two branch points; start = −end if it holds Re q = 0."""

    start: float
    end: float  # inf for the last
    sheet: Sheet
    obstacles: tuple[complex, ...] = ()  # complex branch points above the last section, relative to iη_b

    @property
    def gap(self) -> bool:
        return self.sheet is PHYSICAL


def sections(case: Case) -> list[Section]:
    """The sections of the line with Re q ≥ 0, outward; the first one is symmetric about Re q = 0."""
    points = _distinct(branch_points(case))
    bounds = [-points[0], *points, np.inf]
    parts = [
        Section(a, b, _BY_REAL_ROOTS[_real_roots(case, _inside(a, b))])
        for a, b in pairwise(bounds)
        if b > a or b == 0
    ]
    obstacles = tuple(r for r in complex_branch_points(case) if r.real > parts[-1].start)
    return [*parts[:-1], replace(parts[-1], obstacles=obstacles)]


def complex_branch_points(case: Case) -> list[complex]:
    """r with Re r > 0, Im r > 0 where q'(p) = 0 at a complex p: p-roots meet, though not on the physical sheet."""
    alpha, axial, beta2 = float(case.alpha), float(case.axial), 1 - float(case.eta_b) ** 2
    cubic = np.array([1, 0, -2 * axial, 0])  # (S²)'/4
    found = []
    for p in np.roots(np.polysub(np.polymul(cubic, cubic), alpha**2 * np.array([1, 0, -4 * axial, 0, 4 * beta2]))):
        S = -np.polyval(cubic, p) / alpha if alpha else np.sqrt(complex(p**4 - 4 * axial * p * p + 4 * beta2))
        r = complex(alpha * p + S / 2)
        if r.real > 0 and r.imag > 1e-9 * abs(r):
            found.append(r)
    return found


def _distinct(points: list[float]) -> list[float]:
    kept: list[float] = []
    for point in points:
        if not kept or point - kept[-1] > 1e-9 * (1 + point):
            kept.append(point)
    return kept


def _inside(a: float, b: float) -> float:
    if a < 0:
        return 0.0 if b == 0 else b / 2
    return a + 1 if np.isinf(b) else (a + b) / 2


def _real_roots(case: Case, r: float) -> int:
    """How many real p-roots D has at a real r that is no branch point."""
    alpha, axial, beta2 = float(case.alpha), float(case.axial), 1 - float(case.eta_b) ** 2
    # r − αp = ±S/2 with S² = p⁴ − 4Np² + 4β² > 0: the roots lie between the extrema of q±(p)
    roots = np.roots([1, 0, -4 * (axial + alpha**2), 8 * alpha * r, 4 * beta2 - 4 * r * r])
    order = np.argsort(np.abs(roots.imag))
    size = np.max(np.abs(roots))
    real = int(np.sum(np.abs(roots.imag[order]) < 1e-7 * size))
    if real not in _BY_REAL_ROOTS:
        raise PrecisionError(f"the p-roots at Re q = {r:.6g} on the cut cannot be told apart in float64")
    return real


def pairing_on(track: Track, q: Any, sheet: Sheet) -> Pairing:
    """The factors of D at q close above the section of the sheet; q in numpy arrays, or one mpmath number."""
    return pairing_of(track, q, ranked(track, q, sheet))


def ranked(track: Track, q: Any, sheet: Sheet) -> Any:
    """s by its rank: right close above the line, and far along it."""
    c2, c1, c0 = _coefficients(track, q)
    return sheet.sign * track.field.ranked_sum(2 * c2, c2 * c2 - 4 * c0, -c1 * c1, sheet.rank)


def pairing_of(track: Track, q: Any, s: Any) -> Pairing:
    """The factors of D at q for a known sum s of the upper roots."""
    c2, c1, _ = _coefficients(track, q)
    y, h = s * s, c1 / s
    return Pairing(s, y, h, c2, 2 * y * (y + c2) + h * h)


def _coefficients(track: Track, q: Any) -> tuple[Any, Any, Any]:
    """c2, c1, c0 of D = p⁴ + c2 p² + c1 p + c0."""
    r = q - track.field.i * track.eta_b
    return -4 * track.A, 8 * track.alpha * r, 4 * track.beta2 - 4 * r * r


def followed(track: Track, q: Any, sheet: Sheet) -> Any:
    """s along points q above the line by continuity, from its rank at the first one; None where they are too sparse.

    Away from the line two roots may change their order without meeting: there the rank 1 would leave the sheet. The
    largest |Im s| separates the two highest roots from the two lowest whatever their order, and s may vanish.
    """
    first = ranked(track, q[:1], sheet)[0]
    if sheet.rank:
        return continued(track, q, first)
    s = ranked(track, q, sheet)
    return s if np.all(np.abs(np.diff(s)) < _CLOSE * (np.abs(s[1:]) + 0.5)) else None


def continued(track: Track, q: Any, start: complex) -> Any:
    """s along the points q by continuity, from the one nearest to `start`; None where they are too sparse."""
    options = _candidates(track, q).T  # (points, 6)
    gaps = np.abs(options[1:, None, :] - options[:-1, :, None])  # from each option to each one at the next point
    following, order = np.argmin(gaps, axis=2), np.sort(gaps, axis=2)
    clear = order[..., 0] < _CLOSE * order[..., 1]
    chosen = [int(np.argmin(np.abs(options[0] - start)))]
    for step, certain in zip(following.tolist(), clear.tolist(), strict=True):
        if not certain[chosen[-1]]:
            return None
        chosen.append(step[chosen[-1]])
    return options[np.arange(len(chosen)), chosen]


def nearest(track: Track, q: Any, guess: Any) -> Any:
    """Of the possible sums of two p-roots those that are nearest to the guesses, in arrays."""
    candidates = _candidates(track, q)
    return np.take_along_axis(candidates, np.argmin(np.abs(candidates - guess), axis=0)[None], 0)[0]


def _candidates(track: Track, q: Any) -> Any:
    """The sums of any two p-roots, shape (6, number of q)."""
    c2, c1, c0 = _coefficients(track, q)
    sums = np.sqrt(np.stack(cardano(np.broadcast_to(2 * c2, q.shape), c2 * c2 - 4 * c0, -c1 * c1)))
    return np.concatenate([sums, -sums])


def pairing_below(track: Track, q: Any, nudge: Any) -> Pairing:
    """The factors of D at one mpmath number q on or below the cut line, as seen from below.

    The physical root y of the resolvent cubic at q − i·nudge is carried to q by Newton's method, so that q may lie
    on the cut (not at a branch point).
    """
    field, context = track.field, track.field.context
    r = q - field.i * track.eta_b
    if context.im(r) < -nudge:
        return pairing_on(track, q, PHYSICAL)
    near = pairing_on(track, q - field.i * nudge, PHYSICAL)
    c2, c1, c0 = -4 * track.A, 8 * track.alpha * r, 4 * track.beta2 - 4 * r * r
    a2, a1, a0, y = 2 * c2, c2 * c2 - 4 * c0, -c1 * c1, near.y
    for _ in range(60):
        slope = (3 * y + 2 * a2) * y + a1
        step = (((y + a2) * y + a1) * y + a0) / slope
        y = y - step
        if abs(step) <= abs(near.y) * context.eps * 16:
            break
    else:
        raise PrecisionError(f"the p-roots at q = {complex(q):.6g} cannot be followed: a branch point is too near")
    # s and h share the product c1: the root of the larger one is taken
    h = _nearest_root(context, (y + c2) ** 2 - 4 * c0, near.h)
    s = c1 / h if abs(near.h) > abs(near.s) else _nearest_root(context, y, near.s)
    return Pairing(s, y, h, c2, 2 * y * (y + c2) + h * h)


def _nearest_root(context: Any, square: Any, near: Any) -> Any:
    root = context.sqrt(square)
    return root if abs(root - near) <= abs(root + near) else -root
