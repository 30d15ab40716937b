"""Loops round branch points: how large they may be, and what stands in their way."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import tracks, vehicles
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.paths import Paths
from mpsolve.characteristic.start import start
from mpsolve.errors import EffortError
from mpsolve.problem.line import Line, on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.branch_loops import Loop, edge_points, find_loops


def made(v: object, M: object = 70, N: object = 0) -> Line:
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1", N=N)
    found = on_line(reduce_problem(Problem(track, [vehicles.Mass(M), vehicles.Mass(M).at("1.5")], v=v)))
    assert found is not None
    return found


def loops(line: Line, effort: Effort | None = None) -> list[Loop]:
    paths = Paths(Arrays(line.lower), start(line.lower.guide))
    budget = effort or Effort(evaluations=100_000)
    return [find_loops(line, [paths], point, budget)[0] for point in edge_points(line)]


def test_the_loops_of_both_halves_are_those_of_each_by_itself() -> None:
    line = made("1.2")
    first, budget = start(line.lower.guide), Effort(evaluations=100_000)
    halves = [Paths(Arrays(half), first) for half in (line.lower, line.upper)]
    for point in edge_points(line):
        both = find_loops(line, halves, point, budget)
        alone = [find_loops(line, [half], point, budget)[0] for half in halves]
        for one, other in zip(both, alone, strict=True):
            assert (one.centre, one.radius, one.sides, one.half) == (
                other.centre,
                other.radius,
                other.sides,
                other.half,
            )
        assert both[0].half != both[1].half


def test_only_points_of_the_edge_need_a_loop() -> None:
    """At rest under tension p² < 0 at one meeting: that lies in the gap, between roots of one side."""
    tension = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1", kp="0.5")
    line = on_line(reduce_problem(Problem(tension, [vehicles.Mass(1)], v=0)))
    assert line is not None
    assert len(line.branch_points) == 2
    assert [point.multiplicity for point in edge_points(line)] == [1]
    assert len(edge_points(made("0.3", N="0.8"))) == 3


def test_a_loop_is_a_star_that_begins_below_the_axis() -> None:
    (loop,) = loops(made("0.67"))
    around = loop.points - float(made("0.67").branch_points[0][0])
    assert (np.angle(around[1:] / around[:-1]) > 0).all()
    assert loop.points[0] == loop.points[-1] == loop.first
    half = loop.points[: loop.sides // 2 + 1]
    assert half[-1] == loop.last
    assert (half[1:-1].imag < 0).all()
    assert (np.abs(loop.points - loop.centre) < loop.reach).all()


def test_a_light_mass_leaves_room_for_small_loops_only() -> None:
    (heavy,), (light,) = loops(made("0.67")), loops(made("0.67", "0.1"))
    assert light.radius < 1e-2 * heavy.radius


def test_effort_is_spent() -> None:
    with pytest.raises(EffortError):
        loops(made("0.67"), Effort(evaluations=10))


def test_a_root_that_nearly_reaches_the_cut_is_left_outside() -> None:
    """Undamped, η_M = 10, d = 1, α = 0.66: a root at z_b (1 − 1.09·10⁻⁴) by another engine."""
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1)
    line = on_line(reduce_problem(Problem(track, [vehicles.Mass(10), vehicles.Mass(10).at(1)], v="0.66")))
    assert line is not None
    (loop,) = loops(line)
    assert loop.first > loop.centre * (1 - 1.09e-4)
    assert loop.radius > 1e-7
