"""All zeros of R·Δ on the edge of the cut, over a range of velocity ratios: isolated, sharpened, proved complete."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import flint
import numpy as np

from mpsolve.discs import DiscField
from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import Track, track
from mpsolve.problem.case import Case
from mpsolve.sheet.far import far_radius
from mpsolve.stability.exclude import inside
from mpsolve.stability.holes import about, exact, holds, inward, outward
from mpsolve.stability.krawczyk import ball_of, contracted, newton_step
from mpsolve.stability.rim import edge_ball, slopes_ball, value_ball
from mpsolve.stability.rimboxes import Region, assess
from mpsolve.stability.search import Strip

acb, arb = flint.acb, flint.arb
_BITS = 64
_GUARD = 24
_CHUNK = 8192
_ROUNDS = 10
_LEVELS = 6  # of halving in each round
_SMALL = 2.0**-11  # boxes of this size are looked at group by group
_MANY, _EFFORT = 20_000, 150_000  # boxes at which a group is given up
_SEEDS = 24
_DRIFT = 0.1  # how far from its start in α Newton's method is trusted
_FAR_PARTS = 8
_ROWS = 8
_CELL = 0.25  # width in p of the first boxes


@dataclass(frozen=True)
class EdgeZero:
    """At the wave number `p` and `alpha` (balls) R·Δ vanishes on the edge, at q = r + iη_b, once in the box
    centre ± reach (p, alpha), which is proved exactly.

    side: of the cut, "below" or "above". appears: whether the root comes to the sheet as α grows, or leaves it.
    """

    p: Any
    alpha: Any
    r: Any
    centre: tuple[Fraction, Fraction]
    reach: float
    side: str = ""
    appears: bool = False

    @property
    def hole(self) -> tuple[float, float, float, float]:
        """The box of uniqueness, rounded inward: p from, p to, α from, α to."""
        p, t = (inward(about(c, self.reach)) for c in self.centre)
        return *p, *t

    @property
    def span(self) -> tuple[float, float]:
        """The box's range of α, rounded outward."""
        return outward(about(self.centre[1], self.reach))


@dataclass(frozen=True)
class EdgeZeros:
    """The zeros with Re q ≥ 0 by ascending α: all of the range outside of the strips."""

    zeros: tuple[EdgeZero, ...]
    strips: tuple[Strip, ...]
    evaluations: int


def edge_zeros(case: Case, low: float, high: float, digits: int, budget: int) -> EdgeZeros:
    """Every zero on the edge for low ≤ α ≤ high; what the budget of boxes leaves open comes back as strips."""
    try:
        radius, left, right = _reach(case, low, high)
    except PrecisionError as error:
        return EdgeZeros((), (Strip(low, high, str(error)),), 0)
    arithmetic: Any = DiscField()
    search = _Search(case, track(case, arithmetic), radius, budget)
    parked = search.sweep(_first_boxes(left, right, low, high))
    strips = [strip for group in _groups(parked) for strip in search.resolve(group)]
    zeros, more = _finished(case, search.found, low, high, digits)
    return EdgeZeros(zeros, tuple(_merged([*strips, *more])), search.spent)


