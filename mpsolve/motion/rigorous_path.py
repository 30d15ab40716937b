"""The contour of the proved transient part: a path in v, q = x + iη_b + v²/2 with x near the last branch point.

In Re q ≥ 0 the physical sheet is the half Im v < 0: the right half of the real v axis is the lower side of the cut,
the left half its upper side, and Im v > 0 with Re v > 0 is the sheet that continues the lower side upward. Where the
cut reaches beyond x to the left, it lies on the imaginary v axis: below α_C a gap remains between it and Re q = 0,
from α_C on none does, and the path begins below the line, Re v₀ > 0. The path

runs v₀ → v₁ → ∞ + iδ, Im v₁ = δ,
from a point q(v₀) = ih of the imaginary axis, through the lower side of the cut, and out along Im v = δ, where
Im q = η_b + δ Re v. Its mirror image q → −q̄ is the other half of the contour.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import flint
import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.fields import Float64
from mpsolve.model.branch import Track, track
from mpsolve.model.limits import branch_points, limiting_frequency
from mpsolve.problem.case import Case

acb, arb = flint.acb, flint.arb

_GRID = 2.0**20  # v₀ on a grid of 2^−20, so that the centre x is exact in float64
_NARROW = 0.002  # q_lm below which no path is led through the gap
_FAR = 20.0  # |w| from which the p-roots are named by their asymptotes in seeds
_HEIGHTS = (0.5, 0.35, 0.7, 0.2, 1.0, 0.1, 1.4)  # of q(v₀) above the line, by q_lm
_DEPTHS = (0.1, 0.3, 0.6, 1.0, 0.03)  # of q(v₀) below it, by the last branch point or _LEAST
_LEAST = 0.25
_CROSSINGS = (1.0, 0.6, 1.5, 0.35)
_ENOUGH = 0.15  # clearance beyond which the first choice is taken
_MARGIN = 1e-9  # of the side on which a pole lies of the path, by far above what the path's own rounding moves it


@dataclass(frozen=True)
class Route:
    """v₀, v₁ and the centre x, all exact in float64."""

    centre: float
    v0: complex
    v1: complex

    @property
    def delta(self) -> float:
        return self.v1.imag

    def frequency(self, track: Track, v: Any) -> Any:
        """q(v), for balls or discs v."""
        return v * v * 0.5 + self.centre + track.field.i * track.eta_b

    def inverse(self, track: Track, q: Any) -> Any:
        """v of a ball of q with Re q ≥ 0 on the physical sheet (as seen from below, if on the cut)."""
        z = 2 * (acb(q) - self.frequency(track, acb(0)))
        if z.imag > 0:
            return -z.sqrt()
        if z.imag < 0 or (z.imag.is_zero() and z.real > 0):
            return z.sqrt()
        if z.real < 0:
            return acb(0, -1) * (-z).sqrt()
        raise PrecisionError(
            f"a pole near {acb(q).str(6)} is too close to the cut or a branch point to tell its side"
        )

    def passes_above(self, track: Track, q: Any) -> bool:
        """Whether the contour passes above this pole of the physical sheet, so that it leaves a residue."""
        z, step = self.inverse(track, q) - acb(self.v0), acb(self.v1 - self.v0)
        side = (step.conjugate() * z).imag
        if side < -_MARGIN:
            return True
        if side > _MARGIN:
            return False
        raise PrecisionError(f"a pole near {acb(q).str(6)} is too close to the contour: change a parameter slightly")

    @cached_property
    def start(self) -> float:
        """A lower bound of Re v on the part of the path with Im v ≥ 0."""
        crossing = self.v0.real + (self.v1 - self.v0).real * self.v0.imag / (self.v0.imag - self.delta)
        return min(crossing, self.v1.real) * (1 - 2.0**-20)


def route(
    case: Case, track: Track, poles: Sequence[complex], extent: float, longest: float, lowered: float = 1
) -> Route:
    """A path with clearance from the poles (in float64).

    extent: the largest distance between positions. longest: the last time. lowered: a factor of the height δ.

    Raises PrecisionError where no path is clear of the poles.
    """
    gap, last = limiting_frequency(case, track.field), branch_points(case)[-1]
    eta_b = float(track.eta_b)
    span = float(case.positions[-1]) - float(case.positions[0])
    heights = [height * float(gap) for height in _HEIGHTS] if gap > _NARROW else []
    heights += [-depth * max(last, _LEAST) for depth in _DEPTHS]
    best, least = None, 20.0
    for turn in _CROSSINGS:
        for height in heights:
            way = _from(last, height, turn, lowered * _height(span, extent), longest)
            if way is None or not _leaves_by_the_cut(way, gap):
                continue
            clearance = min((_distance(way, eta_b, q) for q in poles), default=1.0)
            depth = max(0.0, -eta_b - height)
            # panels shrink towards a pole in steps of 2, and e^{depth τ} costs nodes and digits
            cost = 3 * np.log(_ENOUGH / min(clearance + 1e-9, _ENOUGH)) + depth * longest / 3
            if cost < least:
                best, least = way, cost
    if best is None:
        raise PrecisionError(
            "no path around the branch points is clear of the induced frequencies: change a parameter slightly"
        )
    return best


def _height(span: float, extent: float) -> float:
    """δ: below the zeros of Δ near Im p = ln 2/(2 span), and e^{δ|ξ − x_j|} ≤ e⁴."""
    return min(0.5, np.log(2) / (4 * span) if span else 0.5, 4 / extent if extent else 0.5)


def _from(last: float, height: float, turn: float, delta: float, longest: float) -> Route | None:
    """The path from q = i(η_b + height). For late times it crosses next to the branch point, so as to dip less."""
    v = -np.sqrt(complex(-2 * last, 2 * height)) if height > 0 else np.sqrt(complex(-2 * last, 2 * height))
    x, y = round(v.real * _GRID) / _GRID, round(v.imag * _GRID) / _GRID
    crossing = max(x, turn * min(0.3, 0.3 * abs(y), 1.5 / np.sqrt(max(longest, 1.0))))
    v0 = complex(x, y)
    v1 = complex(crossing + (crossing - x) * delta / -y, delta)
    # a steep path cannot meet the image of the imaginary axis, a hyperbola flatter than 45°, again
    if not (abs((v1 - v0).real) < 0.98 * (v1 - v0).imag and v1.real > crossing / 2):
        return None
    return Route((y * y - x * x) / 2, v0, v1)


def _distance(way: Route, eta_b: float, q: complex) -> float:
    """How far q is from the steep part of the path, in v."""
    z = 2 * (q - way.centre - 1j * eta_b)
    v = np.sqrt(complex(z))
    v = -v if v.imag > 0 else v
    t = np.clip(((v - way.v0) * (way.v1 - way.v0).conjugate()).real / abs(way.v1 - way.v0) ** 2, 0, 1)
    return float(abs(v - way.v0 - t * (way.v1 - way.v0)))


def _leaves_by_the_cut(way: Route, gap: Any) -> bool:
    """Whether it is proved that the path leaves the physical sheet through the cut, and nowhere else."""
    step, v0 = acb(way.v1) - acb(way.v0), acb(way.v0)
    on_axis = v0 + step * (-v0.imag / step.imag)  # where Im v = 0
    beneath = v0.imag - step.imag * v0.real / step.real if not step.real.contains(0) else arb(0)
    through_gap = way.v0.real > 0 or way.centre - beneath * beneath / 2 < gap
    return bool(on_axis.real > 0 and way.centre + arb(way.start) ** 2 / 2 > gap and through_gap and way.start > 0)


@dataclass(frozen=True)
class Guide:
    """Approximate p-roots along the route in float64, upper ones first: seeds, of which nothing is believed."""

    track: Track  # float64
    route: Route
    places: Any  # v along the route
    roots: Any  # shape (places, 4)

    def seeds(self, v: Any) -> Any:
        """The p-roots at points v near the route, shape (4, *v.shape), by Newton's method from the nearest place."""
        w = np.sqrt(v * v + 2 * self.route.centre)
        w = np.where(w.real < 0, -w, w)
        along = self.places.real + self.places.imag  # which grows along the route
        order = np.minimum(np.searchsorted(along, v.real + v.imag), len(along) - 1)
        near = np.moveaxis(self.roots[order], -1, 0)
        far = np.abs(w) > _FAR
        p = np.where(far, _asymptotes(self.track, w), near)
        A, r = self.track.A, self.route.centre + v * v / 2
        with np.errstate(all="ignore"):
            for _ in range(8):
                value = ((p * p - 4 * A) * p + 8 * self.track.alpha * r) * p + 4 * (self.track.beta2 - r * r)
                p = p - value / ((4 * p * p - 8 * A) * p + 8 * self.track.alpha * r)
        return p


