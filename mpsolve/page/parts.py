"""What a page is made of: each part computed within a budget, in the order in which it is needed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.batch.frequencies import frequencies
from mpsolve.batch.result import Frequencies
from mpsolve.certificate.certify import certify
from mpsolve.page.budget import Budget, Part
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.proof.effort import Effort
from mpsolve.ranges.default import MASS_FACTORS, critical_of, top_velocity
from mpsolve.report.spectrum_words import verdict
from mpsolve.spectrum.spectrum import Spectrum
from mpsolve.tracks.at_rest import lowest_cut
from mpsolve.waves.critical import CriticalVelocities

LINE_POINTS, CHART_COLUMNS, CHART_ROWS = 81, 49, 25


@dataclass(frozen=True)
class Parts:
    """given: what the file holds; problem: the same as a Problem; top: the highest velocity that is looked at."""

    given: Given
    problem: Problem
    title: str
    top: Fraction
    spectrum: Spectrum
    onset: Part[Any]
    response: Part[Any]
    lines: Part[Frequencies]
    critical: Part[CriticalVelocities]
    chart: Part[Frequencies]
    loads: Any = None

    @property
    def verdict(self) -> str:
        """One sentence that begins with STABLE, UNSTABLE, NO GROWTH or UNDECIDED."""
        return verdict(self.spectrum)

    @property
    def late(self) -> tuple[str, ...]:
        """The parts for which there was no time."""
        parts = (self.onset, self.response, self.lines, self.critical, self.chart)
        return tuple(part.name for part in parts if part.late)


def gather(
    given: Given, title: str, *, digits: int, seconds: float, tell: Callable[[str, float], None], loads: Any = None
) -> Parts:
    """All parts that fit into the budget; the roots come first and always."""
    problem, budget = as_problem(given), Budget(seconds, tell)
    tell("roots", 0.0)
    spectrum = certify(given, digits=digits, effort=Effort(seconds=max(seconds / 2, 5.0)))
    critical = budget.part("critical velocities", lambda _: critical_of(problem), share=0.3)
    top = top_velocity(problem, critical.value)
    return Parts(
        given=given,
        problem=problem,
        title=title,
        top=top,
        spectrum=spectrum,
        onset=budget.part("onset", lambda left: onset_of(problem, top, left), share=0.6, least=0.2),
        response=budget.part("response", lambda _: response_of(problem, spectrum, loads), share=0.7, least=0.5),
        lines=budget.part("frequency lines", lambda _: lines_of(problem, top), least=0.5),
        critical=critical,
        chart=budget.part("chart", lambda _: chart_of(problem, top), least=2.0),
        loads=loads,
    )


def onset_of(problem: Problem, top: Fraction, seconds: float) -> Any:
    """The first velocity at which a vibration begins to grow."""
    from mpsolve.ranges.onset import onset

    return onset(problem, over={"v": (0, top)}, digits=15, effort=Effort(seconds=seconds))


def response_of(problem: Problem, spectrum: Spectrum, loads: Any) -> Any:
    """The motion from the moment at which the vehicle is put on the track, under its weights or the file's loads."""
    from mpsolve.vibration.response import response

    duration = _duration(spectrum)
    times = np.linspace(0.0, duration, 600)
    return response(problem, loads, places=problem.pencil.places, times=times, spectrum=spectrum)


def _duration(spectrum: Spectrum) -> float:
    """Some periods of the slowest vibration that was found, and some doubling times."""
    slowest = min(
        (float(root.frequency.mid()) for root in spectrum.roots if float(root.frequency.mid()) > 0), default=1.0
    )
    fastest = max((float(root.growth.mid()) for root in spectrum.roots), default=0.0)
    wanted = 8.0 / slowest
    return min(wanted, 12.0 / fastest) if fastest > 0 else wanted


def lines_of(problem: Problem, top: Fraction) -> Frequencies:
    """The roots below the lowest cut over the velocity, in floats."""
    low = lowest_cut(problem.track)[0]
    region: object = ("below", low * Fraction(9, 10)) if low else "unstable"
    return frequencies(problem, {"v": velocities(top, LINE_POINTS)}, region)


def chart_of(problem: Problem, top: Fraction) -> Frequencies:
    """How many roots grow over velocity and masses, in floats."""
    factors = np.linspace(float(MASS_FACTORS[0]), float(MASS_FACTORS[1]), CHART_ROWS)
    over = {"v": velocities(top, CHART_COLUMNS)[:, None], "scale.mass": factors[None, :]}
    return frequencies(problem, over, roots=False)


def velocities(top: Fraction, number: int) -> Any:
    """Velocities from near 0 to the top that are no round numbers, as those may be wave speeds."""
    return float(top) * (np.arange(number) + 0.503) / number
