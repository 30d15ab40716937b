"""How far a case is from the nearest change of stability: in velocity, in mass, in distance, each proved or open."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from flint import arb

from mpsolve.certificate.format import Certificate
from mpsolve.errors import MpsolveError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.parameters import Case
from mpsolve.numbers.exact import Exact
from mpsolve.progress import Progress
from mpsolve.stability.family import Family
from mpsolve.stability.masses import CrossingMasses, below_critical, crossing_masses
from mpsolve.stability.velocities import UnstableRanges, unstable_ranges, unstable_velocities

DIGITS = 20
_BITS = 160
_LEAST_VELOCITY = Fraction(7, 5)  # the range of velocity ratios reaches at least so far,
_FEWER = Fraction(1)  # or so far for more than two masses, for which each range takes much longer
_HEADROOM = Fraction(5, 4)
_NEAREST, _FARTHEST = Fraction(1, 5), 4  # distances, in units of that of the case


@dataclass(frozen=True)
class Margin:
    """From the case's own value `here` to the nearest changes of stability below and above it (flint.arb, or None).

    name: "velocity" (values α), "mass" (all masses by a common factor; the case is 1) or "distance" (of neighbours).
    low, high: the range that was searched (high None: infinity). None below or above: proved that stability does not
    change there, if `proved`; else open, with the `reason`; free: the range around `here` in which it is proved all
    the same that stability does not change. applies: False where the question has no meaning. stable: whether the
    case itself is proved to be stable by the search, None where it does not tell.
    """

    name: str
    here: Any
    below: Any | None
    above: Any | None
    low: Exact
    high: Exact | None
    proved: bool
    reason: str = ""
    applies: bool = True
    certificate: Certificate | None = None
    free: tuple[Any, Any] | None = None
    stable: bool | None = None

    @property
    def at_least(self) -> Any | None:
        """A distance within which stability is proved not to change, where more is open; None if there is none."""
        if self.free is None:
            return None
        inner = [end for end, last in zip(self.free, (self.low, self.high), strict=True) if not _is(end, last)]
        return min((abs(end - self.here) for end in inner), key=lambda gap: float(gap.mid()), default=None)

    @property
    def nearest(self) -> Any | None:
        """The nearer of the two changes, None if there is none."""
        both = [end for end in (self.below, self.above) if end is not None]
        return min(both, key=lambda end: abs(float((end - self.here).mid())), default=None)


def margins(case: Case, tell: Progress | None = None) -> tuple[Margin, Margin, Margin]:
    """The margins in velocity, mass and distance; what cannot be decided says why."""
    return velocity_margin(case, tell), mass_margin(case, tell), distance_margin(case, tell)


def velocity_margin(case: Case, tell: Progress | None = None) -> Margin:
    """All else as it is, from rest up to 5/4 of the case's own α, and to `least_top` at least."""
    low, high = Exact.parse(0), _decimal_above(max(least_top(case), Fraction(float(case.alpha)) * _HEADROOM))

    def search() -> UnstableRanges:
        model = case.eta_b, case.eta_m, case.positions, case.eta_n, case.eta_s
        return unstable_velocities(*model, (low, high), DIGITS, tell)

    return _of_ranges("velocity", case.alpha, low, high, search)


def least_top(case: Case) -> Fraction:
    """How far a range of velocity ratios reaches at least: 1.4, and 1 for more than two places of masses."""
    return _FEWER if places(case) > 2 else _LEAST_VELOCITY


def places(case: Case) -> int:
    """The number of places at which there are masses."""
    return len(set(case.positions))


def mass_margin(case: Case, tell: Progress | None = None) -> Margin:
    """All masses by one factor in (0, ∞), at the case's velocity."""
    low = Exact.parse(0)

    def open_for(reason: str) -> Margin:
        return Margin("mass", Exact.parse(1).ball(), None, None, low, None, False, reason)

    try:
        found = crossing_masses(
            case.alpha, case.eta_b, case.positions, case.eta_m, case.eta_n, case.eta_s, DIGITS, tell
        )
    except MpsolveError as error:
        return open_for(str(error))
    if not found.proved:
        return open_for(found.reason)
    with ball_arithmetic(_BITS):
        ends, here = _mass_ends(found), Exact.parse(1).ball()
        below, above, reason = _around(here, ends, ())
        stable = None if reason else _stable_among(found, here)
    certificate = found.certificate
    return Margin("mass", here, below, above, low, None, not reason, reason, certificate=certificate, stable=stable)


