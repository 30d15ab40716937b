"""The steps of an answer about root loci: border, roots at one value, chains, counts, crossings, points."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import accumulate
from typing import Any

from mpsolve.loci.answer import FrequencyLine, LineEnd
from mpsolve.loci.border import ON_AXIS, Border, Passing, border_of
from mpsolve.loci.grow import Start, Strand, strands
from mpsolve.loci.meeting import Meeting
from mpsolve.loci.on_sheet import OnSheet
from mpsolve.loci.points import roots_at
from mpsolve.loci.region import Region
from mpsolve.numbers.balls import acb, arb, precision, rational_ball, square
from mpsolve.numbers.plain import disc_of
from mpsolve.numbers.rootball import Symmetry
from mpsolve.outcome import Reason
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Interval, Proof, within
from mpsolve.ranges.base import base_at
from mpsolve.ranges.crossed import Crossing
from mpsolve.ranges.scope import Scope
from mpsolve.spectrum.regions import Below, HalfPlane, Sheet
from mpsolve.spectrum.spectrum import Root, Spectrum
from mpsolve.zeros.regions import Rectangle

_BASES = (0.5, 0.375, 0.625, 0.25, 0.75, 0.4375, 0.5625, 0.125, 0.875)
"""Of the range: where its roots may be counted, the first that is not near an event."""


@dataclass
class Assembly:
    """The steps of an answer; `reason` is the first that stands against it."""

    problem: Problem
    over: Mapping[str, Interval]
    region: Region | OnSheet
    digits: int
    budget: Effort
    progress: Progress
    check: bool

    def __post_init__(self) -> None:
        self.reason: Reason | None = None
        self.events: list[Passing] = []
        self.base: Spectrum | None = None
        self.counts: tuple[int, ...] | None = None
        self.borders: list[Border] = []
        self.room = self.region.room

    @property
    def scope(self) -> Scope:
        return self.region.scope

    def lines(self, values: tuple[Fraction, ...]) -> tuple[FrequencyLine, ...]:
        tell = self._stage(0.0, 0.4)
        if isinstance(self.region, OnSheet):
            self._keep(self.region.border(self.digits, self.budget, tell))
        else:
            self._keep(border_of(self.scope, self.region.sides, self.digits, self.budget, tell))
        self.events = self._in_range(self.borders[0].passings)
        starts = self._starts()
        if starts is None:
            return ()
        found, reason = strands(
            self.region.matrix, self.room, self.at, starts, tuple(self.events), self.budget, self._stage(0.5, 0.7)
        )
        self._open(reason)
        self._count(found)
        self._cross(found)
        found.sort(key=lambda one: (one.low, one.tubes.middle[0].real))
        return tuple(self._line(one, values, k / len(found)) for k, one in enumerate(found))

    def proof(self) -> tuple[Proof, ...]:
        family = self.scope.family
        return tuple(
            Proof(self.over, family.units, family.frequency_unit, float(self.scope.X), cover, border.known, self.base)
            for border in self.borders
            for cover in border.covers
        )

    def in_units(self, one: Passing) -> tuple[arb, acb]:
        """(value, q) of a passing in the problem's units."""
        family = self.scope.family
        with precision(max(int(one.x.mid().bits()), 53) + 64):
            return one.x * rational_ball(family.units[0]), one.q * acb(rational_ball(family.frequency_unit))

    def _stage(self, first: float, last: float) -> Progress:
        return lambda stage, share: self.progress(stage, first + (last - first) * share)

    def _open(self, reason: Reason | None) -> None:
        self.reason = self.reason or reason

    def _keep(self, border: Border) -> None:
        self.borders.append(border)
        self._open(border.reason)

    def _in_range(self, passings: tuple[Passing, ...]) -> list[Passing]:
        """Those within the range; one of which that cannot be told is a reason."""
        inside = []
        for one in passings:
            where = within(self.in_units(one)[0], next(iter(self.over.values())))
            if where is None:
                remedy = "give a range that ends elsewhere"
                self._open(Reason("end", "a root passes the border at an end of the range", {}, remedy))
            elif where:
                inside.append(one)
        return inside

    def _starts(self) -> list[Start] | None:
        """The roots at one value, all that there are; None where they are not all known."""
        family, low, high = self.scope.family, float(self.scope.low[0]), float(self.scope.high[0])
        width = (high - low) / 64
        shares = (low + share * (high - low) for share in _BASES)
        spans = [one.span for one in self.events]
        free = (x for x in shares if all(x < a - width or x > b + width for a, b in spans))
        x = next(free, low + 0.5078125 * (high - low))
        self.progress("base", 0.45)
        at = self.problem.changed(self.scope.family.paths[0], Fraction(x) * family.units[0])
        self.base = base = base_at(at, self.budget.rest(), self.check, self.region.asked)
        if not base.proved or any(root.multiplicity > 1 for root in base.roots):
            self._open(
                base.reason or Reason("multiple", "two roots meet where they are counted", {}, "move the range")
            )
            return None
        if not self._same_region(at, base):
            message = "roots lie beyond the region at the value at which they are counted"
            self._open(Reason("region", message, {}, 'ask for region="unstable"'))
            return None
        self.at = x
        unit = float(family.frequency_unit)
        halves = [root for root in base.roots if not root.q.real < 0]
        return [_start(x, root, unit) for root in halves]

    def _same_region(self, at: Problem, base: Spectrum) -> bool:
        """Whether the counted region holds the same roots as the one along whose border events were sought."""
        mine, its = self.region.answered, base.region
        if isinstance(mine, Sheet):
            return isinstance(its, Sheet)
        if not isinstance(mine, Below):
            return isinstance(its, HalfPlane) and its.radius is None
        if not isinstance(its, Below) or its.reach is None or its.radius is not None or mine.reach is None:
            return False
        if its.reach == mine.reach:
            return True
        first, last = sorted((its.reach, mine.reach))
        between = Rectangle(first, last, 0, mine.height)
        rest = base_at(at, self.budget.rest(), False, between)
        return rest.count == 0

    def _count(self, found: list[Strand]) -> None:
        """The numbers of roots between events, and whether the lines are as many."""
        if self.base is None or self.base.count is None:
            return
        before = sum(one.ends[0] < self.at for one in self.events)
        number = self.base.count - sum(one.gained or 0 for one in self.events[:before])
        counts = [number]
        for one in self.events:
            counts.append(counts[-1] + (one.gained or 0))
        self.counts = tuple(counts)
        if any(one.first == "stuck" or one.last == "stuck" for one in found):
            remedy = "give a range that ends before, or more effort"
            self._open(Reason("line", "a root could not be followed, as it may meet another one", {}, remedy))
        low, high = float(self.scope.low[0]), float(self.scope.high[0])
        meetings = {(end.low, end.high) for one in found for end in (one.first, one.last) if isinstance(end, Meeting)}
        breaks = sorted([*((one.ends, one.gained or 0) for one in self.events), *((ends, 0) for ends in meetings)])
        edges = [low, *(x for ends, _ in breaks for x in ends), high]
        numbers = list(accumulate((gained for _, gained in breaks), initial=number))
        for k, number in enumerate(numbers):
            a, b = edges[2 * k], edges[2 * k + 1]
            if not a < b:
                continue
            there = sum(1 if one.on_axis else 2 for one in found if one.low[1] <= a and one.high[0] >= b)
            if there != number:
                message = "the lines do not account for all roots between two events"
                self._open(Reason("lines", message, {}, "ask for more digits, or give a shorter range"))

    def _cross(self, found: list[Strand]) -> None:
        """Gives each crossing of the real axis to its line."""
        if not self.region.height:
            return
        side = replace(ON_AXIS, high=float(self.scope.X))
        border = border_of(self.scope, (side,), self.digits, self.budget, self._stage(0.7, 0.8))
        self._keep(border)
        for one in self._in_range(border.passings):
            line = next((strand for strand in found if strand.holds(one)), None)
            if line is None:
                message = "a crossing of the real axis is on no line that is proved"
                self._open(Reason("crossing", message, {}, "ask for more digits"))
            else:
                line.crossings.append(one)

    def _line(self, strand: Strand, values: tuple[Fraction, ...], done: float) -> FrequencyLine:
        self.progress("roots", 0.8 + 0.2 * done)
        at, balls = [], []
        for value, q in roots_at(self.scope.family, self.region.matrix, self.room, strand, values, self.digits):
            if q is None:
                remedy = "ask for more digits, or leave that value out"
                self._open(Reason("point", "the root of a line is not enclosed at some value", {}, remedy))
            else:
                at.append(value)
                balls.append(q)
        ends = self._end(strand.first), self._end(strand.last)
        crossings = tuple(self._crossing(one) for one in strand.crossings)
        return FrequencyLine(tuple(at), tuple(balls), ends, 1 if strand.on_axis else 2, crossings)

    def _end(self, end: Any) -> LineEnd:
        if isinstance(end, Passing):
            return LineEnd("cut" if end.side else "region", *self.in_units(end), end.side or None)
        if isinstance(end, Meeting):
            return LineEnd("collision", *self._met(end))
        return LineEnd("range" if end == "range" else "open")

    def _met(self, end: Meeting) -> tuple[arb, acb]:
        """Balls that hold the value and the root at which two roots meet."""
        family = self.scope.family
        with precision(64):
            value = arb(end.low).union(arb(end.high)) * rational_ball(family.units[0])
            disc = acb(0, end.height) + square(arb(end.radius))
            return value, disc * acb(rational_ball(family.frequency_unit))

    def _crossing(self, one: Passing) -> Crossing:
        value, q = self.in_units(one)
        return Crossing(value, q.real, one.gained)


def _start(x: float, root: Root, unit: float) -> Start:
    with precision(64):
        q = root.q / unit
    return Start(x, *disc_of(q), root.symmetry is Symmetry.IMAGINARY)
