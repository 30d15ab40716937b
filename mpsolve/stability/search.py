"""All real zeros (x, t) of a family in a region, proved complete; what is undecided comes back as strips of t."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import flint
import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.progress import Progress
from mpsolve.stability.exclude import Job, Region, grid, inside
from mpsolve.stability.family import Family
from mpsolve.stability.together import Search
from mpsolve.stability.zero import BITS, Zero, approach, isolate, value

arb = flint.arb
_ROUNDS = 12
_LEVELS = 6  # of halving in each round but the first
_BALLS = 600  # evaluations in balls a round
_MERGE = 1.5


@dataclass(frozen=True)
class Strip:
    """start ≤ t ≤ end: what happens there is open, for the reason given."""

    start: float
    end: float
    reason: str


@dataclass(frozen=True)
class Zeros:
    """The zeros, by ascending t: all that lie outside of the strips."""

    zeros: tuple[Zero, ...]
    strips: tuple[Strip, ...]
    evaluations: int


def all_zeros(
    family: Family, reach: float, t0: float, t1: float, budget: int = 3_000_000, tell: Progress | None = None
) -> Search[Zeros]:
    """Every zero with 0 ≤ x ≤ reach and t0 ≤ t ≤ t1 (0 < x for a free mass level): a search, for together.py."""
    boxes, evaluations = grid(reach, t0, t1), 0
    found: list[Zero] = []
    reasons: dict[tuple[int, int], str] = {}
    for turn in range(_ROUNDS):
        if tell is not None:
            tell("excluding", turn / _ROUNDS)
        holes = np.array([zero.hole for zero in found]).reshape(-1, 4)
        few, levels = (160, 64) if not turn else (0, _LEVELS)
        cover = yield Job(family, boxes, holes, few, levels, budget - evaluations)
        boxes, evaluations = cover.open, evaluations + cover.evaluations
        if turn:  # the first time, holes about the zeros are the better remedy
            boxes, spent = _by_balls(family, boxes, holes)
            evaluations += spent
        if not len(boxes) or evaluations > budget:
            break
        for x, t in _centres(boxes) if len(boxes) <= _BALLS else ():
            point = approach(family, x, t)
            if point is None or any(_within(point, zero) for zero in found):
                continue
            try:
                found.append(isolate(family, *point))
            except PrecisionError as error:
                reasons[round(1e6 * float(point[0])), round(1e6 * float(point[1]))] = str(error)
    span = _hull(t0, t1)
    kept = [zero for zero in _distinct(found) if zero.t.overlaps(span) and not zero.x < 0]
    return Zeros(tuple(sorted(kept, key=lambda z: float(z.t.mid()))), _strips(boxes, reasons), evaluations)


def _by_balls(family: Family, boxes: Region, holes: Region) -> tuple[Region, int]:
    """The boxes that balls cannot free either."""
    if len(boxes) > _BALLS:
        return boxes, 0
    stack, left, spent = [tuple(map(float, box)) for box in boxes], [], 0
    with ball_arithmetic(BITS) as field:
        while stack:
            x0, x1, t0, t1 = box = stack.pop()
            spent += 1
            if inside(np.array([box]), holes)[0]:
                continue
            try:
                f = value(family, field, _hull(x0, x1), _hull(t0, t1))
                if f.is_finite() and not f.contains(0):
                    continue
            except PrecisionError:
                pass
            left.append(box)
    return np.array(left).reshape(-1, 4), spent


def _hull(a: float, b: float) -> Any:
    return arb(a).union(arb(b))


def _within(point: tuple[Any, Any], zero: Zero) -> bool:
    x0, x1, t0, t1 = zero.hole
    return x0 <= float(point[0]) <= x1 and t0 <= float(point[1]) <= t1


def _distinct(found: list[Zero]) -> list[Zero]:
    """One of those whose boxes of uniqueness hold each other's zero."""
    result: list[Zero] = []
    for zero in found:
        if not any(_holds(other, zero) for other in result):
            result.append(zero)
    return result


def _holds(one: Zero, other: Zero) -> bool:
    """Whether the whole ball of the other zero lies where only one zero is: then they are the same."""
    x0, x1, t0, t1 = one.hole
    return bool(other.x > x0 and other.x < x1 and other.t > t0 and other.t < t1)


def _centres(boxes: Region) -> list[tuple[float, float]]:
    """The middles of the clusters that the boxes form."""
    x0, x1, t0, t1 = boxes.T
    touch = _near(x0, x1) & _near(t0, t1)
    rest, centres = np.ones(len(boxes), dtype=bool), []
    while rest.any():
        cluster = np.zeros(len(boxes), dtype=bool)
        fresh = np.arange(len(boxes)) == np.argmax(rest)
        while fresh.any():
            cluster |= fresh
            fresh = touch[fresh].any(axis=0) & ~cluster
        rest &= ~cluster
        centres.append(tuple((low[cluster].min() + high[cluster].max()) / 2 for low, high in ((x0, x1), (t0, t1))))
    return centres


def _near(low: Any, high: Any) -> Any:
    """Which intervals are nearly as close as their widths, shape (n, n)."""
    width = high - low
    slack = _MERGE * np.maximum(width[:, None], width)
    return (low[:, None] - slack <= high) & (low - slack <= high[:, None])


def _strips(boxes: Region, reasons: dict[tuple[int, int], str]) -> tuple[Strip, ...]:
    """The t-ranges of the open boxes, merged."""
    spans: list[list[float]] = []
    for _, _, t0, t1 in sorted(boxes.tolist(), key=lambda box: box[2]):
        if spans and t0 <= spans[-1][1]:
            spans[-1][1] = max(spans[-1][1], t1)
        else:
            spans.append([t0, t1])
    reason = (
        "; ".join(reasons.values())
        or "the region is not resolved at this effort: prove it in parts, over shorter ranges"
    )
    return tuple(Strip(a, b, reason) for a, b in spans)
