"""Roots counted by the argument of Δ̃ round a whole half-plane contour: no formula that closes it.

Along the contour the steps of log Δ̃ stay below STEP in argument and below SIZE in modulus, and neighbouring steps are
of like length, so that a cluster of roots beside the contour cannot hide between two points. Where that cannot be
reached, an Alarm.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from oracle_general.landmarks import crowded

NONE = np.array([])
STEP, SIZE, LIKE, GROWN = 0.45, 0.8, 3.0, 6


class Alarm(ArithmeticError):  # noqa: N818 — it tells, and is not always an error
    """The count is not to be trusted."""


@dataclass
class Turning:
    """Points of the path and the increments of log Δ̃ between them."""

    q: np.ndarray
    increments: np.ndarray

    @property
    def angle(self) -> float:
        return float(self.increments.imag.sum())

    def moment(self, k: int) -> complex:
        """Σ root^k of a closed path, roughly."""
        middle = (self.q[1:] + self.q[:-1]) / 2
        return complex((middle**k * self.increments).sum() / 2j / np.pi)


def turning(log: Callable[[np.ndarray], np.ndarray], path: Callable[[np.ndarray], np.ndarray], start: int = 64,
            most: int = 100_000, step: float = STEP, marks: np.ndarray = NONE) -> Turning:  # fmt: skip
    """The change of log Δ̃ along path(t), 0 ≤ t ≤ 1, refined until every step is small; `marks`: t to begin with."""
    t = np.union1d(np.linspace(0, 1, start + 1), marks[(marks > 0) & (marks < 1)])
    t = t[np.append(True, np.diff(t) > 1e-12)]
    q = path(t)
    L = log(q)
    while True:
        change = L[1:] - L[:-1]
        change = change.real + 1j * (np.remainder(change.imag + np.pi, 2 * np.pi) - np.pi)
        long = np.abs(q[1:] - q[:-1])
        bad = (np.abs(change.imag) > step) | (np.abs(change.real) > SIZE) | ~np.isfinite(change)
        bad[1:] |= long[1:] > LIKE * long[:-1]
        bad[:-1] |= long[:-1] > LIKE * long[1:]
        if not bad.any():
            return Turning(q, change)
        where = np.flatnonzero(bad)
        if len(t) + len(where) > most:
            raise Alarm(f"more than {most} points")
        middle = (t[where] + t[where + 1]) / 2
        if (middle <= t[where]).any() or (long[where] < 1e-14 * np.abs(q[where])).any():
            raise Alarm(f"steps near q = {q[where[int(long[where].argmin())]]} do not become small")
        new = path(middle)
        t, q, L = (np.insert(old, where + 1, value) for old, value in ((t, middle), (q, new), (L, log(new))))


def half_contour(radius: float, level: float, fine: float) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """Axis from iℓ + radius back to iℓ, and arc from iℓ − i radius to iℓ + radius: the right half of the contour."""
    top = np.log1p(radius / fine)

    def axis(t: np.ndarray) -> np.ndarray:
        return 1j * level + fine * np.expm1(top * (1 - t))

    def arc(t: np.ndarray) -> np.ndarray:
        return 1j * level - 1j * radius * np.exp(0.5j * np.pi * t)

    return axis, arc


@dataclass
class Count:
    """Roots with Im q < level and |q − i·level| < radius; smallest steps of the contour."""

    number: int
    radius: float
    points: int


def count_inside(
    problem: Any, radius: float, level: float | None = None, start: int = 64, step: float = STEP
) -> Count:
    """Roots in the half-disc of this radius below the level (default: a hair below the real axis)."""
    level = -1e-9 * problem.scale if level is None else level
    axis, arc = half_contour(radius, level, 1e-8 * problem.scale)
    fine = 1e-8 * problem.scale
    marks = 1 - np.log1p(crowded(problem.landmarks, level) / fine) / np.log1p(radius / fine)
    paths = [
        turning(problem.log_delta, axis, 20 * start, step=step, marks=marks),
        turning(problem.log_delta, arc, start, step=step),
    ]
    turns = sum(path.angle for path in paths) / np.pi
    number = round(turns)
    if abs(turns - number) > 1e-3:
        raise Alarm(f"{turns} turns in radius {radius}: not an integer, so Δ̃ is not real on the imaginary axis")
    return Count(number, radius, sum(len(path.q) for path in paths))


def count_below(problem: Any, level: float | None = None, first: float = 0.0, stays: int = 3, most: int = 24,
                start: int = 64, step: float = STEP) -> Count:  # fmt: skip
    """Roots with Im q < level: the radius is doubled until the count has stayed `stays` times."""
    radius = first or 8 * problem.scale * vehicle_factor(problem)
    last, same, grown, points = 0, 0, 0, 0
    for _ in range(most):
        found = count_inside(problem, radius, level, start, step)
        points += found.points
        same = same + 1 if found.number == last else 0
        grown = grown + 1 if found.number > last else 0
        last = found.number
        if grown >= GROWN:
            break
        if same >= stays:
            return Count(found.number, radius, points)
        radius *= 2
    raise Alarm(f"the count grows with the radius: {last} within {radius / 2}")


def vehicle_factor(problem: Any) -> float:
    """How far above the track's frequency scale the vehicle's own frequencies lie."""
    stiff, inert = np.abs(np.diag(problem.K)), np.abs(np.diag(problem.M))
    own = np.sqrt(stiff[inert > 0] / inert[inert > 0])
    return max(1.0, float(own.max(initial=0.0)) / problem.scale)
