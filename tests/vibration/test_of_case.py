"""The parts of the motion against the initial conditions, numerical inversion, and limits in closed form."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import event, given, settings
from hypothesis import strategies as st
from laplace import Inversion
from oracle import Truth, cases

from mpsolve import Case, Effort, InputError, MpsolveError, certify, response
from mpsolve.errors import PrecisionError
from mpsolve.numbers.exact import Exact
from mpsolve.vehicles.load import Load
from mpsolve.vibration.case_motion import Scale
from mpsolve.vibration.table import case_columns

TWO: dict[str, Any] = {"eta_m": (70, 70), "positions": (0, "1.5")}
DAMPED = Case(alpha="0.67", eta_b="0.05", **TWO)
UNDAMPED = Case(alpha="0.5", eta_b=0, **TWO)
FAST = Case(alpha="1.2", eta_b="0.05", **TWO)
MIXED = (Load("0.7", "0.5", "0.3", "0.2"), Load(1))

REGIMES = [
    DAMPED,
    UNDAMPED,
    FAST,
    Case(alpha="1.2", eta_b=0, **TWO),
    Case(alpha=1, eta_b="0.1", eta_m=(40, 30), positions=(0, 1)),
    Case(alpha="0.4", eta_b=0, eta_n="0.6", **TWO),  # a complex branch point next to the cut
    Case(alpha="0.1", eta_b=0, eta_n="0.6", **TWO),  # three branch points on each cut
    Case(alpha=0, eta_b=0, **TWO),
    Case(alpha="0.01", eta_b="0.02", **TWO),
    Case(alpha="0.67", eta_b="0.05", eta_m=70),
    Case(alpha="1.219", eta_b="0.115", eta_s="0.5", eta_m="21.34"),  # a zero on the continued sheet
    Case(alpha="0.839", eta_b=0, eta_n="0.7", eta_m="9.25"),
]


@pytest.mark.parametrize("case", REGIMES, ids=lambda case: f"{case.alpha.short()}-{case.eta_b.short()}-{case.count}")
def test_the_parts_add_up_to_rest_at_the_start(case: Case) -> None:
    found = response(case, None, (-3, 0, "0.7", float(case.positions[-1]), 6), (0, "0.001"))
    size = max(np.abs(found.steady).max(), np.abs(found.harmonic).max())
    assert np.abs(found.w[:, 0]).max() < 1e-10 * size
    assert np.abs(found.velocity[:, 0]).max() < 1e-10 * size
    assert size > 0.1
    assert np.abs(found.transient[:, 0]).max() > 1e-12  # without it the others do not add up


@settings(max_examples=8)
@given(cases(masses=1))
def test_the_parts_add_up_to_rest_or_are_refused(case: Case) -> None:
    try:
        found = response(case, None, None, (0,))
    except MpsolveError as error:
        event(f"refused: {error}")
        return
    size = max(np.abs(found.steady).max(), np.abs(found.harmonic).max(), np.abs(found.transient).max())
    assert np.abs(found.w).max() < 1e-8 * size


def test_few_cases_are_refused() -> None:
    """A seeded sample: almost every case can be done."""
    random, refused = np.random.default_rng(8), 0
    for _ in range(8):
        alpha, eta_b, eta_m, d = (round(x, 3) for x in random.uniform((0, 0, 5, 0.4), (1.4, 0.6, 80, 2.5)))
        try:
            response(Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, d)), None, None, (0,))
        except PrecisionError:
            refused += 1
    assert refused <= 1


@pytest.mark.parametrize("case", [DAMPED, UNDAMPED, FAST], ids=["damped", "undamped", "fast"])
def test_the_sum_is_the_inverse_laplace_transform(case: Case) -> None:
    xi, times = (0, 1.5, -4, 0.6), (0.2, 5.0, 25.0)
    found = response(case, MIXED, xi, times)
    for w, tau in zip(found.w.T, times, strict=True):
        off = np.abs(w - Inversion(case, MIXED, growth=0.3)(xi, tau)).max()
        assert off < min(found.error, 1e-8) * np.abs(found.w).max()


def test_unequal_masses_at_three_places_and_far_positions() -> None:
    case = Case(alpha="0.5", eta_b="0.1", eta_m=(70, 40, 30), positions=(0, 1, "2.5"))
    loads = (Load(1, "0.5", "0.3"), Load(0, 1, "0.9", "0.4"), Load(2))
    xi = (0, 1, 2.5, -12.0)
    found = response(case, loads, xi, (30,), certify(case, digits=20))
    assert np.allclose(found.w[:, 0], Inversion(case, loads)(xi, 30.0), rtol=0, atol=1e-10)


def test_a_force_that_radiates_without_damping() -> None:
    """Its frequency lies on the cut, where the steady state takes the values from below."""
    loads = (Load(1, 1, "0.9"), Load(0))
    found = response(UNDAMPED, loads, (0, 1.5), (30,))
    assert np.allclose(found.w[:, 0], Inversion(UNDAMPED, loads)((0, 1.5), 30.0), rtol=0, atol=1e-10)


def test_far_away() -> None:
    found = response(DAMPED, None, (-100, 100, -30, 30), ("0.5", 25))
    assert np.abs(found.w[:2, 0]).max() < 1e-10  # nothing has arrived
    assert np.allclose(found.w[2:, 1], Inversion(DAMPED, (Load(), Load()))((-30, 30), 25.0), rtol=0, atol=1e-10)


def test_at_the_start_a_mass_falls_freely() -> None:
    """η_M w_ττ/2 = η_C while the beam does not resist yet; it resists like √τ."""
    found = response(DAMPED, None, None, ("1e-4", "1e-6"))
    fall = found.tau**2 / 70
    assert np.abs(found.w[0] / fall - 1)[0] < 1e-2
    assert np.allclose(found.acceleration, 2 / 70, rtol=1e-2)


def test_long_after_the_start_only_the_steady_state_or_the_growth_is_left() -> None:
    calm = Case(alpha="0.5", eta_b="0.2", **TWO)
    found = response(calm, None, None, (10_000,))
    assert np.allclose(found.w, found.steady, rtol=0, atol=1e-13)
    spectrum = certify(FAST)
    (q,) = (complex(root.q.mid()) for root in spectrum.roots if root.q.imag < 0 and root.q.real > 0)
    period = 2 * np.pi / q.real
    found = response(FAST, None, None, (200, 200 + period), spectrum)
    assert np.allclose(found.w[:, 1] / found.w[:, 0], np.exp(-q.imag * period), rtol=1e-6)


def test_a_load_at_rest_leaves_the_static_deflection() -> None:
    case = Case(alpha=0, eta_b="0.5", eta_m=1)
    xi = np.array([0.0, 0.5, -0.5, 2.0])
    found = response(case, None, xi, (1000,))
    assert np.allclose(found.w[:, 0], np.exp(-np.abs(xi)) * (np.cos(xi) + np.sin(np.abs(xi))), atol=1e-12)


def test_velocity_acceleration_and_contact_force_agree_with_the_displacement() -> None:
    step = 1e-3
    tau = np.arange(2.0, 2.2, step)
    found = response(DAMPED, MIXED, None, tau)
    velocity = (found.w[:, 2:] - found.w[:, :-2]) / (2 * step)
    acceleration = (found.w[:, 2:] - 2 * found.w[:, 1:-1] + found.w[:, :-2]) / step**2
    assert np.allclose(found.velocity[:, 1:-1], velocity, rtol=0, atol=1e-6)
    assert np.allclose(found.acceleration[:, 1:-1], acceleration, rtol=0, atol=1e-6)
    applied = np.array([0.7 + 0.5 * np.sin(0.3 * tau + 0.2), 1 + 0 * tau])
    assert np.allclose(found.contact_forces, applied - 35 * found.acceleration, rtol=0, atol=1e-12)


def test_masses_at_one_position_move_as_one() -> None:
    apart = Case(alpha="0.67", eta_b="0.05", eta_m=(30, 40), positions=(0, 0))
    whole = Case(alpha="0.67", eta_b="0.05", eta_m=70)
    tau = (0, 3, 20)
    found, single = response(apart, (Load(2), Load(1)), None, tau), response(whole, (Load(3),), None, tau)
    assert np.allclose(found.w, single.w, rtol=0, atol=1e-13)
    assert np.allclose(found.contact_forces.sum(0), single.contact_forces[0], rtol=0, atol=1e-12)
    assert np.allclose(found.acceleration[0], found.acceleration[1])


def test_the_motion_is_linear_in_the_loads() -> None:
    spectrum, tau = certify(DAMPED), (1, 7, 40)
    first = response(DAMPED, (Load(1), Load(0)), None, tau, spectrum)
    second = response(DAMPED, (Load(0, "0.4", "0.7", 1), Load(2)), None, tau, spectrum)
    both = response(DAMPED, (Load(1, "0.4", "0.7", 1), Load(2)), None, tau, spectrum)
    assert np.allclose(first.w + second.w, both.w, rtol=0, atol=1e-12)


def test_the_parts_are_what_they_are_called() -> None:
    found = response(DAMPED, MIXED, (0, 1), (3, 10))
    assert np.allclose(sum(pair.contribution for pair in found.harmonic_pairs), found.harmonic, atol=1e-14)
    for pair in found.harmonic_pairs:
        wave = (pair.amplitude[:, None] * np.exp(1j * pair.q * found.tau)).real
        assert np.allclose(wave, pair.contribution, atol=1e-14)
    truth, w = Truth(DAMPED), 0.3
    mp = truth.mp
    K = np.array([[complex(truth.kernel(x - y, mp.mpf("0.3"))) for y in truth.x] for x in truth.x])
    force = np.array([0.5 * np.exp(1j * (0.2 - np.pi / 2)), 0])
    W = np.linalg.solve(np.pi * np.eye(2) - 2 * w * w * 70 * K, K @ (4 * force))  # (25)
    expected = (W[:, None] * np.exp(1j * w * found.tau)).real
    shown = response(DAMPED, MIXED, None, (3, 10)).steady_harmonic
    assert np.allclose(shown, expected, atol=1e-12)


def test_contact_is_lost_where_the_force_vanishes() -> None:
    tau = np.linspace(0, 100, 1001)
    found = response(DAMPED, None, None, tau)
    for time, force in zip(found.contact_loss, found.contact_forces, strict=True):
        later = force[1:]  # at τ = 0 itself the force is 0: the mass falls freely
        assert (time is None) == bool(np.all(later > 0))
        if time is not None:
            assert np.all(later[tau[1:] < time - 0.1] > 0)
            assert abs(np.interp(time, tau, force)) < 1e-10
    assert any(time is not None for time in response(FAST, None, None, tau).contact_loss)
    unloaded = response(DAMPED, (Load(1), Load(0)), None, (0, 1))
    assert unloaded.contact_loss[1] is None
    assert "no constant force" in unloaded.contact_note[1]
    assert not unloaded.contact_note[0]


def test_what_cannot_be_is_refused() -> None:
    spectrum = certify(DAMPED)
    with pytest.raises(InputError, match="tau"):
        response(DAMPED, None, None, (-1,), spectrum)
    with pytest.raises(InputError, match="tau"):
        response(FAST, None, None, (1e6,))
    with pytest.raises(InputError, match=r"xi\[2\]"):
        response(DAMPED, None, (0, "here"), (1,), spectrum)
    with pytest.raises(InputError, match="spectrum"):
        response(UNDAMPED, None, None, (1,), spectrum)
    with pytest.raises(InputError, match="spectrum: is of type int"):
        response(DAMPED, None, None, (1,), 3)  # type: ignore[call-overload]
    for size in ("1e350", "1e-350"):
        with pytest.raises(InputError, match=r"tau\[1\]: is 1e.350, beyond the range of float64"):
            response(DAMPED, None, None, size, spectrum)


def test_one_number_may_come_in_any_form() -> None:
    spectrum = certify(DAMPED)
    forms = ("0.5", 0.5, Fraction(1, 2), np.float64(0.5), np.array(0.5), np.array("0.5"), [0.5], (0.5,))
    values = [response(DAMPED, None, form, form, spectrum).w for form in forms]
    assert all(np.array_equal(value, values[0]) for value in values)
    with pytest.raises(PrecisionError, match=r"undecided.*change a parameter"):
        response(Case(alpha=1, eta_b=0, eta_m=10), None, None, (1,))


def test_a_force_near_an_induced_frequency_is_refused_and_farther_away_is_right() -> None:
    spectrum = certify(UNDAMPED)
    q = min(float(root.q.real.mid()) for root in spectrum.roots if root.q.real > 0)
    with pytest.raises(InputError, match="move by themselves"):
        response(UNDAMPED, (Load(1, 1, q), Load()), None, (1,), spectrum)
    loads = (Load(1, 1, q * (1 + 1e-4)), Load())
    found = response(UNDAMPED, loads, (0, 1.5), (30,), spectrum)
    assert np.abs(found.harmonic).max() > 1e3  # the parts are large and cancel
    assert np.allclose(found.w[:, 0], Inversion(UNDAMPED, loads)((0, 1.5), 30.0), rtol=0, atol=1e-9)


@given(st.integers(66, 400))
@settings(max_examples=3)
def test_evenly_spaced_times_make_no_difference(count: int) -> None:
    case = REGIMES[9]
    even = np.linspace(0, 50, count + 1)[1:]
    bent = np.append(even, 51.23)
    assert np.allclose(response(case, None, (0, 1), bent).w[:, :-1], response(case, None, (0, 1), even).w, atol=1e-12)


@pytest.mark.parametrize("size", ["1e-4", 300_000])
def test_the_size_of_the_loads_costs_no_accuracy(size: Any) -> None:
    """Forces in newtons and tiny ones get the same relative accuracy as unit forces."""
    case = Case(alpha="0.5", eta_b="0.05", eta_m=70)
    unit = response(case, [Load(1, "0.3", "0.4", 1)], tau=(0.5, 5, 50))
    scaled = response(case, [Load(size, Exact("0.3") * Exact(size), "0.4", 1)], tau=(0.5, 5, 50))
    assert np.allclose(scaled.w, unit.w * float(size), rtol=1e-11, atol=0)
    assert np.allclose(scaled.contact_forces, unit.contact_forces * float(size), rtol=1e-9, atol=0)


def test_spent_effort_leaves_what_is_known_and_says_why() -> None:
    none = response(DAMPED, None, (0,), (1, 5), effort=Effort(evaluations=1))
    assert none.reason is not None
    assert none.reason.code == "effort"
    assert none.w.shape == (1, 2)
    assert np.isnan(none.w).all()
    assert all("effort" in note for note in none.contact_note)
    heard: list[str] = []
    whole = response(DAMPED, None, (0,), (1, 5), progress=lambda stage, _: heard.append(stage))
    assert whole.reason is None
    assert {"integral", "times"} <= set(heard)


FAST_contact_loss = Case(
    alpha="1.2", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5")
)  # unstable: both masses lift off
LONE = Case(alpha="0.67", eta_b="0.05", eta_m=70)


@pytest.mark.parametrize("points", [3, 11, 21, 81, 401])
def test_rounding_at_the_start_is_no_loss(points: int) -> None:
    fine = response(FAST_contact_loss, tau=np.linspace(0, 80, 4001)).contact_loss
    found = response(FAST_contact_loss, tau=np.linspace(0, 80, points))
    step = 80 / (points - 1)
    for j, (loss, note) in enumerate(zip(found.contact_loss, found.contact_note, strict=True)):
        assert loss is not None
        assert fine[j] is not None
        force = np.interp(loss, found.tau, found.contact_forces[j])
        assert note or abs(force) < 1e-9
        assert not note or (loss == step and "before" in note and found.contact_forces[j, 1] < 0)
        assert fine[j] - step < loss < fine[j] + step  # type: ignore[operator]


def test_the_first_of_them_hangs_on_no_grid() -> None:
    events = [response(FAST_contact_loss, tau=tau).lift_off for tau in ([8], np.linspace(0, 8, 20))]
    assert all(event is not None for event in events)
    one, *others = (event for event in events if event)
    for other in others:
        assert (other.contact, abs(other.time - one.time) <= one.tolerance + other.tolerance) == (one.contact, True)
    fine = response(FAST_contact_loss, tau=np.linspace(0, 8, 401))
    first = min(time for time in fine.contact_loss if time is not None)
    assert one.time == pytest.approx(first, abs=one.tolerance)
    assert fine.within.tolist() == (fine.tau <= one.time).tolist()
    assert case_columns(fine, Scale())["within the model"].tolist() == fine.within.tolist()
    assert not fine.within.all()
    assert response(FAST_contact_loss, tau=[one.time / 2]).lift_off is None


def test_times_in_any_order() -> None:
    tau = np.linspace(0, 80, 81)
    there, back = response(FAST_contact_loss, tau=tau), response(FAST_contact_loss, tau=tau[::-1])
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
