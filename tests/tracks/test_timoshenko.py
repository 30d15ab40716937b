"""Shear and rotary inertia: two velocities of short waves, and two limits that are known."""

from __future__ import annotations

import pytest

from mpsolve import dispersion, receptance
from mpsolve.tracks import EulerBernoulli, Timoshenko

RAIL = {"EI": "6.4e6", "m": 60, "k": "1e6", "c": 770}


def test_short_waves_run_at_the_shear_and_the_bar_velocity() -> None:
    p = 1e6
    branches = dispersion(Timoshenko(**RAIL, S="2.4e8", J="0.25"), [p])[0]
    speeds = sorted(x.real / p for x in branches if x.real > 0)
    assert speeds == pytest.approx([(2.4e8 / 60) ** 0.5, (6.4e6 / 0.25) ** 0.5], rel=1e-5)


def test_stiff_in_shear_and_thin_it_is_eulers_beam() -> None:
    thin = Timoshenko(**RAIL, S="1e18", J="1e-12")
    euler = EulerBernoulli(**RAIL)
    at = {"xi": [0, 1.5], "omega": [20, 300], "v": 30}
    assert receptance(thin, **at) == pytest.approx(receptance(euler, **at), rel=1e-7)


def test_without_bending_stiffness_to_speak_of_shear_is_a_string() -> None:
    """Statics of a rail that only shears: w(0) = 1/(2 √(k S))."""
    soft = Timoshenko(EI="1e14", m=60, S="2.4e4", J="0.25", k="1e6")
    assert receptance(soft, xi=[0], omega=[0], v=0)[0, 0] == pytest.approx(1 / (2 * (1e6 * 2.4e4) ** 0.5), rel=1e-3)