class _Search:
    """What has been found, and spent, so far."""

    def __init__(self, case: Case, discs: Track, radius: float, budget: int) -> None:
        self.case, self.discs, self.radius, self.budget = case, discs, radius, budget
        self.found: list[EdgeZero] = []
        self.spent = 0

    def sweep(self, boxes: Region) -> Region:
        """Halves boxes until each is proved to hold no zero, or is small, or the budget is spent."""
        parked = [np.zeros((0, 4))]
        while len(boxes) and self.spent <= self.budget:
            boxes = self._halved(boxes)
            p0, p1, t0, t1 = boxes.T
            small = (t1 - t0 < _SMALL) & (p1 - p0 < _SMALL)
            parked.append(boxes[small])
            boxes = boxes[~small]
        return np.concatenate([*parked, boxes])

    def resolve(self, boxes: Region) -> list[Strip]:
        """Looks for the zeros among the boxes of one range of α, and proves that there is none beside them."""
        reason, limit = "the edge of the cut is not resolved at this effort: shorten the range of alpha", self.spent
        failed: list[tuple[Any, Any]] = []
        for turn in range(_ROUNDS):
            for p, t in _cells(boxes, 2.0 ** (-6 - 2 * turn)):
                point = _approach(self.case, p, t)
                if point is None or abs(float(point[1]) - t) > _DRIFT or _near(point, failed):
                    continue
                if any(_within(point, zero) for zero in self.found):
                    continue
                try:
                    self.found.append(_isolate(self.case, self.discs, *point))
                except PrecisionError as error:
                    reason = str(error)
                    failed.append(point)
            for _ in range(_LEVELS):
                boxes = self._halved(boxes)
            if not len(boxes):
                return []
            if len(boxes) > _MANY or self.spent - limit > _EFFORT:
                break
        return _strips(boxes, reason)

    def _halved(self, boxes: Region) -> Region:
        """Both halves of each box that is not proved to hold no zero but known ones."""
        holes = np.array([zero.hole for zero in self.found]).reshape(-1, 4)
        self.spent += len(boxes)
        parts = [np.zeros((0, 4))]
        for start in range(0, len(boxes), _CHUNK):
            chunk = boxes[start : start + _CHUNK]
            seen = assess(self.discs, chunk, self.radius)
            keep = ~(seen.free | inside(chunk, holes))
            parts.append(_halves(chunk[keep], seen.across[keep]))
        return np.concatenate(parts)


def _groups(boxes: Region) -> list[Region]:
    """The boxes by the connected ranges of α that they cover."""
    if not len(boxes):
        return []
    boxes = boxes[np.argsort(boxes[:, 2])]
    tops = np.maximum.accumulate(boxes[:, 3])
    return list(np.split(boxes, np.flatnonzero(boxes[1:, 2] > tops[:-1]) + 1))


def _cells(boxes: Region, size: float) -> list[tuple[float, float]]:
    """Middles of boxes, one for each cell of this size that they lie in."""
    middles = np.stack([(boxes[:, 0] + boxes[:, 1]) / 2, (boxes[:, 2] + boxes[:, 3]) / 2], axis=1)
    _, first = np.unique(np.floor(middles / size), axis=0, return_index=True)
    return [(float(p), float(t)) for p, t in middles[first[:_SEEDS]]]


def _merged(strips: list[Strip]) -> list[Strip]:
    """In order, and those that nearly touch as one."""
    result: list[Strip] = []
    for strip in sorted(strips, key=lambda s: s.start):
        if result and strip.start <= result[-1].end + _SMALL:
            last = result.pop()
            strip = Strip(last.start, max(last.end, strip.end), last.reason)
        result.append(strip)
    return result


def _reach(case: Case, low: float, high: float) -> tuple[float, float, float]:
    """(a radius beyond which no root lies; p left and p right, beyond which r is larger)."""
    radius = 0.0
    with ball_arithmetic(_BITS) as field:
        model = track(case, field)
        ends = np.linspace(low, high, _FAR_PARTS + 1)
        for a, b in pairwise(ends.tolist()):
            radius = max(radius, far_radius(replace(model, alpha=arb(a).union(arb(b)))))
        right = math.sqrt(2 * radius + 2 * abs(float(model.axial))) + 1
        left = -right - 2 * high
        # beyond √max(2N, 0) the slope of r grows with |p|: S'' > 0 there
        for p, alpha, sign in ((left, high, -1), (right, low, 1)):
            edge = edge_ball(replace(model, alpha=arb(alpha)), arb(p))
            if not (edge.r > radius and sign * edge.r_rate > 0 and p * p > 2 * float(model.axial) + 1e-9):
                raise PrecisionError("the edge of the cut could not be bounded: shorten the range of alpha")
    return radius, left, right


def _first_boxes(left: float, right: float, low: float, high: float) -> Region:
    p = np.linspace(left, right, max(8, math.ceil((right - left) / _CELL)) + 1)
    t = np.linspace(low, high, _ROWS + 1)
    return np.array([(a, b, c, d) for a, b in pairwise(p.tolist()) for c, d in pairwise(t.tolist())])


def _halves(boxes: Region, across: Any) -> Region:
    p0, p1, t0, t1 = boxes.T
    p, t = (p0 + p1) / 2, (t0 + t1) / 2
    first = np.stack([p0, np.where(across, p, p1), t0, np.where(across, t1, t)], axis=1)
    second = np.stack([np.where(across, p, p0), p1, np.where(across, t0, t), t1], axis=1)
    return np.concatenate([first, second])


