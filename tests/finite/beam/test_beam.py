from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from infinite import kernels, response
from oracle import grid

from mpsolve import Case, InputError
from mpsolve.finite.beam.beam import finite_beam
from mpsolve.finite.beam.march import Loading, march
from mpsolve.finite.beam.modes import Beam
from mpsolve.finite.beam.newmark import coupled_beam, newmark
from mpsolve.model.load import Load
from mpsolve.numbers.wave_integrals import gauss, moments, nested_moments

TAU = np.linspace(0, 60, 121)
FORCES = (Load(1, "0.4", "0.3", "0.5"), Load("0.5", "0.3", "1.2", "-1"), Load("-0.2"))


def pair(alpha: str, eta_m: int, eta_b: str, distance: str) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, distance))


def constant(values: list[float], places: list[float], eta_m: list[float]) -> Loading:
    force = np.array(values)
    return Loading(np.array(eta_m), np.array(places), lambda _tau: force)


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


@settings(max_examples=15)
@given(
    eta_m=st.lists(grid(0.1, 80), min_size=1, max_size=3),
    gaps=st.lists(grid(0, 3), min_size=2, max_size=2),
    forces=st.lists(grid(-2, 2), min_size=3, max_size=3),
    steps=st.integers(3, 40),
    axial=grid(-1, 0.9),
)
def test_a_resting_load_keeps_the_energy_at_any_step(
    eta_m: list[float], gaps: list[float], forces: list[float], steps: int, axial: float
) -> None:
    n = len(eta_m)
    beam = Beam(30.0, 50, 0.0, axial, 0.0, tail=False)
    places = [13.0, 13.0 + gaps[0], 13.0 + gaps[0] + gaps[1]][:n]
    motion = march(beam, constant(forces[:n], places, eta_m), 20.0, steps)
    k, rate, weight = beam.exponentials
    a, a_rate = (weight * motion.state).real, (weight * rate * motion.state).real
    kinetic = beam.length / 4 * np.sum(a_rate**2) + np.sum(eta_m * motion.velocity[:, -1] ** 2) / 2
    work = forces[:n] @ motion.deflection[:, -1]
    assert kinetic + beam.length / 4 * np.sum(beam.stiffness(k) * a**2) - work == pytest.approx(
        0, abs=1e-10 * (1 + kinetic)
    )


def test_the_driver_of_a_moving_load_pays_with_the_momentum_of_the_waves() -> None:
    """Energy − work of the forces + α ∫ w_τ w_x dx stays 0, until waves reach the supports."""
    beam, forces = Beam(160.0, 800, 0.7, 0.0, 0.0, tail=False), [2.0, 1.0]
    motion = march(beam, constant(forces, [70.0, 71.5], [30.0, 10.0]), 15.0, 240)
    k, rate, weight = beam.exponentials
    a, a_rate = (weight * motion.state).real, (weight * rate * motion.state).real
    energy = beam.length / 4 * np.sum(a_rate**2 + beam.stiffness(k) * a**2)
    energy += np.sum([30.0, 10.0] * motion.velocity[:, -1] ** 2) / 2
    x = np.linspace(0, 160, 4801)
    angle = np.multiply.outer(x, k)
    momentum = np.trapezoid((np.sin(angle) @ a_rate) * (np.cos(angle) @ (k * a)), x)
    work = forces @ motion.deflection[:, -1]
    assert abs(0.7 * momentum) > 0.01 * energy
    assert energy - work + 0.7 * momentum == pytest.approx(0, abs=2e-4 * energy)


@settings(max_examples=10)
@given(alpha=grid(0, 1.2), share=grid(0.1, 0.9), eta_b=grid(0, 1.5), axial=grid(-1, 0.9))
def test_masses_at_one_place_move_as_their_sum(alpha: float, share: float, eta_b: float, axial: float) -> None:
    beam = Beam(40.0, 90, alpha, axial, eta_b)
    one = march(beam, constant([2.0], [12.0], [20.0]), 12.0, 20)
    two = march(beam, constant([1.5, 0.5], [12.0, 12.0], [20 * share, 20 * (1 - share)]), 12.0, 20)
    assert np.abs(two.deflection - one.deflection).max() < 1e-9 * (1 + np.abs(one.deflection).max())


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


# --- the method ---------------------------------------------------------------------------------------------