def guide(track: Track, way: Route) -> Guide:
    """Follows the p-roots along the route from the physical sheet, by nearest neighbours in float64."""
    steep = way.v0 + (way.v1 - way.v0) * np.linspace(0, 1, 500)
    flat = way.v1 + np.arange(0.0, _FAR + 2, 0.02)
    v = np.concatenate([steep, flat])
    r = way.centre + v * v / 2
    companion = np.zeros((len(v), 4, 4), complex)
    companion[:, 0, 1], companion[:, 0, 2] = 4 * track.A, -8 * track.alpha * r
    companion[:, 0, 3] = -4 * (track.beta2 - r * r)
    companion[:, [1, 2, 3], [0, 1, 2]] = 1
    roots = np.linalg.eigvals(companion)
    roots[0] = roots[0][np.argsort(-roots[0].imag)]
    for k in range(1, len(v)):
        left = roots[k].tolist()
        for j, before in enumerate(roots[k - 1].tolist()):
            roots[k, j] = left.pop(int(np.argmin(np.abs(np.array(left) - before))))
    last = _asymptotes(track, np.sqrt(v[-1] ** 2 + 2 * way.centre))
    return Guide(track, way, v, roots[:, [int(np.argmin(np.abs(roots[-1] - p))) for p in last]])


def _asymptotes(track: Track, w: Any) -> Any:
    """The p-roots far out, in order."""
    return np.stack([-w - track.alpha, 1j * w + track.alpha, w - track.alpha, -1j * w + track.alpha])


def float_track(case: Case) -> Track:
    return track(case, Float64())