def _strips(boxes: Region, reason: str) -> list[Strip]:
    spans: list[list[float]] = []
    for _, _, t0, t1 in sorted(boxes.tolist(), key=lambda box: box[2]):
        if spans and t0 <= spans[-1][1]:
            spans[-1][1] = max(spans[-1][1], t1)
        else:
            spans.append([t0, t1])
    return [Strip(a, b, reason) for a, b in spans]


# --- one zero -----------------------------------------------------------------------------------------------


def _approach(case: Case, p: float, t: float) -> tuple[Any, Any] | None:
    """Newton's method on midpoints from (p, t): a point near a zero, or None. Heuristic."""
    with ball_arithmetic(_BITS) as field:
        model = track(case, field)
        here = arb(p), arb(t)
        for _ in range(14):
            try:
                step = _newton_step(model, *here)
            except PrecisionError:
                return None
            if step is None:
                return None
            here = (here[0] - step[0]).mid(), (here[1] - step[1]).mid()
            if not (abs(float(here[0])) < 1e6 and abs(float(here[1])) < 1e3):
                return None
            if max(abs(float(s)) for s in step) < 1e-13:
                return here
    return None


def _newton_step(model: Track, p: Any, t: Any) -> tuple[Any, Any] | None:
    return newton_step(*slopes_ball(replace(model, alpha=t), p))


def _isolate(case: Case, discs: Track, p: Any, t: Any) -> EdgeZero:
    """The largest box about the point that is proved to hold exactly one zero (Krawczyk)."""
    p, t = p.mid(), t.mid()
    with ball_arithmetic(_BITS) as field:
        model = track(case, field)
        found = _widest(discs, float(p), float(t))
        for k in range(8, 46, 2):
            image = _krawczyk(model, p, t, 2.0**-k)
            if image is not None:
                centre, reach = (exact(p), exact(t)), 2.0**-k
                # the wider box counts only where it holds the zero of the image
                if found and all(holds(about(c, found[1]), v) for c, v in zip(found[0], image, strict=True)):
                    centre, reach = found if found[1] > reach else (centre, reach)
                return EdgeZero(*image, edge_ball(replace(model, alpha=image[1]), image[0]).r, centre, reach)
    raise PrecisionError(
        f"a root touches the cut near alpha = {float(t):.8g}, or two cut points are too close to be told apart"
    )


def _widest(discs: Track, p: float, t: float) -> tuple[tuple[Fraction, Fraction], float] | None:
    """(centre, reach) of the widest box next to the point for which discs prove that it holds exactly one zero."""
    reaches = 2.0 ** -np.arange(3.0, 26.0)
    boxes = np.stack([p - reaches, p + reaches, t - reaches, t + reaches], axis=1)
    seen = assess(discs, boxes, math.inf)
    for k, box in enumerate(boxes.tolist()):
        if seen.sure[k]:
            # the ends of the boxes are rounded, and `assess` takes the middles of what they are
            p0, p1, t0, t1 = map(Fraction, box)
            middle = (box[0] + box[1]) / 2, (box[2] + box[3]) / 2
            x, y = map(Fraction, middle)
            reach = inward((Fraction(0), min(p1 - x, x - p0, t1 - y, y - t0)))[1]
            f, along_p, along_t = (ball_of(z, k) for z in (seen.value, seen.along_p, seen.along_alpha))
            if contracted(f, along_p, along_t, arb(middle[0]), arb(middle[1]), reach, reach) is not None:
                return (x, y), reach
    return None


def _krawczyk(model: Track, p: Any, t: Any, reach: float) -> tuple[Any, Any] | None:
    """The image of the box p ± reach, t ± reach, if it is proved to hold exactly one zero."""
    spread = arb(0, reach)
    try:
        _, along_p, along_t = slopes_ball(replace(model, alpha=t + spread), p + spread)
        f = value_ball(replace(model, alpha=t), p)
    except PrecisionError:
        return None
    return contracted(f, along_p, along_t, p, t, reach, reach)


def _within(point: tuple[Any, Any], zero: EdgeZero) -> bool:
    p0, p1, t0, t1 = zero.hole
    return p0 <= float(point[0]) <= p1 and t0 <= float(point[1]) <= t1


