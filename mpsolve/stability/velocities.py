"""The velocity ratios at which a case is unstable: ordered intervals with proved ends, and the first onset."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, overload

import flint

from mpsolve.certificate.crossings import crossings_certificate
from mpsolve.certificate.format import Certificate
from mpsolve.errors import InputError, PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.limits import critical_velocity_ratio
from mpsolve.numbers.exact import Exact, Number
from mpsolve.numbers.ranges import checked_range
from mpsolve.outcome import Status
from mpsolve.problem.case import Case
from mpsolve.progress import Progress
from mpsolve.stability.family import Family
from mpsolve.stability.guess import guess_first
from mpsolve.stability.holes import exact
from mpsolve.stability.masses import checked_digits
from mpsolve.stability.passages import Passages, counted, passing
from mpsolve.stability.search import Strip
from mpsolve.stability.together import Search, alone
from mpsolve.stability.zero import Zero

arb = flint.arb
_STRIDE = Fraction(7, 20)  # of the velocity ratio, when the first onset is not where it was expected


@dataclass(frozen=True)
class Interval:
    """Unstable for start < t < end (flint.arb balls): the case has `roots` or more unstable roots there, in pairs.

    q_start, q_end: the real frequency at which the root crosses; None where the end is that of the range asked
    for (the ball is then exact), and not a crossing.
    """

    start: Any
    end: Any
    q_start: Any | None
    q_end: Any | None
    roots: int


@dataclass(frozen=True)
class UnstableRanges(Sequence[Interval]):
    """The unstable intervals of one parameter, in order. Everything between them is proved stable if `proved`.

    Otherwise `strips` are the ranges that are open, each with its reason; outside of them the intervals hold
    as far as they are given, and `unknown` are the ranges whose stability is open.
    """

    parameter: str
    start: Exact
    end: Exact
    intervals: tuple[Interval, ...]
    unknown: tuple[tuple[float, float], ...]
    strips: tuple[Strip, ...]
    status: Status
    reason: str
    digits: int
    passages: Passages | None = field(default=None, repr=False)
    certificate: Certificate | None = field(default=None, repr=False)

    @property
    def proved(self) -> bool:
        return self.status.holds

    def __len__(self) -> int:
        return len(self.intervals)

    @overload
    def __getitem__(self, index: int) -> Interval: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Interval, ...]: ...
    def __getitem__(self, index: int | slice) -> Interval | tuple[Interval, ...]:
        return self.intervals[index]


def unstable_velocities(
    eta_b: Number,
    eta_m: Number | Iterable[Number],
    positions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    alpha: tuple[Number, Number] = (0, Fraction(7, 5)),
    digits: int = 30,
    tell: Progress | None = None,
) -> UnstableRanges:
    """All velocity ratios in [lo, hi] at which a root of Δ, eq. (26), has Im q < 0, proved.

    digits: 15 to 10,000 proved digits of each end. Each end is a certified crossing of the real axis; no root
    crosses anywhere else for any velocity of the range, and a certified count fixes the number of unstable roots.
    Raises InputError.

    >>> [interval.start.str(10, radius=False) for interval in unstable_velocities("0.05", (70, 70), (0, "1.5"))]
    ['0.6669189573']
    """
    return alone(velocities_search(eta_b, eta_m, positions, eta_n, eta_s, alpha, digits, tell))


def velocities_search(
    eta_b: Number,
    eta_m: Number | Iterable[Number],
    positions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    alpha: tuple[Number, Number] = (0, Fraction(7, 5)),
    digits: int = 30,
    tell: Progress | None = None,
) -> Search[UnstableRanges]:
    """`unstable_velocities` as a search, for together.py."""
    case, low, high = _admitted(eta_b, eta_m, positions, eta_n, eta_s, alpha)
    digits = checked_digits(digits)
    if not case.eta_b:
        return _undamped(case, low, high, digits)
    return (yield from ranges_search(Family(case, "alpha"), low, high, digits, tell))


def onset_velocity(
    eta_b: Number,
    eta_m: Number | Iterable[Number],
    positions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    alpha: tuple[Number, Number] = (0, 2),
    digits: int = 30,
    tell: Progress | None = None,
) -> Onset:
    """The first velocity ratio in [lo, hi] at which the case becomes unstable: `.alpha`, with `.q`, or None if none.

    Everything below it is proved stable. Raises InputError.

    >>> onset_velocity("0.05", (70, 70), (0, 1)).alpha.str(10, radius=False)
    '0.9619574863'
    """
    return alone(onset_search(eta_b, eta_m, positions, eta_n, eta_s, alpha, digits, tell))


def onset_search(
    eta_b: Number,
    eta_m: Number | Iterable[Number],
    positions: Number | Iterable[Number] | None = None,
    eta_n: Number = 0,
    eta_s: Number = 0,
    alpha: tuple[Number, Number] = (0, 2),
    digits: int = 30,
    tell: Progress | None = None,
) -> Search[Onset]:
    """`onset_velocity` as a search, for together.py."""
    case, low, high = _admitted(eta_b, eta_m, positions, eta_n, eta_s, alpha)
    digits = checked_digits(digits)
    if not case.eta_b:
        return _first(_undamped(case, low, high, digits))
    family, end = Family(case, "alpha"), low
    expected = guess_first(family, float(low), float(high))
    while True:
        stride = _STRIDE if expected is None else Fraction(round(expected * 1000) + 10, 1000) - end.as_fraction()
        end, expected = min(high, Exact.parse(end.as_fraction() + stride, "alpha"), key=float), None
        scan = yield from ranges_search(family, low, end, digits, tell)
        if len(scan) or scan.unknown or end >= high:
            return _first(scan)


@dataclass(frozen=True)
class Onset:
    """The first onset: alpha and q are balls, None if the range is stable (proved) or the onset is open.

    `stable_below` ends the range that is proved stable if the onset is open.
    """

    alpha: Any | None
    q: Any | None
    status: Status
    reason: str
    stable_below: float
    ranges: UnstableRanges = field(repr=False)

    @property
    def proved(self) -> bool:
        return self.status.holds

    @property
    def certificate(self) -> Certificate | None:
        return self.ranges.certificate


def _first(scan: UnstableRanges) -> Onset:
    opening = scan.unknown[0][0] if scan.unknown else float(scan.end)
    if len(scan) and scan[0].q_start is not None and float(scan[0].start.mid()) <= opening:
        first = scan[0]
        return Onset(first.start, first.q_start, Status.UNVERIFIED, "", float(first.start.mid()), scan)
    if len(scan) and not scan.unknown:  # unstable from the start of the range on
        first = scan[0]
        return Onset(first.start, first.q_start, Status.UNVERIFIED, "", float(first.start.mid()), scan)
    if scan.unknown:
        return Onset(None, None, Status.UNDECIDED, scan.reason, opening, scan)
    return Onset(None, None, Status.UNVERIFIED, "", opening, scan)


def _admitted(
    eta_b: Number, eta_m: Any, positions: Any, eta_n: Number, eta_s: Number, alpha: Any
) -> tuple[Case, Exact, Exact]:
    low, high = checked_range(alpha, "alpha")
    if low < 0:
        raise InputError("alpha", f"starts at {low.short()}: a velocity ratio is not negative")
    case = Case(alpha=low, eta_b=eta_b, eta_m=eta_m, positions=positions, eta_n=eta_n, eta_s=eta_s)
    return case, low, high


def unstable_ranges(
    family: Family, low: Exact, high: Exact, digits: int, tell: Progress | None = None
) -> UnstableRanges:
    """The ranges of the family's parameter with a root below its line; for damped cases."""
    return alone(ranges_search(family, low, high, digits, tell))


