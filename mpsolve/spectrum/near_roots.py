"""Where roots are that lie close to a branch point, in float64 about that point: heuristic, nothing is proved here.

With ζ² = t, t = z − z_b, the function ζ Δ̂ has no singularity at ζ = 0, so that Newton's method converges from afar.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
from flint import acb, arb

from mpsolve.characteristic.local import LocalArrays
from mpsolve.numbers.arrays import Complexes
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.problem.line import Line
from mpsolve.spectrum.branch_loops import edge_points
from mpsolve.spectrum.edge_at_rest import Rest
from mpsolve.spectrum.near_loop import about
from mpsolve.spectrum.sheet import SheetCount

_PER_OCTAVE, _ANGLES = 3, (-0.49, -0.4, -0.25, -0.1, -0.01)  # of |ζ|; of the angle of ζ in its quadrant, times π
_SECTOR = (0, 0.05, 0.15, 0.3, 0.45, 0.6, 0.8)  # of the angle of s, times π/2
_REMOTE = 0.2  # of the way in s: roots further from a branch point are found without this
_CLOSE = 2.0**-16  # of z_b: others are found without coordinates of their own
_STEP, _STEPS, _SAME, _BEST, _FEW = 1e-5, 12, 1e-6, 60, 24
_BITS = 256


def near_branch_points(count: SheetCount) -> list[acb]:
    """Approximate roots σ̂ with Re q ≥ 0 next to branch points with small loops, as exact numbers."""
    out = [] if count.rest is None else _at_rest(count.rest)
    for half, sign in ((count.lower, 1), (count.upper, -1)):
        for loop in half.loops:
            if loop.ways is not None:
                near = loop.ways.near
                found = _found(near, loop.radius / 4, _CLOSE * float(near.z), count.start.up)
                out += [_sigma(count.line, near.z, t, sign) for t in found.tolist()]
    return out


def beside_branch_points(count: SheetCount) -> Any:
    """Approximate roots q̂ in floats with Re q ≥ 0 about branch points, not as close as those."""
    out, line = [], count.line
    halves = [(line.lower, 1), *([(line.upper, -1)] if count.upper.paths else [])]
    for point in edge_points(line) if count.rest is None else []:
        for reduced, sign in halves:
            found = _found(about(reduced, point.exact, point.pole), _CLOSE * point.room, point.room, count.start.up)
            z = point.z + found
            out += [(z if sign > 0 else z.conj()) + 1j * float(line.height)]
    return np.concatenate(out) if out else np.zeros(0, complex)


def _at_rest(rest: Rest) -> list[Any]:
    """Those below the line of the cuts under loads that stand still, about s = 0; above it there is none."""
    if rest.closest > _REMOTE * abs(rest.u[-1]):
        return []
    half, (EI, A, k, m) = rest.halves[0], rest.halves[0].beam
    sizes = np.geomspace(rest.closest / 4, 2 * abs(rest.u[-1]), 2 + int(np.log2(8 * abs(rest.u[-1]) / rest.closest)))
    s = (sizes[:, None] * np.exp(0.5j * np.pi * np.array(_SECTOR))).ravel()

    def step(s: Any) -> Any:
        f, h = half.over(s, np.zeros(len(s))), (_STEP * s)[:, None, None]
        value, ahead, behind = map(np.linalg.det, (f.a, f.a + h * f.b, f.a - h * f.b))
        with np.errstate(all="ignore"):
            found = -value * (2 * _STEP * s) / (ahead - behind)
        return np.where(np.isfinite(found), found, 0)

    out: list[Any] = []
    for root in _settled(s, step, _FEW):
        with precision(_BITS):
            product = (acb(root) ** 2 + rational_ball(A)) / 2
            z = ((rational_ball(k) - rational_ball(EI) * product**2) / rational_ball(m)).sqrt()
            if root.real > 0 and product.real > 0 and z.imag < _SAME * abs(product) ** 2:
                out.append((acb(0, 1) * z - rational_ball(rest.height)).mid())
    return out


def _sigma(line: Line, branch: Fraction, t: complex, sign: int) -> acb:
    """i q̂ with q̂ = z_b + t + iη below the line of the cuts, and its mirror above it."""
    with precision(_BITS):
        z, height = map(rational_ball, (branch, line.height))
        return acb(-height - sign * arb(t.imag), z + arb(t.real)).mid()


def _found(near: LocalArrays, least: float, most: float, up: int) -> Complexes:
    """The t of roots on the lower half of the sheet, or on the real axis before the cut."""
    if most <= least:
        return np.zeros(0, complex)
    sizes = np.geomspace(np.sqrt(least), np.sqrt(most), 2 + int(np.log2(most / least) / 2 * _PER_OCTAVE))
    zeta = (sizes[:, None] * np.exp(1j * np.pi * np.array(_ANGLES))).ravel()
    kept: list[complex] = []
    for t in [x * x for x in _settled(zeta, lambda zeta: _newton(near, zeta, up))]:
        below = t.imag < 0 or (abs(t.imag) < _SAME * abs(t) and t.real < 0)
        if below and least < abs(t) < most and all(abs(t - other) > _SAME * abs(t) for other in kept):
            kept.append(t)
    return np.array(kept, complex)


def _settled(x: Any, newton: Callable[[Any], Any], most: int = _BEST) -> list[complex]:
    """Where Newton's steps lead from the best of the points, each place once."""
    step = newton(x)
    order = np.argsort(np.abs(step / x))[:most]
    x = (x + step)[order]
    for _ in range(_STEPS):
        step = newton(x)
        size = np.maximum(np.abs(step), 1e-300)
        x = x + step * np.minimum(1, 0.7 * np.abs(x) / size)
    kept: list[complex] = []
    for root in x[(np.abs(step) < _SAME * np.abs(x)) & np.isfinite(x)].tolist():
        if all(abs(root - other) > _SAME * abs(root) for other in kept):
            kept.append(root)
    return kept


def _newton(near: LocalArrays, zeta: Complexes, up: int) -> Complexes:
    """Newton's step for ζ Δ̂; what is not finite does not move."""
    points = np.concatenate([zeta, zeta * (1 + _STEP), zeta * (1 - _STEP)])
    m = 1j * points**2
    with np.errstate(all="ignore"):
        _, G, _ = near.evaluate(m, np.zeros(len(m)), up)
        value, ahead, behind = (points * np.linalg.det(near.matrix(G, m).a)).reshape(3, -1)
        step = -value * (2 * _STEP * zeta) / (ahead - behind)
    return np.where(np.isfinite(step), step, 0)
