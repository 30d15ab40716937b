"""Turns round branch points against the order of the pole there, and against roots that a loop holds."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from mpsolve import tracks, vehicles
from mpsolve.characteristic.bordered import Arrays
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.loops import turn_round
from mpsolve.problem.line import on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem


def turned(
    alpha: str, masses: int, radius: float, rounds: int, M: object = 70, at: float | None = None
) -> float | None:
    """Turns of Δ̂ round the first branch point, or round `at`."""
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
    reduced = reduce_problem(Problem(track, [vehicles.Mass(M).at(j) for j in range(masses)], v=alpha))
    line = on_line(reduced)
    assert line is not None
    centre = float(line.branch_points[0][0]) if at is None else at
    sides = 48
    points = centre + radius * np.exp(1j * pi * (1 + 2 * np.arange(rounds * sides + 1) / sides))
    points[-1] = points[0]
    arrays = Arrays(line.lower)
    first = split(arrays.D, 1j * points[:1], np.zeros(1), 2)
    found = turn_round(arrays, first, points)
    if found is None:
        return None
    assert found[1] < 0.1
    return found[0] / (2 * pi)


@pytest.mark.parametrize("masses", [1, 2, 3])
def test_one_pair_of_roots_gives_one_simple_pole(masses: int) -> None:
    """G has one residue of rank one in the local variable, whatever the number of masses."""
    assert turned("0.67", masses, 0.02, 2) == pytest.approx(-1, abs=1e-9)


@pytest.mark.parametrize(("masses", "poles"), [(1, 3), (2, 4), (3, 4)])
def test_four_roots_that_meet_at_rest(masses: int, poles: int) -> None:
    """R = w⁴ up to a constant, and G(0) ~ w⁻³."""
    assert turned("0", masses, 0.03, 4) == pytest.approx(-poles, abs=1e-9)


def test_the_splitting_is_back_only_after_all_rounds() -> None:
    assert turned("0.67", 2, 0.02, 1) is None
    assert turned("0", 2, 0.01, 2) is None


def test_without_a_branch_point_the_turn_counts_roots() -> None:
    """Two masses of 70 at a distance of 1 have two roots with Re q > 0 within 0.1 of z = 0.13 − 0.045i…"""
    assert turned("0.67", 2, 0.1, 1, at=0.16) == pytest.approx(2, abs=1e-9)
    assert turned("0.67", 2, 0.01, 1, at=0.3) == pytest.approx(0, abs=1e-9)


def test_a_root_next_to_the_branch_point_is_seen() -> None:
    """A mass of 1/10 has a root at a distance of about 10⁻⁵ from it: a large loop holds it, a small one does not."""
    assert turned("0.67", 1, 0.01, 2, "0.1") == pytest.approx(0, abs=1e-6)
    assert turned("0.67", 1, 1e-7, 2, "0.1") == pytest.approx(-1, abs=1e-1)
