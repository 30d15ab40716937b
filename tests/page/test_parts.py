"""The parts of a page: ranges that hold the case, and a page that always comes back."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve import Problem, read_problem, tracks, vehicles
from mpsolve.page.parts import critical_of, gather, rounded_up, top_velocity, velocities

BOGIE = read_problem("examples/two_layer_bogie.toml").problem


@given(st.fractions(min_value="1/100", max_value=10**9))
def test_round_numbers_are_not_below(x: Fraction) -> None:
    up = rounded_up(x)
    assert x <= up <= x * Fraction(11, 10) + Fraction(1, 100)


def test_the_range_holds_the_velocity_and_the_first_critical_one() -> None:
    top = top_velocity(BOGIE, critical_of(BOGIE))
    assert top > 2 * BOGIE.v
    assert float(top) > float(critical_of(BOGIE).velocities[0].value.mid())


def test_velocities_fill_the_range() -> None:
    v = velocities(Fraction(100), 10)
    assert len(v) == 10
    assert 0 < v.min() < v.max() < 100
    assert np.allclose(np.diff(v), 10)


@pytest.mark.parametrize("seconds", [0.001, 60.0])
def test_it_comes_back_whatever_the_budget(seconds: float) -> None:
    track = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
    parts = gather(Problem(track, vehicles.Mass(10000), v=100), "", digits=15, seconds=seconds, tell=lambda *_: None)
    assert parts.spectrum.proved
    assert parts.verdict.startswith("STABLE")
    assert bool(parts.late) == (seconds < 1)