def ranges_search(
    family: Family, low: Exact, high: Exact, digits: int, tell: Progress | None = None
) -> Search[UnstableRanges]:
    """`unstable_ranges` as a search, for together.py."""
    try:
        found = yield from passing(family, low, high, digits, tell=tell)
    except PrecisionError as error:
        everything = ((float(low), float(high)),)
        strip = Strip(float(low), float(high), str(error))
        return UnstableRanges(
            family.parameter, low, high, (), everything, (strip,), Status.UNDECIDED, str(error), digits
        )
    intervals, unknown = _intervals(found)
    reason = ""
    if not found.proved:
        reason = found.strips[0].reason if found.strips else "no certified count could be had in a part of the range"
    certificate = crossings_certificate(found)
    status = Status.UNVERIFIED if found.proved else Status.UNDECIDED
    return UnstableRanges(
        family.parameter, low, high, intervals, unknown, found.strips, status, reason, digits, found, certificate
    )


def _intervals(found: Passages) -> tuple[tuple[Interval, ...], tuple[tuple[float, float], ...]]:
    """Runs of gaps with roots below the line; gaps and strips whose count is open."""
    intervals: list[Interval] = []
    unknown: list[tuple[float, float]] = []
    opening: tuple[Any, Any, int] | None = None
    for k, count in enumerate(found.counts):
        before = found.events[k - 1] if k else None
        after = found.events[k] if k < len(found.events) else None
        if count and opening is None:
            opening = (*_end(before, found.start), count)
        if opening is not None:
            opening = (*opening[:2], min(opening[2], count or opening[2]))
        closes = after is None or isinstance(after, Strip) or not found.counts[k + 1]
        if count and closes and opening is not None:
            end, q = _end(after, found.end)
            intervals.append(Interval(opening[0], end, opening[1], q, opening[2]))
            opening = None
        if count is None:
            start = before.t if isinstance(before, Zero) else before.end if before else float(found.start)
            stop = after.t if isinstance(after, Zero) else after.start if after else float(found.end)
            unknown.append((float(start), float(stop)))
        if isinstance(after, Strip):
            unknown.append((after.start, after.end))
    return tuple(intervals), tuple(sorted(unknown))


