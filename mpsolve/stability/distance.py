"""The critical distance: where between lo and hi the least Im q over all roots is smallest, proved."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

import flint
import numpy as np

from mpsolve.certificate.format import Certificate
from mpsolve.errors import InputError, PrecisionError
from mpsolve.fields import Float64, ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.model.characteristic import characteristic, characteristic_rate
from mpsolve.model.parameters import Case
from mpsolve.numbers.exact import Exact, Number
from mpsolve.numbers.ranges import checked_range
from mpsolve.outcome import Status
from mpsolve.progress import Progress
from mpsolve.sheet.seek import seek
from mpsolve.stability.curvature import convex_branch, motion_with_distance
from mpsolve.stability.family import Family
from mpsolve.stability.masses import checked_digits
from mpsolve.stability.velocities import UnstableRanges, unstable_ranges

acb, arb = flint.acb, flint.arb
_SAMPLES = 64  # distances at which the minimum is looked for, without proof
_LIFTS = (Fraction(1, 50), Fraction(1, 400), Fraction(1, 4000))  # of the line above the minimum, in parts of |Im q|


@dataclass(frozen=True)
class CriticalDistance:
    """The distance d at which the least imaginary part of all induced frequencies is smallest, and the root q there.

    d and q are balls (None if undecided). `ranges` proves that it is the global minimum: the distances at which
    any root lies below a line just above it.
    """

    d: Any | None
    q: Any | None
    status: Status
    reason: str
    digits: int
    ranges: UnstableRanges | None = field(default=None, repr=False)

    @property
    def proved(self) -> bool:
        return self.status.holds

    @property
    def certificate(self) -> Certificate | None:
        return self.ranges.certificate if self.ranges else None


def critical_distance(
    alpha: Number,
    eta_b: Number,
    eta_m: Number | Iterable[Number],
    eta_n: Number = 0,
    eta_s: Number = 0,
    d: tuple[Number, Number] = ("0.3", 5),
    digits: int = 30,
    tell: Progress | None = None,
) -> CriticalDistance:
    """The distance in [lo, hi] that minimises Im q over all roots of Δ, eq. (26): a proved global minimum.

    eta_m: one value for an equal pair, or a list for masses at 0, d, 2d, …. digits: 15 to 10,000 proved digits.
    Proof: below a line just above the minimum there is a root for one interval of distances only, it is one pair
    ±, and there Im q(d) is strictly convex. Raises InputError.

    >>> critical_distance("0.99", "0.5", 70, d=("0.5", 2), digits=15).d.str(8, radius=False)
    '1.1232885'
    """
    digits = checked_digits(digits)
    low, high = checked_range(d, "d")
    if not low > 0:
        raise InputError("d", f"starts at {low.short()}: give a distance above 0")
    masses = (eta_m, eta_m) if not isinstance(eta_m, Iterable) or isinstance(eta_m, str) else tuple(eta_m)
    if len(masses) < 2:
        raise InputError("eta_m", "is one mass: a distance needs two or more")
    places = [low * k for k in range(len(masses))]
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=masses, positions=places, eta_n=eta_n, eta_s=eta_s)
    if not case.eta_b:
        return CriticalDistance(
            None, None, Status.UNDECIDED, "without damping many roots are real: give some", digits
        )
    family = Family(case, "distance")
    try:
        near, q = _sampled_minimum(family, float(low), float(high))
        place, root = _critical_point(family, near, q, digits)
    except PrecisionError as error:
        return CriticalDistance(None, None, Status.UNDECIDED, str(error), digits)
    found = _proved(family, low, high, place, root, digits, tell)
    if not found.proved and near in (float(low), float(high)):
        reason = f"the least imaginary part seems to fall towards the end d = {near:g} of the range: widen it"
        return replace(found, reason=reason)
    return found


def _sampled_minimum(family: Family, low: float, high: float) -> tuple[float, complex]:
    """Where the least Im q may be smallest. Heuristic: the proof does not rest on it."""
    best: tuple[float, float, complex] | None = None
    for x in np.linspace(low, high, _SAMPLES).tolist():
        case = family.case_at(Exact.parse(Fraction(x).limit_denominator(10**6), "d"))
        for candidate in seek(case, 8.0):
            if best is None or candidate.q.imag < best[0]:
                best = candidate.q.imag, x, candidate.q
    if best is None:
        raise PrecisionError("no root was found: the masses may be too small")
    return best[1], best[2]


def _critical_point(family: Family, d: float, q: complex, digits: int) -> tuple[Any, Any]:
    """(d, q) with Im q'(d) = 0, by Newton's method at growing precision; midpoints, without proof."""
    goal = math.ceil(digits * math.log2(10)) + 40
    place, root, bits = arb(d), acb(q), 80
    while True:
        with ball_arithmetic(bits) as balls:
            for _ in range(40 if bits == 80 else 3):
                model = family.at(balls, place)
                for _ in range(4):
                    value, slope = characteristic_rate(model, root)
                    root = (root - value / slope).mid()
                first, second = motion_with_distance(model, root, place)
                step = (first.imag / second.imag).mid()
                if not step.is_finite():
                    raise PrecisionError("the minimum has no curvature, or lies at an end of the range")
                if bits == 80:  # far from the minimum the step is no more than a direction
                    step = arb(max(-0.05, min(0.05, float(step)))) if float(second.imag.mid()) > 0 else arb(0)
                place, root = (place - step).mid(), (root - first * step).mid()
                if abs(step) < arb((1, 8 - bits)):
                    break
        if bits >= goal:
            return place, root
        bits = min(2 * bits - 20, goal)


def _proved(
    family: Family, low: Exact, high: Exact, place: Any, root: Any, digits: int, tell: Progress | None
) -> CriticalDistance:
    reason = "the least imaginary part has two minima that are nearly equal: give a range with one of them"
    for lift in _LIFTS:
        level = _above(root.imag, lift)
        if level > (family.case.eta_b * Fraction(99, 100) if family.case.cuts_on_line else Exact.parse(0, "height")):
            reason = "the minimum lies at the line of the cuts"
            continue
        ranges = unstable_ranges(replace(family, height=level, _fixed={}), low, high, 15, tell)
        single = ranges.proved and len(ranges) == 1 and ranges[0].q_start is not None and ranges[0].q_end is not None
        if not ranges.proved:
            reason = ranges.reason
            continue
        if not single or ranges.passages is None or ranges.passages.counts != (0, 2, 0):
            continue
        try:
            _check_convex(family, ranges[0].start, ranges[0].end, place, root)
            ball, q = _enclosed(family, place, root, digits)
        except PrecisionError as error:
            reason = str(error)
            continue
        return CriticalDistance(ball, q, Status.UNVERIFIED, "", digits, ranges)
    return CriticalDistance(None, None, Status.UNDECIDED, reason, digits)


def _above(value: Any, share: Fraction) -> Exact:
    """A short decimal above the minimum."""
    least = Fraction(float(value))
    target = least + abs(least) * share
    places = max(4, 3 - math.floor(math.log10(abs(float(least)) * float(share))))
    return Exact.parse(Fraction(math.ceil(target * 10**places), 10**places), "height")


def _check_convex(family: Family, start: Any, end: Any, place: Any, root: Any) -> None:
    """Im q'' > 0 on the branch of the root for every distance from start to end. Raises `PrecisionError`."""
    low, high = float(start.lower()) * (1 - 1e-12), float(end.upper()) * (1 + 1e-12)
    here = float(place)
    for count in (64, 512, 4096):
        sides = [np.linspace(here, limit, count + 1) for limit in (low, high)]
        if all(convex_branch(family, edges, _followed(family, edges, complex(root))) for edges in sides):
            return
    raise PrecisionError("the branch of the critical root could not be proved convex up to the ends")


def _followed(family: Family, edges: Any, q: complex) -> Any:
    """The root at each edge, in float64, each from its neighbour."""
    roots = [q]
    model = track(family.case, Float64())
    for d in edges[1:].tolist():
        still = replace(model, positions=tuple(k * d for k in range(len(model.eta_m))))
        for _ in range(4):
            value, slope = characteristic_rate(still, q)
            q = complex(q - value / slope)
        roots.append(q)
    return np.array(roots)


def _enclosed(family: Family, place: Any, root: Any, digits: int) -> tuple[Any, Any]:
    """Balls of relative radius below 10^−digits: Im q' changes its sign between the ends of that of d."""
    goal = math.ceil(digits * math.log2(10)) + 4
    with ball_arithmetic(goal + 30) as balls:
        reach = abs(place) * arb((1, -goal))
        slopes, boxes = [], []
        for d in (place - reach, place + reach):
            model = family.at(balls, d.mid())
            q = _root_ball(model, root, goal)
            slopes.append(motion_with_distance(model, q, d.mid())[0].imag)
            boxes.append(q)
        if not (slopes[0] < 0 and slopes[1] > 0):
            raise PrecisionError("the sign of Im q' is open next to the minimum: ask for fewer digits")
        return place + arb(0, reach.upper()), boxes[0].union(boxes[1])


def _root_ball(model: Any, q: Any, goal: int) -> Any:
    """The one root next to q, by interval Newton."""
    for _ in range(3):
        value, slope = characteristic_rate(model, q)
        q = (q - value / slope).mid()
    size = arb(0, (abs(q) * arb((1, 8 - goal))).upper())
    box = q + acb(size, size)
    image = q - characteristic(model, q) / characteristic_rate(model, box)[1]
    if not box.contains_interior(image):
        raise PrecisionError("the root at the critical distance could not be enclosed")
    return image
