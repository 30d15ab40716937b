"""Counts on the whole sheet against those of another engine, a float contour, and what is known at rest."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from mpsolve import tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.problem.line import Line, on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.sheet import SheetCount, count_sheet

# α, η_b, N, number of masses, η_M, gap: the number of roots by the edge of the cut in balls, with R·Δ at the branch
# points and the arguments of factors far out (an engine that shared no count with this one)
KNOWN = [
    ("0.67", "0.05", "0", 1, 70, "1.5", 2),
    ("0.67", "0.05", "0", 2, 70, "1.5", 4),
    ("0.67", "0.05", "0", 3, 70, "1.5", 6),
    ("1.2", "0.05", "0", 1, 70, "1.5", 4),
    ("1.268", "0.05", "0", 2, 70, "1.5", 6),
    ("0.67", "0", "0", 2, 70, "1.5", 4),
    ("1.563", "0", "-0.19", 2, 10, "3", 8),
    ("0", "0.05", "0", 1, 70, "1.5", 2),
    ("0", "0.3", "0", 2, 10, "4.5", 4),
    ("0", "0.05", "0.37", 2, 300, "4.5", 4),
    ("0.3", "0.05", "0.8", 2, 70, "1.5", 4),
    ("0.385", "0.05", "0.85", 2, 300, "4.5", 4),
    ("1.4", "0.9", "0.1", 2, 70, "1.5", 6),
    ("1.357", "0.866", "0", 2, 300, "4.5", 10),
    ("1.362", "0.05", "0.76", 2, 70, "4.5", 12),
    ("1.149", "0.3", "0.02", 2, "0.1", "0.5", 0),
    ("1.561", "0.3", "0", 1, "0.1", "3", 2),
    ("0.842", "0.3", "0", 2, "0.1", "4.5", 0),
]


def made(alpha: str, eta_b: str, N: str, masses: int, M: object, gap: str) -> Line:
    axial = Fraction(N)
    track = tracks.EulerBernoulli(
        EI="1/4", m=1, k=1, c=2 * Fraction(eta_b), N=max(axial, Fraction(0)), kp=max(-axial, Fraction(0))
    )
    row = [vehicles.Mass(M).at(j * Fraction(gap)) for j in range(masses)]
    found = on_line(reduce_problem(Problem(track, row, v=alpha)))
    assert found is not None
    return found


def counted(*given: Any) -> SheetCount:
    return count_sheet(made(*given), Effort(evaluations=200_000))


@pytest.mark.parametrize("row", KNOWN, ids=lambda row: " ".join(map(str, row[:6])))
def test_the_count(row: tuple[Any, ...]) -> None:
    found = counted(*row[:-1])
    assert found.total == row[-1]
    assert (found.far is None) == (row[1] == "0")


@pytest.mark.parametrize(("alpha", "eta_b"), [("1.2", "0.05"), ("1.357", "0.866")])
def test_the_halves_against_a_contour_in_floats(alpha: str, eta_b: str) -> None:
    """Where the cuts are joined: a rectangle from just beside the cut outward, in 80,000 steps, for each half."""
    line = made(alpha, eta_b, "0", 2, 70, "1.5")
    total = 0.0
    for half in (line.lower, line.upper):
        corners = [-40 - 1e-5j, -40 - 30j, 40 - 30j, 40 - 1e-5j, -40 - 1e-5j]
        z = np.concatenate([np.linspace(a, b, 20_000) for a, b in pairwise(corners)])
        value = Floats(half).delta(1j * z)[0]
        total += np.angle(value[1:] / value[:-1]).sum() / (2 * np.pi)
    assert counted(alpha, eta_b, "0", 2, 70, "1.5").total == pytest.approx(total, abs=1e-3)


def test_where_the_count_begins_and_ends() -> None:
    gap, joined = counted("0.67", "0.05", "0", 2, 70, "1.5"), counted("1.2", "0.05", "0", 2, 70, "1.5")
    assert gap.begin == gap.end == gap.lower.loops[0].first
    assert not gap.upper.paths
    assert joined.begin == 0
    assert joined.end**2 > float(joined.line.passive_from)
    assert joined.upper.loops[0].last <= joined.end
    undamped = counted("0.67", "0", "0", 2, 70, "1.5")
    assert undamped.end == undamped.lower.loops[0].last > undamped.begin
    assert not undamped.line.in_gap(Fraction(undamped.end))


def test_what_stays_open() -> None:
    with pytest.raises(PrecisionError, match="exactly the one at which the cuts join"):
        counted("1", "0", "0", 1, 70, "1")
    with pytest.raises(EffortError):
        count_sheet(made("0.67", "0.05", "0", 2, 70, "1.5"), Effort(evaluations=50))
