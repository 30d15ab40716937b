"""All targets of questions over ranges in one run: processor seconds of the proof against what is wanted of it.

Verification stands beside the proof, in times of it: at most 5 of onsets and crossings is wanted. The rows of
`prove_stable` and the onset of a bogie take longest; figure 12 and 1,000 digits stand in bench_table and bench_onset.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

from measure import fresh

from mpsolve import Case, Problem, crossings, onset, prove_stable, tracks, vehicles, worst
from mpsolve.presets.written import problem_of
from mpsolve.problem.inputfile import read_problem

EXAMPLES = Path(__file__).parents[2] / "examples"
FIRST = Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
PAIR = Case(alpha="0.99", eta_b="0.5", eta_m=(70, 70), positions=(0, 1))
RAIL = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
VISCOUS = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770, eta="1e-4")
WHEELS = Problem(RAIL, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=50)
SOFT = Problem(VISCOUS, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=50)
BOGIE = read_problem(EXAMPLES / "two_layer_bogie.toml").problem
ONE = Problem(BOGIE.track, vehicles.Mass(900), v=600)
COACH = read_problem(EXAMPLES / "train_8_coaches.toml").problem
BALLASTED = problem_of("ballasted")[0]
TIMES = 5.0
"""The proof's time that the verification of an onset or of crossings may take."""


@dataclass(frozen=True)
class Row:
    """limit: seconds of the proof, None where none is set. checked: whether its certificate is verified too."""

    name: str
    ask: Callable[[bool], Any]
    limit: float | None = None
    checked: bool = True


def halves(problem: Problem, *paths: str, share: str = "0.5") -> dict[str, Any]:
    """Each parameter from 1 − share to 1 + share of its own value."""
    s = Fraction(share)
    return {path: (problem.parameters[path] * (1 - s), problem.parameters[path] * (1 + s)) for path in paths}


def below_onset(problem: Problem, box: dict[str, Any]) -> dict[str, Any]:
    """The box, with all velocities up to nine tenths of the least onset at its corners."""
    least = 300.0
    for corner in product(*box.values()):
        at = problem
        for path, value in zip(box, corner, strict=True):
            at = at.changed(path, value)
        found = onset(at, over={"v": (10, 300)}, check=False)
        least = min(least, found.lower or least)
    return {"v": (0, Fraction(least * 0.9).limit_denominator(10))} | box


def rows() -> list[Row]:
    track = halves(WHEELS, "track.k", "track.c")
    soft = below_onset(WHEELS, track)
    heavy = below_onset(WHEELS, track | halves(WHEELS, "scale.mass", share="0.1"))
    loose = {"v": (50, 400)} | halves(BOGIE, "track.k_ballast", "track.c_ballast")
    return [
        Row("onset of a pair", lambda c: onset(FIRST, over={"v": ("0.01", 1)}, digits=30, check=c), 0.3),
        Row("crossings in mass", lambda c: crossings(PAIR, over={"scale.mass": (0, 2)}, check=c), 0.15),
        Row("crossings in velocity", lambda c: crossings(FIRST, over={"v": ("0.01", 1)}, check=c)),
        Row("worst distance", lambda c: worst(PAIR, over={"gap[0]": (1, 5)}, digits=30, check=c), 0.6, False),
        Row("limiting mass at it",
            lambda c: onset(PAIR, over={"eta_m": (1, 70)}, worst={"gap[0]": (1, 2)}, check=c), 0.6, False),
        Row("onset, Kelvin–Voigt pair", lambda c: onset(SOFT, over={"v": (10, 300)}, check=c)),
        Row("onset, 900 kg on two layers", lambda c: onset(ONE, over={"v": (600, 1500)}, check=c)),
        Row("onset, bogie on two layers", lambda c: onset(BOGIE, over={"v": (50, 600)}, check=c)),
        Row("onset, coach on two layers",
            lambda c: onset(Problem(COACH.track, COACH.vehicles[:1], v=50), over={"v": (50, 350)}, check=c)),
        Row("onset, coach on ballast, bogies far apart",
            lambda c: onset(BALLASTED, over={"v": (140, 1600)}, check=c)),
        Row("stable: pair, v k c", lambda c: prove_stable(WHEELS, over=soft, check=c), 3, False),
        Row("stable: pair, v k c M", lambda c: prove_stable(WHEELS, over=heavy, check=c), 10, False),
        Row("stable: bogie on two layers, v k c", lambda c: prove_stable(BOGIE, over=loose, check=c), 60, False),
    ]  # fmt: skip


def measured(row: Row) -> str:
    """One row: the proof, its share of the limit; verification in times of the proof, and how that stands to 5."""
    fresh(lambda: row.ask(False))()
    found = fresh(lambda: row.ask(row.checked))()
    proof, check = found.cost.seconds, found.cost.verification
    goal = f"{proof / row.limit:5.2f} of the goal" if row.limit else " " * 17
    said = f"   verification {check / proof:5.1f} times that" if row.checked else ""
    late = f", {check / proof / TIMES:4.2f} of the goal" if row.checked else ""
    return f"{row.name:36} {found.status.name:10} {proof:7.3f} s {goal}{said}{late}"


def test_all_targets() -> None:
    for row in rows():
        print(measured(row), flush=True)
