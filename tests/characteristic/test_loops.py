"""Turns round branch points against the order of the pole there, and against roots that a loop holds."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest

from mpsolve import tracks, vehicles
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import split
from mpsolve.characteristic.floats import Floats
from mpsolve.characteristic.loops import turn_round
from mpsolve.problem.line import Line, on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem


def line_of(alpha: str, masses: int, M: object = 70) -> Line:
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
    found = on_line(reduce_problem(Problem(track, [vehicles.Mass(M).at(j) for j in range(masses)], v=alpha)))
    assert found is not None
    return found


def turned(
    alpha: str,
    masses: int,
    radius: float,
    rounds: int,
    M: object = 70,
    at: float | None = None,
    pole: complex | None = None,
    sides: int = 48,
) -> tuple[float, float] | None:
    """Turns of Δ̂ round the first branch point, or round `at`: in all, and in the first half round."""
    line = line_of(alpha, masses, M)
    centre = float(line.branch_points[0][0]) if at is None else at
    points = centre + radius * np.exp(1j * pi * (1 + 2 * np.arange(rounds * sides + 1) / sides))
    points[-1], points[sides // 2] = points[0], centre + radius
    arrays = Arrays(line.lower)
    first = split(arrays.D, 1j * points[[0, sides // 2]], np.zeros(2), 2)
    both = turn_round([arrays], first, points, sides // 2, 1.0, pole)
    if both is None:
        return None
    (found,) = both
    assert max(found.whole[1], found.part[1]) < 0.1
    return found.whole[0] / (2 * pi), found.part[0] / (2 * pi)


def whole(*given: Any, **named: Any) -> float | None:
    found = turned(*given, **named)
    return None if found is None else found[0]


@pytest.mark.parametrize("masses", [1, 2, 3])
def test_one_pair_of_roots_gives_one_simple_pole(masses: int) -> None:
    """G has one residue of rank one in the local variable, whatever the number of masses."""
    assert whole("0.67", masses, 0.02, 2) == pytest.approx(-1, abs=1e-9)


@pytest.mark.parametrize(("masses", "poles"), [(1, 3), (2, 4), (3, 4)])
def test_four_roots_that_meet_at_rest(masses: int, poles: int) -> None:
    """R = w⁴ up to a constant, and G(0) ~ w⁻³."""
    assert whole("0", masses, 0.03, 4) == pytest.approx(-poles, abs=1e-9)


def test_the_splitting_is_back_only_after_all_rounds() -> None:
    assert whole("0.67", 2, 0.02, 1) is None
    assert whole("0", 2, 0.01, 2) is None


def test_without_a_branch_point_the_turn_counts_roots() -> None:
    """Two masses of 70 at a distance of 1 have two roots with Re q > 0 within 0.1 of z = 0.13 − 0.045i…"""
    assert whole("0.67", 2, 0.1, 1, at=0.16) == pytest.approx(2, abs=1e-9)
    assert whole("0.67", 2, 0.01, 1, at=0.3) == pytest.approx(0, abs=1e-9)


def test_a_root_next_to_the_branch_point_is_seen() -> None:
    """A mass of 1/10 has a root at a distance of about 10⁻⁵ from it: a large loop holds it, a small one does not."""
    assert whole("0.67", 1, 0.01, 2, "0.1") == pytest.approx(0, abs=1e-6)
    assert whole("0.67", 1, 1e-7, 2, "0.1") == pytest.approx(-1, abs=1e-1)


@pytest.mark.parametrize("radius", [0.05, 1e-3, 1e-5, 1e-7])
def test_without_its_pole_the_matrix_turns_as_much_in_few_pieces(radius: float) -> None:
    """The pair meets at P = −1.176i; any other number does where loops are large, and the half round is the same."""
    pole = complex(0, -1.1764322827208153)
    found = turned("0.67", 2, radius, 2, pole=pole, sides=16)
    assert found is not None
    assert found[0] == pytest.approx(-1, abs=0.02)
    if radius > 1e-3:
        plain, other = turned("0.67", 2, radius, 2), turned("0.67", 2, radius, 2, pole=0.3j)
        assert plain is not None
        assert other is not None
        assert [found[1], other[1]] == pytest.approx([plain[1]] * 2, abs=1e-6)
    if radius < 1e-5:
        assert turned("0.67", 2, radius, 2, sides=96) is None


def test_half_a_round_in_floats() -> None:
    """Below the branch point, against the determinant itself in 4,000 steps."""
    line = line_of("0.67", 2)
    centre = float(line.branch_points[0][0])
    z = centre + 0.05 * np.exp(1j * np.linspace(pi, 2 * pi, 4000))
    value = Floats(line.lower).delta(1j * z + 1e-13)[0]
    found = turned("0.67", 2, 0.05, 2)
    assert found is not None
    assert found[1] == pytest.approx(np.angle(value[1:] / value[:-1]).sum() / (2 * pi), abs=1e-5)
