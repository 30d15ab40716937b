"""Motions that no contact feels, against frequencies by hand."""

from __future__ import annotations

import pytest

from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.unfelt import unfelt_frequencies
from mpsolve.tracks import String
from mpsolve.vehicles import Mass, Oscillator, Vehicle

TRACK = String(T=1, m=1, k=1, c="0.1")
# two equal bodies on one wheel by equal springs: they move against each other, and the wheel stays
TWINS = Vehicle(
    M=[[3, 0, 0], [0, 2, 0], [0, 0, 2]],
    C=[[2, -1, -1], [-1, 1, 0], [-1, 0, 1]],
    K=[[16, -8, -8], [-8, 8, 0], [-8, 0, 8]],
    B=[[1], [0], [0]],
    places=[0],
)


def found(vehicles: list[object]) -> list[complex]:
    parts = reduce_problem(Problem(TRACK, vehicles, v=0)).parts
    return sorted((complex(q.mid()) for q in unfelt_frequencies(parts)), key=lambda q: (q.real, q.imag))


def test_every_motion_is_felt() -> None:
    assert found([Mass(1), Oscillator(wheel=1, body=2, k=3, c="0.1").at(2)]) == []


def test_twins_against_each_other() -> None:
    """2 σ² + σ + 8 = 0: σ = (−1 ± i√63)/4, q = −iσ."""
    assert found([TWINS]) == pytest.approx([-(63**0.5) / 4 + 0.25j, 63**0.5 / 4 + 0.25j], abs=1e-14)
