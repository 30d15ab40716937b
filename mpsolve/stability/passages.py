"""Where roots pass a horizontal line as one parameter grows: all passages, their directions, and the roots below.

The passages are the real zeros (x, t) of the family, found with proof by search.py. Each stands for two roots
(q and −q̄), so that the number of roots below the line changes by twice its direction. One certified count fixes
the number in every part of the range that no undecided strip cuts off.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

import flint

from mpsolve.certificate.sheet import SheetSpectrum, certify_sheet
from mpsolve.errors import ContradictionError, PrecisionError, known
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.rootball import Symmetry
from mpsolve.progress import Progress
from mpsolve.sheet.far import far_radius
from mpsolve.stability.family import Family
from mpsolve.stability.holes import about, outward
from mpsolve.stability.search import Strip, all_zeros
from mpsolve.stability.together import Search, alone
from mpsolve.stability.zero import BITS, Zero, sharpen

arb = flint.arb
_BUDGET = 3_000_000  # boxes, for two masses; more masses take more time a box
_FAR_STEPS = 8  # parts of the range for which the far radius is proved one by one
_TRIES = (Fraction(1, 2), Fraction(1, 4), Fraction(3, 4), Fraction(1, 8), Fraction(7, 8))


@dataclass(frozen=True)
class Base:
    """The certified count that fixes all others: roots below the line at t."""

    t: Exact
    below: int
    spectrum: SheetSpectrum


@dataclass(frozen=True)
class Passages:
    """What happens in a family for start ≤ t ≤ end: `events` by ascending t, and a gap before, between, after them.

    A `Zero` is a passage; a `Strip` a range in which passages may have been missed. counts: the number of roots
    below the line in each gap, None where it is open.
    """

    family: Family
    start: Exact
    end: Exact
    radius: float
    events: tuple[Zero | Strip, ...]
    counts: tuple[int | None, ...]
    bases: tuple[Base, ...]
    evaluations: int

    @property
    def zeros(self) -> tuple[Zero, ...]:
        return tuple(event for event in self.events if isinstance(event, Zero))

    @property
    def strips(self) -> tuple[Strip, ...]:
        return tuple(event for event in self.events if isinstance(event, Strip))

    @property
    def proved(self) -> bool:
        return not self.strips and None not in self.counts


def passages(
    family: Family, start: Exact, end: Exact, digits: int, budget: int | None = None, tell: Progress | None = None
) -> Passages:
    """All passages in the range, to `digits` digits; what is open is returned as strips. Needs damping.

    For a free mass level u the range is (0, 1) and no count is needed: for small masses no root is below Im q = 0.
    """
    return alone(passing(family, start, end, digits, budget, tell))


def passing(
    family: Family, start: Exact, end: Exact, digits: int, budget: int | None = None, tell: Progress | None = None
) -> Search[Passages]:
    """`passages` as a search, for together.py."""
    budget = budget or _BUDGET // max(1, family.case.merged.count - 1) ** 2
    radius = _radius(family, start, end)
    found = yield from all_zeros(family, radius, _down(start), _up(end), budget, tell)
    zeros, strips = _within(family, found.zeros, list(found.strips), start, end, digits)
    return counted(family, start, end, radius, zeros, strips, found.evaluations, _first(family, start))


def _first(family: Family, start: Exact) -> int | None:
    """The number of roots below Im q = 0 at the start of the range, where theory knows it.

    For small masses it is 0. At rest and damped it is 0 too: the energy of beam and masses is positive for N < 1 and
    does not grow, as the motion of a root with Im q < 0 would make it (SPEC.md, section 9).
    """
    at_rest = family.parameter == "alpha" and not start and family.case.eta_b > 0 and family.height <= 0
    return 0 if family.parameter == "level" or at_rest else None


def counted(
    family: Family,
    start: Exact,
    end: Exact,
    radius: float,
    zeros: list[Zero],
    strips: list[Strip],
    evaluations: int,
    first: int | None,
) -> Passages:
    """The passages with the numbers of roots below the line; `first` is that at the start, if it is known."""
    events = _events(zeros, strips)
    gaps = _gaps(events, start, end)
    counts: list[int | None] = [None] * len(gaps)
    bases = []
    for run in _runs(events):
        if first is not None and run[0] == 0:
            counts[0], place = first, 0
        elif family.parameter == "level":
            continue
        else:
            base, place = _base(family, gaps, run)
            if base is None:
                continue
            bases.append(base)
            counts[place] = base.below
        _spread(events, counts, run, place)
        if any((counts[k] or 0) < 0 for k in run):
            raise ContradictionError(
                f"the passages of {family.parameter} contradict the certified count: the numbers of roots are "
                f"{[counts[k] for k in run]}; please report this as a fault"
            )
    return Passages(family, start, end, radius, events, tuple(counts), tuple(bases), evaluations)


def _radius(family: Family, start: Exact, end: Exact) -> float:
    """A radius beyond which no root lies for any t of the range (and any mass)."""
    if family.parameter == "level":
        with ball_arithmetic(BITS) as field:
            return far_radius(family.at(field, None))
    radius = 0.0
    low, high = float(start), float(end)
    ends = [low + (high - low) * k / _FAR_STEPS for k in range(_FAR_STEPS + 1)]
    ends[0], ends[-1] = _down(start), _up(end)
    with ball_arithmetic(BITS) as field:
        for a, b in pairwise(ends):
            radius = max(radius, far_radius(family.at(field, arb(a).union(arb(b)))))
    return radius


def _down(x: Exact) -> float:
    value = float(x)
    return value if Exact.parse(Fraction(value), "x") <= x else math.nextafter(value, -math.inf)


def _up(x: Exact) -> float:
    value = float(x)
    return value if Exact.parse(Fraction(value), "x") >= x else math.nextafter(value, math.inf)


def _within(
    family: Family, zeros: tuple[Zero, ...], strips: list[Strip], start: Exact, end: Exact, digits: int
) -> tuple[list[Zero], list[Strip]]:
    """The sharpened zeros inside the range; those that cannot be placed become strips."""
    kept: list[Zero] = []
    for rough in zeros:
        if _outside(family, rough, start, end):
            continue
        try:
            zero = sharpen(family, rough, digits)
        except PrecisionError as error:
            strips.append(_around(rough, str(error)))
            continue
        with ball_arithmetic(_bits(digits)):
            low, high = start.ball(), end.ball()
            if zero.t < low or zero.t > high or zero.x < 0:
                continue
            if zero.t > low and zero.t < high and zero.x > 0:
                kept.append(zero)
            else:
                strips.append(_around(rough, "a passage at the very end of the range, or at q = 0: shift the range"))
    kept.sort(key=lambda z: float(z.t.mid()))
    for a, b in pairwise(kept):
        if not a.t < b.t:
            strips.append(_around(a, "two passages at one value, or nearly so: ask for more digits"))
    return kept, strips


def _outside(family: Family, zero: Zero, start: Exact, end: Exact) -> bool:
    """Whether the zero is no passage of the range, as far as its first ball tells.

    With a free mass level the function is real at q = 0, and has zeros there that stand for no finite mass. A
    zero in a box about q = 0 that is the only one there is its own mirror image, so that q = 0.
    """
    with ball_arithmetic(BITS):
        if zero.t < start.ball() or zero.t > end.ball() or zero.x < 0:
            return True
        low, high, *_ = zero.hole
        about_0 = all(x > low and x < high for x in (zero.x, -zero.x)) and zero.x.contains(0)
    return family.parameter == "level" and about_0


def _bits(digits: int) -> int:
    return math.ceil(digits * math.log2(10)) + 64


def _around(zero: Zero, reason: str) -> Strip:
    return Strip(*outward(about(zero.centre[1], zero.reach[1])), reason)


def _span(event: Zero | Strip) -> tuple[float, float]:
    """The t-range of an event in floats, outward."""
    if isinstance(event, Strip):
        return event.start, event.end
    t, r = float(event.t.mid()), float(event.t.rad())
    return math.nextafter(t - r, -math.inf), math.nextafter(t + r, math.inf)


def _events(zeros: list[Zero], strips: list[Strip]) -> tuple[Zero | Strip, ...]:
    """In order; what overlaps a strip is part of it."""
    events: list[Zero | Strip] = []
    every: list[Zero | Strip] = [*zeros, *strips]
    for event in sorted(every, key=_span):
        if events and _span(event)[0] <= _span(events[-1])[1] and not _both_zeros(event, events[-1]):
            last = events.pop()
            reason = next(e.reason for e in (event, last) if isinstance(e, Strip))
            event = Strip(_span(last)[0], max(_span(last)[1], _span(event)[1]), reason)
        events.append(event)
    return tuple(events)


def _both_zeros(a: Zero | Strip, b: Zero | Strip) -> bool:
    return isinstance(a, Zero) and isinstance(b, Zero)


def _gaps(events: tuple[Zero | Strip, ...], start: Exact, end: Exact) -> list[tuple[float, float]]:
    edges = [_up(start), *(x for event in events for x in _span(event)), _down(end)]
    return list(zip(edges[::2], edges[1::2], strict=True))


def _runs(events: tuple[Zero | Strip, ...]) -> list[range]:
    """The numbers of the gaps that only passages, no strips, lie between."""
    cuts = [0, *(k + 1 for k, event in enumerate(events) if isinstance(event, Strip)), len(events) + 1]
    return [range(a, b) for a, b in pairwise(cuts)]


def _base(family: Family, gaps: list[tuple[float, float]], run: range) -> tuple[Base | None, int]:
    """A certified count in one of the gaps, the widest first."""
    for place in sorted(run, key=lambda k: gaps[k][0] - gaps[k][1]):
        low, high = gaps[place]
        if high > low:
            base = _count_in(family, Fraction(low), Fraction(high))
            if base is not None:
                return base, place
    return None, run[0]


def _spread(events: tuple[Zero | Strip, ...], counts: list[int | None], run: range, place: int) -> None:
    """From the count at `place` to the whole run: each passage changes it by two."""
    below = known(counts[place], "the certified count")
    for k in range(place + 1, run[-1] + 1):
        below += 2 * _direction(events[k - 1])
        counts[k] = below
    below = known(counts[place], "the certified count")
    for k in range(place - 1, run[0] - 1, -1):
        below -= 2 * _direction(events[k])
        counts[k] = below


def _direction(event: Zero | Strip) -> int:
    if isinstance(event, Strip):
        raise ContradictionError("an undecided strip stands where only passages were to be")
    return event.direction


def _count_in(family: Family, low: Fraction, high: Fraction) -> Base | None:
    for share in _TRIES:
        t = Exact.parse(_simple(low + (high - low) * share, high - low), "t")
        spectrum = certify_sheet(family.case_at(t), digits=15, region="unstable" if not family.height else "sheet")
        below = _below(spectrum, family.height)
        if below is not None:
            return Base(t, below, spectrum)
    return None


def _simple(x: Fraction, width: Fraction) -> Fraction:
    """A short decimal next to x."""
    places = max(2, 2 - math.floor(math.log10(width)))
    return Fraction(round(x * 10**places), 10**places)


def _below(spectrum: SheetSpectrum, height: Exact) -> int | None:
    """How many roots lie below the line, if that is proved."""
    if not spectrum.proved:
        return None
    if not height:
        return spectrum.unstable
    number = 0
    for root in spectrum.roots:
        imag = arb(0) if root.symmetry is Symmetry.REAL else root.q.imag
        if imag < height.ball():
            number += root.multiplicity
        elif not imag > height.ball():
            return None
    return number
