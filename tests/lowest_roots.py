"""What a lowest root is compared with: certified spectra at single points."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from mpsolve import Case, Problem, certify
from mpsolve.numbers.balls import precision
from mpsolve.problem.cases import as_problem
from mpsolve.ranges.worst import Worst


def pair(alpha: str, eta_b: str, eta_m: int = 70, distance: str = "1.5", **more: object) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, distance), **more)  # type: ignore[arg-type]


def least(problem: Problem, region: object = "unstable") -> float:
    """The certified least Im q at one point."""
    found = certify(problem, region=region, digits=15, check=False)
    assert found.proved, found.reason
    return min((float(root.q.imag.mid()) for root in found.roots), default=np.inf)


def assert_lowest(case: Case | Problem, path: str, found: Worst, points: list[str], region: object) -> None:
    problem = as_problem(case)
    with precision(100):
        here = float(found.q.imag.mid())  # type: ignore[union-attr]
    for x in points:
        assert least(problem.changed(path, x), region) >= here - 1e-13
    middle = Fraction((found.lower + found.upper) / 2)  # type: ignore[operator]
    low, high = found.over[path]
    assert abs(least(problem.changed(path, min(max(middle, low), high)), region) - here) < 1e-12
