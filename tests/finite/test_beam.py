from __future__ import annotations

import numpy as np
import pytest
from beam_loads import FORCES, TAU, pair
from hypothesis import given, settings
from hypothesis import strategies as st
from infinite import kernels, response
from oracle import grid

from mpsolve import Case
from mpsolve.finite.beam import finite_beam
from mpsolve.vehicles.load import Load

# --- against the infinite beam ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("alpha", "eta_m", "eta_b", "distance"),
    [("0.5", 40, "0", "0.5"), ("0.5", 40, "0", "4.5"), ("0.9", 40, "0", "1.5"), ("0.9", 70, "0.05", "1")],
)
def test_cases_of_the_appendix_agree_with_the_infinite_beam(
    alpha: str, eta_m: int, eta_b: str, distance: str
) -> None:
    """Figures A.1, A.2 and A.5."""
    case = pair(alpha, eta_m, eta_b, distance)
    found = finite_beam(case, tau=TAU)
    truth = response(case, (Load(), Load()), TAU, line=0.06)
    assert found.error.total < 3e-4 * np.abs(truth).max()
    assert np.abs(found.displacement - truth).max() < found.error.total


def test_unequal_masses_under_harmonic_forces_and_the_shape() -> None:
    case = Case(alpha="0.7", eta_b="0.05", eta_m=(30, 12), positions=(0, 2))
    xi = [-3.0, 1.0, 4.0]
    found = finite_beam(case, FORCES[:2], TAU, xi=xi)
    truth = response(case, FORCES[:2], TAU, xi, line=0.06)
    assert np.abs(found.displacement - truth[:2]).max() < found.error.total < 1e-3
    assert np.abs(found.shape - truth[2:]).max() < found.error.total


def test_three_masses_with_axial_force_two_of_them_at_one_place() -> None:
    case = Case(alpha="0.6", eta_b="0.05", eta_m=(30, 12, 20), positions=(1, 3, 3), eta_n="0.3", eta_s="0.1")
    found = finite_beam(case, FORCES, TAU)
    truth = response(case, FORCES, TAU, line=0.06)
    assert np.abs(found.displacement - truth).max() < found.error.total < 1e-3


def test_growing_motion_above_the_critical_velocity() -> None:
    case, tau = pair("1.2", 40, "0.05", "1.5"), np.linspace(0, 30, 31)
    found = finite_beam(case, tau=tau)
    truth = response(case, (Load(), Load()), tau, line=0.4)
    assert np.abs(truth).max() > 15
    assert np.abs(found.displacement - truth).max() < found.error.total < 3e-4 * np.abs(truth).max()


def test_more_than_critical_damping() -> None:
    case = Case(alpha="0.5", eta_b="1.2", eta_m=(5, 3), positions=(0, 1))
    found = finite_beam(case, FORCES[:2], TAU)
    truth = response(case, FORCES[:2], TAU, line=0.06)
    assert np.abs(found.displacement - truth).max() < found.error.total < 1e-3


def test_contact_forces_are_those_of_the_infinite_beam() -> None:
    case, tau = pair("0.8", 70, "0.05", "1"), np.linspace(5, 60, 300)
    found = finite_beam(case, tau=tau)
    truth = 1 - 35 * response(case, (Load(), Load()), tau, line=0.06, last=200, accelerations=True)
    assert np.abs(found.contact_forces - truth).max() < found.error.force < 0.1


# --- limits -------------------------------------------------------------------------------------------------


def test_static_deflection_is_one() -> None:
    found = finite_beam(Case(alpha=0, eta_b="0.6", eta_m=2), tau=[50.0])
    assert found.displacement == pytest.approx(1, abs=found.error.total)
    assert found.contact_forces == pytest.approx(1, abs=1e-4)


def test_a_light_mass_comes_to_the_steady_state_of_a_moving_force() -> None:
    """4 η_C K(ξ, 0)/π of (36)."""
    case, xi = Case(alpha="0.6", eta_b="0.2", eta_m="1e-9"), np.array([-4.0, -1.0, 0.0, 0.5, 3.0])
    found = finite_beam(case, tau=[70.0], xi=xi)
    steady = 4 / np.pi * kernels(case, np.array([-1e-12j]), xi)[:, 0].real
    assert found.shape[:, 0] == pytest.approx(steady, abs=1e-4)


# --- invariants ---------------------------------------------------------------------------------------------


@settings(max_examples=4)
@given(first=st.lists(grid(-1, 1), min_size=4, max_size=4), second=st.lists(grid(-1, 1), min_size=4, max_size=4))
def test_forces_superpose(first: list[float], second: list[float]) -> None:
    case = Case(alpha="0.5", eta_b="0.1", eta_m=(20, 5), positions=(0, 1))
    figures = {"start": 12.0, "length": 40.0, "modes": 120, "steps": 40}

    def motion(a: list[float]) -> object:
        loads = [Load(a[0], a[1], "0.5"), Load(a[2], a[3], "0.5", "0.7")]
        return finite_beam(case, loads, [4.0, 10.0], **figures).displacement

    both = motion([a + b for a, b in zip(first, second, strict=True)])
    assert np.allclose(both, motion(first) + motion(second), atol=1e-11)