def distance_margin(case: Case, tell: Progress | None = None) -> Margin:
    """All distances of neighbouring, equally spaced masses, from 1/5 to 4 times that of the case."""
    d = _spacing(case)
    if d is None:
        reason = (
            "there is one mass"
            if case.merged.count < 2
            else "the masses are not equally spaced, so there is no one distance: certify other positions one by one"
        )
        zero = Exact.parse(0)
        return Margin("distance", zero.ball(), None, None, zero, None, False, reason, applies=False)
    size = Fraction(float(d))
    low, high = _decimal_above(size * _NEAREST), _decimal_above(size * _FARTHEST)
    if not case.eta_b:  # below α_C the energy in the moving frame is conserved and positive, whatever the distance
        reason = "" if below_critical(case) else "without damping and from alpha_C on it is not looked for: give some"
        with ball_arithmetic(_BITS):
            zero, stable = Exact.parse(0), None if reason else True
            return Margin("distance", d.ball(), None, None, zero, None, not reason, reason, stable=stable)
    return _of_ranges(
        "distance", d, low, high, lambda: unstable_ranges(Family(case, "distance"), low, high, DIGITS, tell)
    )


def _of_ranges(name: str, here: Exact, low: Exact, high: Exact, search: Callable[[], UnstableRanges]) -> Margin:
    with ball_arithmetic(_BITS):
        ball = here.ball()
    try:
        found = search()
    except MpsolveError as error:
        return Margin(name, ball, None, None, low, high, False, str(error))
    ends = [end for one in found for end, q in ((one.start, one.q_start), (one.end, one.q_end)) if q is not None]
    with ball_arithmetic(_BITS):
        below, above, reason = _around(ball, ends, found.unknown)
        free = _free(ball, [low.ball(), *ends, high.ball()], found.unknown) if reason else None
        stable = _stable_within(found, ball)
    reason = reason and (found.reason or reason)
    return Margin(name, ball, below, above, low, high, not reason, reason, True, found.certificate, free, stable)


def _around(here: Any, ends: Iterable[Any], unknown: tuple[tuple[float, float], ...]) -> tuple[Any, Any, str]:
    """The last end proved to lie below `here`, the first above it, and why this is open ("" if it is not)."""
    ordered = list(ends)
    if any(not (end < here or end > here) for end in ordered):
        return None, None, "the case lies on a change of stability, or too close to one to tell"
    below = max((end for end in ordered if end < here), key=lambda end: float(end.mid()), default=None)
    above = min((end for end in ordered if end > here), key=lambda end: float(end.mid()), default=None)
    for start, stop in unknown:
        beyond_below = below is not None and below > stop
        beyond_above = above is not None and above < start
        if not (beyond_below or beyond_above):
            return None, None, "a part of the range next to the case is open"
    return below, above, ""


def _free(here: Any, ends: list[Any], unknown: tuple[tuple[float, float], ...]) -> tuple[Any, Any] | None:
    """The nearest place on each side beyond which stability is open or changes; None if it is open at `here`."""
    if any(not (stop < here or start > here) for start, stop in unknown):
        return None
    left = [end for end in [*ends, *(arb(stop) for _, stop in unknown)] if end < here]
    right = [end for end in [*ends, *(arb(start) for start, _ in unknown)] if end > here]
    if not left or not right or any(not (end < here or end > here) for end in ends):
        return None
    return max(left, key=lambda end: float(end.mid())), min(right, key=lambda end: float(end.mid()))


def _stable_within(found: UnstableRanges, here: Any) -> bool | None:
    """Whether `here` lies in none of the unstable ranges, as they prove; None if it may lie in an open part."""
    for start, stop in found.unknown:
        if not (_widened(stop) < here or _widened(start) > here):
            return None
    if any(one.start < here < one.end for one in found):
        return False
    return True if all(one.end < here or one.start > here for one in found) else None


def _widened(end: float) -> Any:
    """A ball around the float64 end of an open part that holds the end itself."""
    return arb(end, abs(end) * 2.0**-50)


def _stable_among(found: CrossingMasses, here: Any) -> bool | None:
    """Whether no root is unstable between the crossings on both sides of `here`; none of them may meet it."""
    count = found.counts[sum(bool(one.eta < here) for one in found)]
    return None if count is None or any(one.eta.overlaps(here) for one in found) else not count


def _is(end: Any, last: Exact | None) -> bool:
    """Whether `end` is where the search ended, and not a change of stability or an open part."""
    return last is not None and bool(end.overlaps(last.ball()))


def _mass_ends(found: CrossingMasses) -> list[Any]:
    """The levels at which the case becomes unstable or stable, not those that only add a pair of unstable roots."""
    changes = zip(found, pairwise(found.counts), strict=True)
    return [crossing.eta for crossing, (before, after) in changes if bool(before) != bool(after)]


def _spacing(case: Case) -> Exact | None:
    """The distance of neighbouring masses if it is the same for all, at two or more places; decided exactly."""
    try:
        gaps = [after - before for before, after in pairwise(case.merged.positions)]
    except (ValueError, MpsolveError):
        return None
    return gaps[0] if gaps and all(gap == gaps[0] for gap in gaps) else None


def _decimal_above(x: Fraction) -> Exact:
    """A decimal of two digits, or a few more, not below x > 0."""
    place = math.floor(math.log10(float(x))) - 1
    unit = Fraction(10) ** place
    return Exact.parse(math.ceil(x / unit) * unit)