def _end(event: Zero | Strip | None, limit: Exact) -> tuple[Any, Any | None]:
    """The ball of an interval's end, and q there if it is a crossing."""
    if isinstance(event, Zero):
        return event.t, event.x
    if isinstance(event, Strip):
        return arb(event.start).union(arb(event.end)), None
    return limit.ball(), None


def _undamped(case: Case, low: Exact, high: Exact, digits: int) -> UnstableRanges:
    """Without damping: stable below α_C, since the energy in the moving frame is conserved and positive there.

    From α_C on the cut covers the real axis, and roots of the lower half-plane come and go through it: at the cut
    points below the cut.
    """
    from mpsolve.stability.cuts import cut_points

    with ball_arithmetic(128) as balls:
        critical = critical_velocity_ratio(case, balls)
        if high.ball() < critical:
            return UnstableRanges("alpha", low, high, (), (), (), Status.UNVERIFIED, "", digits)
        below, from_here = bool(low.ball() < critical), float(critical.lower())
    model = case.eta_b, case.eta_m, case.positions, case.eta_n, case.eta_s
    found = cut_points(*model, (low, high), digits)
    strips = [strip for strip in found.strips if strip.end > from_here]
    zeros = [
        Zero(
            point.q.real,
            point.alpha,
            (exact(point.q.real), exact(point.alpha)),
            (0.0, 0.0),
            1 if point.appears else -1,
        )
        for point in found
        if point.side == "below"
    ]
    passed = counted(
        Family(case, "alpha"), low, high, math.nan, zeros, strips, found.evaluations, 0 if below else None
    )
    intervals, unknown = _intervals(passed)
    status = Status.UNVERIFIED if passed.proved else Status.UNDECIDED
    reason = passed.strips[0].reason if passed.strips else "" if passed.proved else "no certified count could be had"
    return UnstableRanges("alpha", low, high, intervals, unknown, passed.strips, status, reason, digits, passed)
