"""The parts of a page: ranges that hold the case, and a page that always comes back."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import Problem, read_problem, tracks, vehicles
from mpsolve.page.parts import gather, velocities

BOGIE = read_problem("examples/two_layer_bogie.toml").problem


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