def _near(point: tuple[Any, Any], others: list[tuple[Any, Any]]) -> bool:
    return any(abs(float(point[0] - p)) + abs(float(point[1] - t)) < 1e-9 for p, t in others)


def _finished(
    case: Case, found: list[EdgeZero], low: float, high: float, digits: int
) -> tuple[tuple[EdgeZero, ...], list[Strip]]:
    """The distinct zeros of the range, sharpened, with side and direction; and strips about those that resist."""
    zeros: list[tuple[EdgeZero, EdgeZero]] = []  # each with the box that holds no other
    strips: list[Strip] = []
    for rough in found:
        if rough.alpha < low or rough.alpha > high or rough.r < 0:
            continue
        try:
            zero = _sharpened(case, rough, digits)
        except PrecisionError as error:
            strips.append(Strip(*rough.span, str(error)))
            continue
        if zero.r < 0 or any(_same(case, zero, box) for box, _ in zeros):
            continue
        if any(_close(zero, other) for _, other in zeros):
            strips.append(Strip(*rough.span, "two cut points could not be told apart"))
            continue
        zeros.append((rough, zero))
    return tuple(sorted((zero for _, zero in zeros), key=lambda z: float(z.alpha.mid()))), strips


def _same(case: Case, zero: EdgeZero, box: EdgeZero) -> bool:
    """Whether the zero is proved to be the one of the box: it lies there, or the other wave number of its point does.

    Where the cuts have joined, two real p-roots are upper ones, and either stands for the point of the edge.
    """
    if _holds(box, zero.p, zero.alpha):
        return True
    try:
        with ball_arithmetic(_BITS + 32) as field:
            other = edge_ball(replace(track(case, field), alpha=zero.alpha), zero.p).roots.b
    except PrecisionError:
        return False
    return bool(other.imag.is_zero()) and _holds(box, other.real, zero.alpha)


def _close(one: EdgeZero, two: EdgeZero) -> bool:
    return one.side == two.side and one.alpha.overlaps(two.alpha) and one.r.overlaps(two.r)


def _holds(box: EdgeZero, p: Any, alpha: Any) -> bool:
    p0, p1, t0, t1 = box.hole
    return bool(p > p0 and p < p1 and alpha > t0 and alpha < t1)


def _sharpened(case: Case, rough: EdgeZero, digits: int) -> EdgeZero:
    """The zero to so many digits, by Newton's method and one last proof in a tiny box within the first one."""
    goal = math.ceil(digits * math.log2(10)) + _GUARD
    p, t = rough.p.mid(), rough.alpha.mid()
    ladder = [goal + _GUARD]
    while ladder[0] > 2 * _BITS:
        ladder.insert(0, ladder[0] // 2 + 8)
    for bits in ladder:
        with ball_arithmetic(bits + 32) as field:
            step = _newton_step(track(case, field), p, t)
            if step is None:
                raise PrecisionError("Newton's method lost a cut point while sharpening it: ask for fewer digits")
            p, t = (p - step[0]).mid(), (t - step[1]).mid()
    with ball_arithmetic(goal + 4 * _GUARD) as field:
        model = track(case, field)
        for slack in range(2, 20, 3):
            image = _krawczyk(model, p, t, 2.0 ** (slack - goal))
            if image is not None and rough.p.contains(image[0]) and rough.alpha.contains(image[1]):
                return _described(model, rough, *image)
    raise PrecisionError(f"a cut point could not be sharpened to {digits} digits")


def _described(model: Track, rough: EdgeZero, p: Any, t: Any) -> EdgeZero:
    """Side and direction: p = a is an upper p-root, so that the root is one of the sheet where Im p > 0."""
    there = replace(model, alpha=t)
    edge = edge_ball(there, p)
    _, along_p, along_t = slopes_ball(there, p)
    turn = (along_p.conjugate() * along_t).imag  # −|F_p|² Im dp/dα
    lean = edge.r_rate
    if not ((turn > 0 or turn < 0) and (lean > 0 or lean < 0)):
        raise PrecisionError("which side of the cut a root reaches, or whether it appears, is open")
    r = edge.r
    if r.contains(0) and r.rad() < 1e-9 * rough.reach * abs(lean).lower():
        r = arb(0)  # the mirror image −r lies in the box that holds one zero
    return EdgeZero(p, t, r, rough.centre, rough.reach, "below" if lean < 0 else "above", bool(turn < 0))
