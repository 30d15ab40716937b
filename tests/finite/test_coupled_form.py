"""The plain form (41) in time, against the march of the rearranged one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from newmark import Beam, newmark

from mpsolve import Case, Load
from mpsolve.finite.case import Case as Track
from mpsolve.vibration.case_motion import units_of

BEAM = Beam(
    40.0, 50, 0.5, 0.1, 0.05, np.array([40.0, 10.0]), np.array([12.0, 13.5]),
    lambda tau: np.array([2 + np.sin(0.5 * tau), 1 + 0 * tau]),
)  # fmt: skip


def marched(times: Any, modes: int, beyond: bool = False) -> Any:
    """The same beam on the finite track, where the force 2η_C + 2η_A sin(ω̂τ + φ) is that of loads in w_st."""
    units = units_of(Case(alpha="0.5", eta_b="0.05", eta_n="0.1", eta_m=(40, 10), positions=(0, "1.5")))
    loads = units.loads([Load(1, "0.5", "0.5"), Load("0.5")], 1 / units.w_st)
    track = Track(units.problem, loads, BEAM.length, times, None, BEAM.places[0], 1e-4)
    return track.solve(modes, 512, beyond=beyond).rail[:, track.asked]


def test_newmark_in_both_forms_is_one_and_tends_to_the_march_at_second_order() -> None:
    """(41) against (52), and both against modes that are integrated exactly."""
    exact, errors = marched(np.linspace(0, 16, 257), BEAM.count), []
    for steps in (256, 512):
        rearranged = newmark(BEAM, 16.0, steps, coupled=False)
        assert np.abs(newmark(BEAM, 16.0, steps, coupled=True) - rearranged).max() < 1e-11
        errors.append(np.abs(rearranged[:, :: steps // 256] - exact).max())
    assert errors[0] < 5e-3
    assert errors[0] == pytest.approx(4 * errors[1], rel=0.05)


def test_the_modes_beyond_give_what_thousands_of_modes_give() -> None:
    times = np.linspace(0, 16, 33)
    many, cut, bare = marched(times, 2000, True), marched(times, 120, True), marched(times, 120)
    assert np.abs(cut - many).max() < 3e-5
    assert np.abs(bare - many).max() > 50 * np.abs(cut - many).max()
