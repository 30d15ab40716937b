"""The speed of the shortest waves of a track."""

from __future__ import annotations

from typing import Any

import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.passivity.short_waves import overtakes, slowest_short_wave
from mpsolve.problem.reduced import reduce_problem


def guide_of(track: object, v: int) -> Any:
    return reduce_problem(Problem(track, [vehicles.Mass(900).at(0)], v=v)).guide


def test_a_string_is_overtaken_at_the_speed_of_its_waves() -> None:
    wire = tracks.String(T=400, m=1, k=500, c=2)  # waves at 20 m/s
    slow, fast = (guide_of(wire, v) for v in (19, 21))
    assert slowest_short_wave(slow) / float(slow.v) == pytest.approx(20 / 19)
    assert not overtakes(slow, slow.v)
    assert overtakes(fast, fast.v)


def test_the_slower_of_two_kinds_of_waves_counts() -> None:
    """Shear waves at √(S/m) = 2000 m/s, bending waves at √(EI/J) = 5000 m/s; a beam's run ever faster."""
    beam = {"EI": "6e6", "m": "60", "k": "1e6", "c": "770"}
    guide = guide_of(tracks.Timoshenko(**beam, S="2.4e8", J="0.24"), 100)
    assert slowest_short_wave(guide) / float(guide.v) == pytest.approx(20)
    assert slowest_short_wave(guide_of(tracks.EulerBernoulli(**beam), 100)) == float("inf")
