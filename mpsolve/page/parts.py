"""What a page is made of: each part computed within a budget, in the order in which it is needed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from mpsolve.batch.frequencies import frequencies
from mpsolve.batch.result import Frequencies
from mpsolve.certificate.certify import certify
from mpsolve.numbers.arrays import Reals
from mpsolve.outcome import Reason, Status
from mpsolve.page.budget import Budget, Part
from mpsolve.page.limits import Reach, distance_margin, distance_path, mass_margin, reach_of, stable_box
from mpsolve.pictures.shape import shape_along
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.problem import Problem
from mpsolve.proof.deadline import TimeUpError, deadline
from mpsolve.proof.effort import MORE_EFFORT, Effort
from mpsolve.proof.stopping import stoppable
from mpsolve.ranges.chart import Chart, stability_chart
from mpsolve.ranges.default import MASS_FACTORS, critical_of, top_velocity, velocity_ranges
from mpsolve.ranges.margin import Margin
from mpsolve.report.spectrum_words import verdict
from mpsolve.report.vibration import once
from mpsolve.spectrum.regions import HalfPlane
from mpsolve.spectrum.spectrum import Root, Spectrum
from mpsolve.tracks.at_rest import lowest_cut
from mpsolve.waves.velocity import CriticalVelocities

LINE_POINTS, CHART_COLUMNS, CHART_ROWS, PROVED_DEPTH = 81, 49, 25, 5
_ROOTS = 0.7  # of the time, for the roots with their verifier
_LEAST = 2.0  # seconds for the roots, however little time there is
_WORTH = Fraction(1, 2)  # of the proved chart that must be decided, or counts in floats are drawn
NOT_ASKED: Part[Any] = Part("more", reason="it was not asked for")


@dataclass(frozen=True)
class Parts:
    """given: what the file holds; problem: the same as a Problem; top: the highest velocity that is looked at."""

    given: Given
    problem: Problem
    title: str
    top: Fraction
    spectrum: Spectrum
    reach: Part[Reach]
    response: Part[Any]
    lines: Part[Frequencies]
    critical: Part[CriticalVelocities]
    chart: Part[Frequencies]
    mass: Part[Margin]
    distance: Part[Margin] | None = None
    shape: Part[Any] = NOT_ASKED
    box: Part[Any] = NOT_ASKED
    proved_chart: Part[Any] = NOT_ASKED
    loads: Any = None
    sources: tuple[str, ...] = ()

    @property
    def verdict(self) -> str:
        """One sentence that begins with STABLE, UNSTABLE, NO GROWTH or UNDECIDED."""
        return verdict(self.spectrum)

    @property
    def late(self) -> tuple[str, ...]:
        """The parts for which there was no time."""
        parts = (self.reach, self.response, self.lines, self.critical, self.chart, self.mass, self.distance)
        more = (self.shape, self.box, self.proved_chart)
        return tuple(part.name for part in (*parts, *more) if part is not None and part.late)


@stoppable
def gather(
    given: Given,
    title: str,
    *,
    digits: int,
    seconds: float,
    tell: Callable[[str, float], None],
    loads: Any = None,
    sources: tuple[str, ...] = (),
    prove_chart: bool = True,
) -> Parts:
    """All parts that fit into the budget; the roots come first.

    The first Ctrl-C leaves out what is not ready; a second one ends all.
    prove_chart: with what is left at the end; counts in floats take its place where too much of it stays open.
    """
    problem, budget = as_problem(given), Budget(seconds, tell)
    critical = budget.part("critical velocities", lambda _: critical_of(problem), share=0.1)
    tell("roots", 0.0)
    spectrum = roots_of(given, digits, seconds)
    top = top_velocity(problem, critical.value)
    reach = budget.part("onset", lambda left: reach_of(problem, left), share=0.5, least=0.2)
    response = budget.part("response", lambda _: response_of(problem, spectrum, loads), share=0.7, least=0.5)
    shape = budget.part("shape", lambda _: shape_of(problem, spectrum), share=0.3)
    lines = budget.part("frequency lines", lambda _: lines_of(problem, top), share=0.6, least=0.5)
    mass = budget.part("limit of the mass", lambda left: mass_margin(problem, left), share=0.4, least=0.2)
    parts = Parts(
        given, problem, title, top, spectrum, reach, response, lines, critical, NOT_ASKED, mass,
        shape=shape, loads=loads, sources=sources,
    )  # fmt: skip
    return _last(parts, budget, prove_chart)


def _last(parts: Parts, budget: Budget, prove_chart: bool) -> Parts:
    """With what comes last: the limit of the distance, the region of stability, and the chart."""
    problem, path = parts.problem, distance_path(parts.problem)
    if path is not None:
        make = lambda left: distance_margin(problem, path, left)  # noqa: E731
        parts = replace(parts, distance=budget.part("limit of the distance", make, share=0.4, least=0.2))
    if parts.spectrum.stable and problem.v:
        make_box = lambda left: stable_box(problem, parts.reach.value, parts.mass.value, left)  # noqa: E731
        parts = replace(parts, box=budget.part("region of stability", make_box, share=0.5, least=0.2))
    if prove_chart:
        make_chart = lambda left: proved_chart_of(problem, left)  # noqa: E731
        parts = replace(parts, proved_chart=budget.part("proved chart", make_chart, share=0.7, least=2.0))
    if worth_drawing(parts.proved_chart.value):
        return parts
    return replace(parts, chart=budget.part("chart", lambda _: chart_of(problem, parts.top), least=1.0))


def worth_drawing(chart: Chart | None) -> bool:
    """Whether enough of a proved chart is decided."""
    return chart is not None and chart.share >= _WORTH


def roots_of(given: Given, digits: int, seconds: float) -> Spectrum:
    """The roots, undecided where they take most of the time; their certificate is checked as far as it goes."""
    most = max(_ROOTS * seconds, _LEAST)
    try:
        with deadline(most):
            return certify(given, digits=digits, effort=Effort(seconds=most))
    except TimeUpError:
        stated = f"{seconds:g} s for the page leave too little time for the roots"
        reason = Reason("effort", stated, {"seconds": f"{seconds:g}"}, MORE_EFFORT)
        return Spectrum(given, HalfPlane(), digits, Status.UNDECIDED, reason)


def worst(spectrum: Spectrum) -> Root | None:
    """The root that grows most, or decays least."""
    return max(once(spectrum), key=lambda root: float(root.growth.mid()), default=None)


def shape_of(problem: Problem, spectrum: Spectrum) -> Any:
    """Of the worst root: places along the rail round the contacts, the rail there, the bodies."""
    root = worst(spectrum)
    return None if root is None else shape_along(problem, root.q, root.multiplicity)


def response_of(problem: Problem, spectrum: Spectrum, loads: Any) -> Any:
    """The motion from the moment at which the vehicle is put on the track, under its weights or the file's loads.

    Its first lift-off is sought here, as it takes time. A spectrum that knows growth alone is no help to a motion.
    """
    from mpsolve.vibration.response import response

    duration = _duration(spectrum)
    times = np.linspace(0.0, duration, 600)
    known = None if isinstance(spectrum.region, HalfPlane) else spectrum
    found = response(problem, loads, places=problem.pencil.places, times=times, spectrum=known)
    _ = found.lift_off
    return found


def _duration(spectrum: Spectrum) -> float:
    """Some periods of the slowest vibration that was found, and some doubling times."""
    slowest = min(
        (float(root.frequency.mid()) for root in spectrum.roots if float(root.frequency.mid()) > 0), default=1.0
    )
    fastest = max((float(root.growth.mid()) for root in spectrum.roots), default=0.0)
    wanted = 8.0 / slowest
    return min(wanted, 12.0 / fastest) if fastest > 0 else wanted


def searched(track: Any) -> Fraction:
    """The decay up to which lines are followed; 0: growth only."""
    return (lowest_cut(track)[0] or 0) * Fraction(9, 10)


def lines_of(problem: Problem, top: Fraction) -> Frequencies:
    """The roots below the lowest cut over the velocity, in floats."""
    height = searched(problem.track)
    region: object = ("below", height) if height else "unstable"
    return frequencies(problem, {"v": velocities(top, LINE_POINTS)}, region)


def chart_of(problem: Problem, top: Fraction) -> Frequencies:
    """How many roots grow over velocity and masses, in floats."""
    factors = np.linspace(float(MASS_FACTORS[0]), float(MASS_FACTORS[1]), CHART_ROWS)
    over = {"v": velocities(top, CHART_COLUMNS)[:, None], "scale.mass": factors[None, :]}
    return frequencies(problem, over, roots=False)


def velocities(top: Fraction, number: int) -> Reals:
    """Velocities from near 0 to the top that are no round numbers, as those may be wave speeds."""
    return float(top) * (np.arange(number) + 0.503) / number


def proved_chart_of(problem: Problem, seconds: float) -> Chart:
    """How many roots grow over velocity and masses, as proved regions."""
    near = velocity_ranges(problem).near
    v = next((ends for ends in near if ends[0] <= problem.v <= ends[1]), near[0])
    over = {"v": v, "scale.mass": MASS_FACTORS}
    return stability_chart(problem, over=over, depth=PROVED_DEPTH, effort=Effort(seconds=seconds), check=False)
