"""Strings: the speed of their waves, and certified points at which heavy masses are stable on both sides of it."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Problem, certify, passivity_velocity, receptance, tracks, vehicles
from mpsolve.passivity.answer import Kind

WIRE = tracks.String(T=27000, m="1.07", k=500, c=2)


def test_a_string_takes_up_to_the_speed_of_its_waves() -> None:
    found = passivity_velocity(WIRE, over={"v": (0, 200)}, digits=40)
    assert found.kind is Kind.LOST
    assert float(found.value) == float(found.wave_speeds[0]) == pytest.approx(np.sqrt(27000 / 1.07))
    assert found.value.rel_accuracy_bits() > 40 * 3.32
    assert passivity_velocity(WIRE, over={"v": (0, "158.8")}).kind is Kind.WHOLE
    above = passivity_velocity(WIRE, over={"v": (160, 200)})
    assert above.reason is not None
    assert above.reason.code == "wave-speed"


@pytest.mark.parametrize("v", [0, 80, 150, "158.8"])
def test_slower_than_its_waves_it_takes(v: object) -> None:
    q = np.geomspace(1e-2, 1e3, 200)
    assert (receptance(WIRE, xi=[0], omega=q, v=v)[0].imag < 0).all()
    assert certify(Problem(WIRE, vehicles.Mass(1000), v=v), region="unstable", check=False).count == 0
