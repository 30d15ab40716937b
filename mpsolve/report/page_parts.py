"""Everything that a report shows of a case, computed part by part: one that is undecided never stops the others."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Generic, TypeVar

import numpy as np

from mpsolve.certificate.sheet import SheetSpectrum, certify_sheet
from mpsolve.errors import MpsolveError
from mpsolve.model.load import GRAVITY, Load, gives_forces, loads_of
from mpsolve.model.parameters import Case
from mpsolve.motion.solution import Response
from mpsolve.motion.solve import response
from mpsolve.numbers.exact import Exact
from mpsolve.progress import Progress, silent
from mpsolve.report.answer import Source
from mpsolve.report.page_margins import Margin, least_top, margins, places
from mpsolve.report.remedies import for_reader
from mpsolve.report.statement import verdict
from mpsolve.stability.chart import StabilityChart, case_chart
from mpsolve.stability.lines import FrequencyLines, frequency_lines

LINE_POINTS = 25  # velocities of the frequency lines
FACTORS = tuple(Fraction(k, 5) for k in range(1, 16))  # of the masses in the chart, the case's own among them
_FEW = 12, tuple(Fraction(k, 5) for k in (3, 5, 7))  # both for three places of masses: each takes much longer,
_FEWEST = 4, (Fraction(1),)  # and for more than three
_PERIODS = 12  # of the slowest induced frequency that the response shows
_LONGEST = 1500.0  # of τ
_QUIET = 120.0  # of τ, where there is no induced frequency
_GROWTH = 6.0  # e-folds of an unstable motion that are shown
_PER_PERIOD = 24  # times in a period of the fastest part
_MOST_TIMES = 3000

T = TypeVar("T")


@dataclass(frozen=True)
class Part(Generic[T]):
    """A result, or the reason why there is none."""

    value: T | None
    reason: str = ""


@dataclass(frozen=True)
class Parts:
    """The parts of the report of one case.

    loads: what the response is computed for, in units of 1 N for a physical case; loads_said: the same in words.
    """

    source: Source
    spectrum: SheetSpectrum
    margins: tuple[Margin, Margin, Margin]
    lines: Part[FrequencyLines]
    chart: Part[StabilityChart]
    response: Part[Response]
    loads: tuple[Load, ...]
    loads_said: str

    @property
    def stable(self) -> bool | None:
        """Whether the case is stable: by its roots, or where these are undecided by the search of a margin."""
        if self.spectrum.stable is not None:
            return self.spectrum.stable
        return None if self.witness is None else self.witness.stable

    @property
    def witness(self) -> Margin | None:
        """The margin that proves whether the case is stable, where the roots do not."""
        tells = (one for one in self.margins if one.stable is not None)
        return next(tells, None) if self.spectrum.stable is None else None

    @property
    def verdict(self) -> str:
        """One sentence that begins with STABLE, UNSTABLE or UNDECIDED."""
        if self.witness is None:
            return for_reader(verdict(self.spectrum), "roots")
        by = f"as the search for the margin in {self.witness.name} proves; the roots themselves are undecided"
        if self.stable:
            return f"STABLE: no root has Im q < 0, {by}."
        return f"UNSTABLE: a root has Im q < 0, so the vibration grows without bound, {by}."

    @property
    def proved(self) -> bool:
        """Whether all that can be asked of this case is proved: roots, margins, and the columns of the chart."""
        charted = self.chart.value is not None and self.chart.value.proved
        return self.spectrum.proved and charted and all(one.proved or not one.applies for one in self.margins)


def gather(
    source: Source,
    digits: int = 30,
    tell: Progress | None = None,
    loads: tuple[Load, ...] | None = None,
    line_points: int | None = None,
    factors: tuple[Fraction, ...] | None = None,
) -> Parts:
    """Computes every part. Raises InputError for `digits`.

    loads: of the response, by default those of the case. line_points: velocities of the frequency lines; factors: of
    all masses, the columns of the chart; by default as many as one or two minutes allow.
    """
    say = tell or silent
    case = source.case
    spectrum = certify_sheet(case, digits, "sheet" if case.cuts_on_line else "unstable", progress=tell)
    found = margins(case, tell)
    say("lines", 0.0)
    off_line = cuts_said(case)
    lines: Part[FrequencyLines] = (
        Part(None, off_line) if off_line else attempted(lambda: _lines(case, line_points or points_of(case)))
    )
    say("chart", 0.0)
    top, factors = _top(case, least_top(case)), factors or factors_of(case)
    chart = attempted(lambda: case_chart(case, factors, (Exact.parse(0), top), workers=1, progress=tell))
    say("response", 0.0)
    given, said = loads_for(source, loads)
    motion: Part[Response] = (
        Part(None, off_line)
        if off_line
        else attempted(lambda: response(case, given, tau=times(spectrum), spectrum=spectrum))
    )
    return Parts(source, spectrum, found, lines, chart, motion, given, said)


def points_of(case: Case) -> int:
    """The velocities of the frequency lines: fewer for more than two places of masses."""
    return LINE_POINTS if places(case) < 3 else _many(case)[0]


def factors_of(case: Case) -> tuple[Fraction, ...]:
    """The columns of the chart: fewer for more than two places of masses, and without damping."""
    if places(case) > 2:
        return _many(case)[1]
    return FACTORS if case.eta_b else FACTORS[1::3]


def _many(case: Case) -> tuple[int, tuple[Fraction, ...]]:
    return _FEW if places(case) == 3 else _FEWEST


def cuts_said(case: Case) -> str:
    """Why there are no frequency lines and no response where the cuts leave the line Im q = η_b; "" elsewhere."""
    if case.cuts_on_line:
        return ""
    cause = (
        f"the damping ratio η_b is {case.eta_b.short()}, and from 1 on"
        if case.overdamped
        else f"η_N − η_S is {case.axial.short()}, not below √(1 − η_b²), and so"
    )
    return (
        f"{cause} the branch cuts leave the line Im q = η_b; frequency lines and response can be had only where the "
        "cuts lie on it, with less damping or less compression"
    )


def attempted(work: Callable[[], T]) -> Part[T]:
    """The result of `work`, or the sentence of the error that mpsolve raises on purpose."""
    try:
        return Part(work())
    except MpsolveError as error:
        return Part(None, str(error))


def loads_for(source: Source, loads: tuple[Load, ...] | None) -> tuple[tuple[Load, ...], str]:
    """The loads, in units of 1 N for a physical case, and what they are in words."""
    if loads is not None:
        return loads, "The loads are those of the input."
    if source.physical is None:
        return loads_of(source.case), "Each mass carries the same constant unit load."
    if gives_forces(source.physical):
        said = "The loads are the forces P + P_A sin(ω_f t + φ_f) of the input."
    else:
        said = f"The input gives no forces, so each mass carries its own weight, M · {GRAVITY.short()} m/s²."
    return loads_of(source.physical), said


def times(spectrum: SheetSpectrum) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Times τ that show the slowest induced vibration, its growth within bounds, and resolve the fastest."""
    roots = [complex(root.q.mid()) for root in spectrum.roots]
    slow = min((abs(q.real) for q in roots if abs(q.real) > 1e-3), default=0.0)
    end = min(_LONGEST, _PERIODS * 2 * math.pi / slow) if slow else _QUIET
    growth = max((-q.imag for q in roots), default=0.0)
    if growth > 0:
        end = min(end, _GROWTH / growth)
    fast = max([1.0, *(abs(q.real) for q in roots)])
    count = min(_MOST_TIMES, math.ceil(end * fast / (2 * math.pi) * _PER_PERIOD))
    return np.linspace(0.0, end, max(count, 200))


def _lines(case: Case, points: int) -> FrequencyLines:
    """From slow to beyond the case's velocity, on decimals of three places."""
    top = _top(case, min(Fraction(6, 5), least_top(case))).as_fraction()
    grid = [round(top * k / points, 3) for k in range(1, points + 1)]
    model = case.eta_b, case.eta_m, case.positions, case.eta_n, case.eta_s
    return frequency_lines(*model, alpha=grid, cuts=places(case) < 3)


def _top(case: Case, least: Fraction) -> Exact:
    """A decimal of one place that leaves room above the case's own velocity ratio."""
    return Exact.parse(max(least, Fraction(math.ceil(float(case.alpha) * 12), 10)))
