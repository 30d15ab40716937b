"""The turn along sides: zeros of a known problem are counted, and a turn that is no whole number is none."""

from __future__ import annotations

import pytest
from flint import arb

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.paths import Paths
from mpsolve.characteristic.start import start
from mpsolve.errors import PrecisionError
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.sides import along_sides, side, whole_turn, zeros


def test_the_turn_round_a_rectangle_counts_its_zeros() -> None:
    """A mass of 40 on the paper's beam at v = 1.3 has one pair of growing roots near ±0.13, at −0.009i."""
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=1)
    reduced = reduce_problem(Problem(beam, [vehicles.Mass(40)], v="1.3"))
    paths = Paths(Arrays(reduced), start(reduced.guide))
    corners = [-0.5 - 0.5j, 0.5 - 0.5j, 0.5 - 1e-4j, -0.5 - 1e-4j, -0.5 - 0.5j]
    turn = whole_turn(along_sides(paths, corners, Effort()))
    assert zeros(turn / (2 * arb.pi())) == 2
    with pytest.raises(PrecisionError, match="not one number"):
        zeros(turn / (2 * arb.pi()) + 0.5)
    with pytest.raises(PrecisionError, match="not one number"):
        zeros(-turn)


def test_a_side_keeps_its_ends_and_has_no_point_twice() -> None:
    assert side(0j, 1 + 0j, 4).tolist() == [0, 0.25, 0.5, 0.75, 1]
    assert side(1j, 1j, 6).tolist() == [1j]
