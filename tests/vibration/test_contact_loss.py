"""Contact loss, found afterwards: whatever the times given, nothing that contradicts the forces."""

from __future__ import annotations

import math

import numpy as np
import pytest

from mpsolve import Case, response
from mpsolve.vehicles.load import Load
from mpsolve.vibration.case_table import columns
from mpsolve.vibration.scale import Scale

FAST = Case(alpha="1.2", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))  # unstable: both masses lift off
LONE = Case(alpha="0.67", eta_b="0.05", eta_m=70)


@pytest.mark.parametrize("points", [3, 11, 21, 81, 401])
def test_rounding_at_the_start_is_no_loss(points: int) -> None:
    fine = response(FAST, tau=np.linspace(0, 80, 4001)).contact_loss
    found = response(FAST, tau=np.linspace(0, 80, points))
    step = 80 / (points - 1)
    for j, (loss, note) in enumerate(zip(found.contact_loss, found.contact_note, strict=True)):
        assert loss is not None
        assert fine[j] is not None
        force = np.interp(loss, found.tau, found.contact_forces[j])
        assert note or abs(force) < 1e-9
        assert not note or (loss == step and "before" in note and found.contact_forces[j, 1] < 0)
        assert fine[j] - step < loss < fine[j] + step  # type: ignore[operator]


def test_the_first_of_them_hangs_on_no_grid() -> None:
    events = [response(FAST, tau=tau).lift_off for tau in ([8], np.linspace(0, 8, 20))]
    assert all(event is not None for event in events)
    one, *others = (event for event in events if event)
    for other in others:
        assert (other.contact, abs(other.time - one.time) <= one.tolerance + other.tolerance) == (one.contact, True)
    fine = response(FAST, tau=np.linspace(0, 8, 401))
    first = min(time for time in fine.contact_loss if time is not None)
    assert one.time == pytest.approx(first, abs=one.tolerance)
    assert fine.within.tolist() == (fine.tau <= one.time).tolist()
    assert columns(fine, Scale())["within the model"].tolist() == fine.within.tolist()
    assert not fine.within.all()
    assert response(FAST, tau=[one.time / 2]).lift_off is None


def test_times_in_any_order() -> None:
    tau = np.linspace(0, 80, 81)
    there, back = response(FAST, tau=tau), response(FAST, tau=tau[::-1])
    assert there.contact_loss == back.contact_loss


def test_of_two_masses_at_one_place_the_one_pressed_less_is_lifted_at_once() -> None:
    """(2): both fall with ΣP/ΣM, so the contact force P_j − M_j ΣP/ΣM is −0.4 and 0.4."""
    case = Case(alpha="0.5", eta_b="0.1", eta_m=(70, 30), positions=(0, 0))
    found = response(case, tau=(0, "0.1", 1))
    assert found.contact_forces[:, 0] == pytest.approx([-0.4, 0.4], abs=1e-15)
    assert (found.contact_loss, found.contact_note) == ((0.0, None), ("", ""))
    assert found.lift_off is not None
    assert (found.lift_off.time, found.lift_off.contact) == (0.0, 1)
    later = response(case, tau=("0.1", 1))
    assert later.contact_loss == (0.1, None)
    assert "before τ = 0.1" in later.contact_note[0]


def test_a_load_of_frequency_zero_is_constant() -> None:
    pressed = response(LONE, [Load(0, 1, 0, "1.5")], tau=(0, 5))
    same = response(LONE, [Load(math.sin(1.5))], tau=(0, 5))
    assert pressed.contact_note == ("",)
    assert pressed.contact_forces == pytest.approx(same.contact_forces, abs=1e-12)
    pulled = response(LONE, [Load(1, -3, 0, "1.5")], tau=(0, 5))
    assert "no constant force" in pulled.contact_note[0]
