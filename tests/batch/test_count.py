"""Counts of a group against the argument principle round a whole rectangle, and lines that are fine enough."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.batch.count import count_group, waves_meet
from mpsolve.batch.entries import entries_of
from mpsolve.batch.groups import Group, groups_of
from mpsolve.batch.kernel import log_delta
from mpsolve.batch.passive import first_passive

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
PAIR = Problem(BEAM, vehicles.train(vehicles.Mass(70), 2, "1.5"), v="0.67")


def group_of(problem: Problem, over: dict[str, Any] | None = None) -> Group:
    entries = entries_of(problem, over or {})
    ((group,), _) = groups_of(entries, np.arange(len(entries)))
    return group


def enclosed(group: Group, row: int, width: float, depth: float, top: float) -> int:
    """Roots in a rectangle that is symmetric to the imaginary axis, by 40,000 points round it."""
    corners = [complex(-width, -depth), complex(width, -depth), complex(width, top), complex(-width, top)]
    q = np.concatenate(
        [
            a + (b - a) * np.linspace(0, 1, 10_001)[:-1]
            for a, b in zip(corners, corners[1:] + corners[:1], strict=True)
        ]
    )
    log, _ = log_delta(group, np.full(len(q), row), 1j * q)
    steps = np.angle(np.exp(1j * np.diff(np.append(log.imag, log.imag[0]))))
    assert np.abs(steps).max() < 1
    return round(float(steps.sum()) / (2 * np.pi))


@pytest.mark.parametrize("height", [0.0, 0.03])
def test_half_a_contour_says_what_a_whole_one_says(height: float) -> None:
    group = group_of(PAIR, {"v": [0.4, 0.55, 0.75, 1.1], "vehicles.M": [10, 70, 70, 30]})
    rho = np.maximum(first_passive(group), 2.0)
    found = count_group(group, rho, np.full(4, height / group.unit))
    assert not found.why
    for row in range(4):
        top = height / group.unit[row] if height else -1e-7
        assert found.count[row] == enclosed(group, row, float(rho[row]), 3.0, float(top))


def test_the_corner_may_lie_farther_out() -> None:
    group = group_of(PAIR, {"v": np.linspace(0.3, 1.3, 9)})
    rho, zero = first_passive(group), np.zeros(9)
    assert np.array_equal(count_group(group, rho, zero).count, count_group(group, 7 * rho, zero).count)


def test_a_root_on_the_line_is_told() -> None:
    """At an onset, found by bisection of the count itself, the line has no end of points."""
    low, high = 0.66, 0.67
    while high - low > 4e-16:
        middle = (low + high) / 2
        group = group_of(PAIR, {"v": [middle]})
        found = count_group(group, first_passive(group), np.zeros(1))
        if found.count[0] < 0:
            assert "next to it" in found.why[0]
            return
        low, high = (middle, high) if found.count[0] == 0 else (low, middle)
    pytest.fail("no velocity was left open")


def test_two_roots_that_cancel_a_step_are_not_stepped_over() -> None:
    """Equal bogies far apart on a line of their own: pairs of roots next to the axis, and to one another."""
    bogie = vehicles.Bogie(wheel="0.1", frame=5, inertia="0.5", wheelbase="0.1", k=20, c=0)
    problem = Problem(BEAM, [bogie.at(0), bogie.at(40)], v="0.9")
    group = group_of(problem)
    rho = first_passive(group)
    found = count_group(group, rho, np.zeros(1))
    q = np.linspace(0, float(rho[0]), 200_001)
    log, _ = log_delta(group, np.zeros(len(q), int), 1j * q)
    dense = np.angle(np.exp(1j * np.diff(log.imag)))
    if np.abs(dense).max() < 1 and found.count[0] >= 0:
        line = found.line.log.imag
        assert np.angle(np.exp(1j * np.diff(line))).sum() == pytest.approx(dense.sum(), abs=1e-6)


def test_waves_that_meet_at_zero() -> None:
    ice = tracks.FloatingIce(B="5e8", h=1, rho_ice=917, rho_water=1026, depth=3, g="9.81", c=10, eta="0.05")
    group = group_of(Problem(ice, vehicles.Mass(2000), v=3))
    assert waves_meet(group)
    assert not waves_meet(group_of(PAIR))
    assert count_group(group, first_passive(group), np.zeros(1)).count.tolist() == [0]
