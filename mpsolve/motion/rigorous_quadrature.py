"""Gauss–Legendre panels on the path with a proved error, and the sum over their nodes in balls.

On a panel v = c + h t, −1 ≤ t ≤ 1, the integrand f is analytic and |f| ≤ M in the ellipse with foci ∓1 and semi-axes
(ρ ± 1/ρ)/2, and the rule with n nodes errs by at most (64/15) M ρ^{−2(n−1)}/(1 − ρ^{−2}) (Trefethen, Approximation
Theory and Approximation Practice, Theorem 19.3). M is taken over cells that cover the ellipse; it holds for W̃, while
e^{iqτ} is bounded by the least Im q, so that one set of panels serves all times.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import flint
import numpy as np

from mpsolve.discs import Discs
from mpsolve.errors import PrecisionError
from mpsolve.model.branch import Track
from mpsolve.motion.rigorous_cells import Beam, Cells, cells
from mpsolve.motion.rigorous_path import Guide, Route

acb, arb = flint.acb, flint.arb

RHO = 3
_WIDE, _HIGH = (RHO + 1 / RHO) / 2, (RHO - 1 / RHO) / 2
_COLUMNS, _ROWS = 5, 3  # of cells over the ellipse; odd, so that a middle row holds the panel
_PAD = 1 + 2.0**-20
_ROUNDS = 24  # which keeps panels far above the rounding of their ends
MOST_PANELS = 6_000

Gaps = Sequence[Sequence[tuple[int, Any]]]
Forces = Callable[[Any], Sequence[Any]]  # F_j(q)


@dataclass(frozen=True)
class Panels:
    """Panels between `starts` and `ends` in the order of the path, with their cells (panel by panel).

    For each whether it lies on the flat part, its number of nodes (`orders`), the least Im q on its ellipse
    (`lowest`) and on the panel itself (`beneath`), and bounds of |W̃ dq/dt| on the ellipse, shape (panels, positions).
    """

    starts: Any
    ends: Any
    over: Cells
    flat: Any
    orders: Any
    lowest: Any
    beneath: Any
    bounds: Any

    def errors(self, tau: Any) -> list[Any]:
        """Bounds of what the rules err together at one time, times π, one for each position.

        A rule with positive weights errs by 4 max |f| on the panel at most, which is less where e^{iqτ} has decayed.
        """
        scale, total = arb(64) / 15 / (1 - arb(RHO) ** -2), [arb(0)] * self.bounds.shape[1]
        rows = zip(
            self.bounds.tolist(), self.lowest.tolist(), self.beneath.tolist(), self.orders.tolist(), strict=True
        )
        for bounds, lowest, beneath, order in rows:
            rule = scale * (-tau * arb(lowest)).exp() * arb(RHO) ** (-2 * (order - 1))
            share = rule.min(4 * (-tau * arb(beneath)).exp())
            total = [so_far + bound * share for so_far, bound in zip(total, bounds, strict=True)]
        return total


def panels(
    track: Track, guide: Guide, way: Route, forces: Forces, gaps: Gaps, end: float, times: Any, tolerances: Any
) -> Panels:
    """Panels from v₀ to Re v = end; `track`, forces and gaps in discs.

    Each is to err by less than about the tolerance of each of the times (float64 arrays).

    Raises PrecisionError where more than MOST_PANELS are needed, or W̃ is not proved to be analytic around one.
    """
    points = np.concatenate([way.v0 + (way.v1 - way.v0) * np.arange(8) / 8, _flat(way, end)])
    low, high = points[:-1], points[1:]
    growth = times.max() * max(0.0, -way.frequency(track, Discs(points)).m.imag.min())
    most = 3 + math.ceil((1.25 * math.log(1 / tolerances.min()) + growth) / (2 * math.log(RHO)))
    for _ in range(_ROUNDS):
        over, bounds, lowest = _bounded(track, guide, way, forces, gaps, low, high)
        flat = (low.imag == way.delta) & (high.imag == way.delta)
        beneath = np.where(flat, _level(track, way, low), lowest)
        orders = _orders(bounds, lowest, beneath, times, tolerances)
        good = orders <= most
        if good.all():
            return Panels(low, high, over, flat, orders.astype(int), lowest, beneath, bounds)
        if len(low) + np.sum(~good) > MOST_PANELS:
            break
        middle = (low + high) / 2
        keep = np.repeat(np.arange(len(low)), np.where(good, 1, 2))
        second = np.concatenate([[False], keep[1:] == keep[:-1]])
        first = ~second & ~good[keep]
        low, high = np.where(second, middle[keep], low[keep]), np.where(first, middle[keep], high[keep])
    raise PrecisionError(
        f"the transient part needs more than {MOST_PANELS} panels of its integral: ask for fewer digits, shorter "
        "times, or positions closer to the masses; or a pole lies too close to the path: change a parameter slightly"
    )


def column_of(t: Any) -> Any:
    """The column of the cells that holds the point t of a panel."""
    return np.floor((t + _WIDE) / (2 * _WIDE / _COLUMNS)).astype(int)


def middle_cell(panel: int, column: int) -> int:
    """The cell on the panel itself in this column."""
    return (panel * _COLUMNS + column) * _ROWS + _ROWS // 2


def _flat(way: Route, end: float) -> Any:
    steps = [way.v1]
    while steps[-1].real < end:
        steps.append(complex(min(1.4 * steps[-1].real, end), way.delta))
    return np.array(steps)


def _level(track: Track, way: Route, v: Any) -> Any:
    """A lower bound of Im q = η_b + δ Re v on the flat part of the path, from v on."""
    return (track.eta_b.m.real - track.eta_b.r + way.delta * v.real) * (1 - 2.0**-40)


def _bounded(
    track: Track, guide: Guide, way: Route, forces: Forces, gaps: Gaps, low: Any, high: Any
) -> tuple[Cells, Any, Any]:
    """The cells of the panels, bounds of |W̃ dq/dt| (∞ where not proved) and the least Im q."""
    c, h = (low + high) / 2, (high - low) / 2
    x = (np.arange(_COLUMNS) + 0.5 - _COLUMNS / 2) * (2 * _WIDE / _COLUMNS)
    y = (np.arange(_ROWS) + 0.5 - _ROWS / 2) * (2 * _HIGH / _ROWS)
    t = (x[:, None] + 1j * y).ravel()
    radius = np.abs(h) * math.hypot(_WIDE / _COLUMNS, _HIGH / _ROWS) * _PAD
    v = Discs((c[:, None] + h[:, None] * t).ravel(), np.repeat(radius, len(t)))
    over = cells(track, guide, way, v)
    shape = (len(c), _COLUMNS, _ROWS)
    place = np.arange(len(v.m)).reshape(shape)
    alike = over.known.reshape(shape).all((1, 2))
    alike &= over.alike(place[:, 1:], place[:, :-1]).all((1, 2)) & over.alike(place[:, :, 1:], place[:, :, :-1]).all(
        (1, 2)
    )
    joined = over.alike(place[1:, 1, _ROWS // 2], place[:-1, -2, _ROWS // 2])  # both hold the common end
    alike[1:] &= joined
    alike[:-1] &= joined
    with np.errstate(all="ignore"):
        values = Beam(track, over.split).image(over.q, forces(over.q), gaps)
        size = v.upper * np.repeat(np.abs(h), len(t)) * _PAD
        rows = [np.where(np.isfinite(w.r), w.upper, np.inf) * size for w in values]
        bounds = np.stack([row.reshape(len(c), -1).max(1) for row in rows], -1)
        lowest = (over.q.m.imag - over.q.r).reshape(len(c), -1).min(1) - 2.0**-40
    bounds = np.where(alike[:, None] & np.isfinite(bounds), bounds, np.inf)
    return over, bounds, np.where(np.isfinite(lowest), lowest, 0.0)


def _orders(bounds: Any, lowest: Any, beneath: Any, times: Any, tolerances: Any) -> Any:
    """How many nodes a panel needs, about; ∞ where W̃ is not bounded."""
    with np.errstate(divide="ignore"):
        size = np.log(bounds.max(1))[:, None] - np.log(tolerances) + 2
        gone = np.isfinite(size) & (size - np.outer(beneath, times) < 0)
        excess = np.where(gone, 0.0, size - np.outer(lowest, times)).max(1)
    return 2 * np.ceil(np.maximum(excess / (2 * math.log(RHO)) + 1, 4) / 2)