def test_errors_fall_with_the_step_at_third_order_or_better() -> None:
    beam, loading = Beam(80.0, 200, 0.6, 0.0, 0.02), constant([2.0, 1.0], [20.0, 21.5], [40.0, 15.0])
    fine = march(beam, loading, 30.0, 1920).deflection
    errors = [np.abs(march(beam, loading, 30.0, n).deflection - fine[:, :: 1920 // n]).max() for n in (15, 30, 60)]
    assert errors[0] > 6 * errors[1] > 36 * errors[2]


def test_newmark_in_both_forms_is_one_and_tends_to_the_march_at_second_order() -> None:
    """(41) against (52), and both against modes that are integrated exactly."""
    beam = Beam(40.0, 50, 0.5, 0.1, 0.05, tail=False)
    loading = Loading(
        np.array([40.0, 10.0]),
        np.array([12.0, 13.5]),
        lambda tau: np.array([2 + np.sin(0.5 * tau), 1 + 0 * tau]),
        degree=3,
    )
    exact = march(beam, loading, 16.0, 256).deflection
    errors = []
    for steps in (256, 512):
        rearranged = newmark(beam, loading, 16.0, steps, coupled=False)
        assert np.abs(newmark(beam, loading, 16.0, steps, coupled=True) - rearranged).max() < 1e-11
        errors.append(np.abs(rearranged[:, :: steps // 256] - exact).max())
    assert errors[0] < 5e-3
    assert errors[0] == pytest.approx(4 * errors[1], rel=0.05)


def test_the_coupled_form_as_a_function_agrees_with_the_finite_beam() -> None:
    case = pair("0.5", 10, "0.1", "1")
    errors = []
    for modes in (70, 140):
        tau, deflection = coupled_beam(case, tau=10, start=30, length=70, modes=modes, steps=200)
        assert deflection.shape == (2, 201)
        errors.append(np.abs(deflection[:, 1:] - finite_beam(case, tau=tau[1:]).displacement).max())
    assert 0.1 > errors[0] > 4 * errors[1]  # what the modes that are left out would add falls with their number
    with pytest.raises(InputError, match="length: is 20, but the load"):
        coupled_beam(case, tau=10, start=30, length=20, modes=160, steps=400)


def test_the_tail_gives_what_thousands_of_modes_give() -> None:
    loading = constant([2.0, 2.0], [20.0, 21.0], [40.0, 40.0])
    many, cut, bare = (
        march(Beam(60.0, modes, 0.5, 0.2, 0.0, tail), loading, 20.0, 40).deflection
        for modes, tail in ((2000, True), (180, True), (180, False))
    )
    assert np.abs(cut - many).max() < 1e-5
    assert np.abs(bare - many).max() > 50 * np.abs(cut - many).max()


def test_a_critically_damped_mode_is_between_its_neighbours() -> None:
    critical = float(np.sqrt((np.pi / 10) ** 4 / 4 + 1))  # the damping that is critical for the first mode

    def deflection(eta_b: float) -> object:
        return march(Beam(10.0, 20, 0.1, 0.0, eta_b), constant([2.0], [4.0], [3.0]), 8.0, 16).deflection

    low, middle, high = (deflection(critical + shift) for shift in (-1e-5, 0.0, 1e-5))
    assert np.abs((low + high) / 2 - middle).max() < 1e-8
    assert np.abs(high - low).max() > 1e-6


@settings(max_examples=40)
@given(
    size=st.floats(1e-3, 60), turn=grid(0.25, 0.75), other=grid(-40, 40), a=st.integers(0, 2), power=st.integers(0, 4)
)
def test_integrals_agree_with_quadrature(size: float, turn: float, other: float, a: int, power: int) -> None:
    q, p = size * np.exp(2j * np.pi * turn), 1j * other - 0.1
    theta, weight = gauss(150)
    single = weight @ (theta**power * np.exp(q * theta))
    assert abs(moments(np.array([q]), power)[power, 0] - single) < 1e-12
    sigma = np.multiply.outer(theta, theta)
    inner = theta * (sigma**power * np.exp(q * sigma) @ weight)
    double = weight @ (theta**a * np.exp(p * theta) * inner)
    assert abs(nested_moments(np.array([p]), np.array([q]), 2, 4)[a, power, 0] - double) < 1e-12


# --- figures and refusals -----------------------------------------------------------------------------------


def test_given_figures_stay_and_a_short_beam_says_so() -> None:
    case, tau = pair("0.5", 10, "0", "1"), [5.0, 30.0, 60.0]
    short = finite_beam(case, tau=tau, length=40)
    assert (short.length, short.start) == (40, pytest.approx(4.5))
    truth = response(case, (Load(), Load()), tau, line=0.06)
    assert 1e-4 < np.abs(short.displacement - truth).max() < short.error.ends
    bare = finite_beam(case, tau=tau, length=31.2)
    assert 1e-3 < np.abs(bare.displacement - truth).max() < bare.error.ends
    given = finite_beam(case, tau=tau, start=20, modes=200, steps=90)
    assert (given.start, given.modes, given.steps, given.length) == (20, 200, 90, pytest.approx(71))


@pytest.mark.parametrize(
    ("key", "arguments"),
    [
        ("tau", {"tau": []}),
        ("tau", {"tau": [0.0]}),
        ("tau", {"tau": [3.0, 2.0]}),
        ("tau[1]", {"tau": [float("nan")]}),
        ("tau[1]", {"tau": [True]}),
        ("tau", {"tau": [-5, 5]}),
        ("xi[1]", {"xi": ["here"]}),
        ("tolerance", {"tolerance": 0}),
        ("tolerance", {"tolerance": 1}),
        ("tolerance", {"tau": [1e6]}),
        ("length", {"length": 25}),
        ("length", {"length": -1}),
        ("start", {"start": 0}),
        ("start", {"start": 3, "xi": [-4.0]}),
        ("modes", {"modes": 2}),
        ("modes", {"modes": 10.5}),
        ("steps", {"steps": 4}),
        ("modes", {"modes": 50_000}),
        ("length", {"length": 1e6}),
        ("steps", {"steps": 10**8, "tolerance": 0.9}),
        ("loads", {"loads": [Load()]}),
    ],
)
def test_what_cannot_be_used_is_named(key: str, arguments: dict[str, object]) -> None:
    with pytest.raises(InputError) as caught:
        finite_beam(pair("0.5", 10, "0.1", "1"), **{"tau": [50.0], **arguments})
    assert caught.value.key == key


def test_the_needed_length_is_said() -> None:
    with pytest.raises(InputError, match="give more than 26") as caught:
        finite_beam(pair("0.5", 10, "0.1", "1"), tau=[50.0], length=25)
    assert caught.value.key == "length"
