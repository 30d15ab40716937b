"""The motion in balls: held against a second way to it, against its initial conditions, and against itself."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest
from continued import Continued
from flint import arb

from mpsolve import Case, Effort, certify, response
from mpsolve.errors import EffortError, InputError, PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.exact import Exact
from mpsolve.vehicles.load import Load
from mpsolve.vibration.case_balls import balls_of_case, numbers_of_case

PAPER = Case(alpha="0.5", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
LONE = Case(alpha="0.5", eta_b="0.05", eta_m=("70",), positions=("0",))
UNDAMPED = Case(alpha="0.5", eta_b=0, eta_m=("70", "20"), positions=("0", "0.5"))
CENTRE = 0.617  # next to q_lm of these three
FAST = Case(alpha="1.2", eta_b="0.1", eta_m=("20", "5"), positions=("0", "0.5"))
FAST_UNDAMPED = Case(alpha="1.4", eta_b=0, eta_m=("10",), positions=("0",))


def radius(values: Any) -> float:
    return max(float(x.rad()) for x in np.ravel(values))


def hold(enclosed: Any, truth: list[list[Any]]) -> bool:
    """The truth is good to far more digits than the balls' radius; it is taken without a radius."""
    pairs = zip(enclosed.w.ravel(), (x for row in truth for x in row), strict=True)
    return all(ball.contains(x.mid()) for ball, x in pairs)


@pytest.mark.parametrize(
    ("case", "loads", "xi", "centre", "digits"),
    [
        pytest.param(PAPER, [Load(1, "0.3", "0.4", 1), Load("0.5")], (0, -3, 6), CENTRE, 10, marks=pytest.mark.slow),
        (LONE, [Load("0.7", "0.3", "-0.2", 2)], (0, 1), CENTRE, 10),
        # a force beyond the limiting frequency without damping: its pole is on the cut
        pytest.param(UNDAMPED, [Load(1, "0.3", "0.8", 1), Load("0.5")], (0, -1), CENTRE, 10, marks=pytest.mark.slow),
        # joined cuts: the centre is the branch point |q_lm|, and without damping q = 0 lies on the cut
        pytest.param(FAST, [Load(1, "0.3", "0.4", 1), Load("0.5")], (0, -3, 6), 0.300, 8, marks=pytest.mark.slow),
        (FAST_UNDAMPED, [Load("0.7", "0.3", "0.2", 2)], (0, 1), 0.623, 10),
    ],
)
def test_the_balls_hold_the_motion_from_a_second_way_to_twice_the_digits(
    case: Case, loads: list[Load], xi: Any, centre: float, digits: int
) -> None:
    tau = (12, 20)
    enclosed = balls_of_case(case, loads, xi, tau, digits=digits)
    other = Continued(case, loads)
    truth = other.motion(xi, tau, centre, depth=0.4, corner=0.8, height=0.1, end=24, step=0.2, order=24)
    again = other.motion(xi, tau, centre, depth=0.3, corner=0.75, height=0.11, end=23, step=0.2, order=24)
    error = max(float(abs(a - b)) for r, s in zip(truth, again, strict=True) for a, b in zip(r, s, strict=True))
    assert error < 10.0 ** (-2 * digits)
    assert hold(enclosed, truth)
    assert radius(enclosed.w) < 10.0**-digits


@pytest.mark.parametrize("digits", [3, 24])
def test_coarse_and_fine_balls_hold_the_same_motion(digits: int) -> None:
    tau = (5, 20)
    fine = balls_of_case(LONE, tau=tau, digits=15)
    other = balls_of_case(LONE, tau=tau, digits=digits)
    assert all(a.overlaps(b) for a, b in zip(fine.w.ravel(), other.w.ravel(), strict=True))
    assert radius(other.w[:, 1:]) < 10.0**-digits


@pytest.mark.slow
def test_the_balls_of_the_papers_case_are_narrow_and_start_from_rest() -> None:
    enclosed = balls_of_case(PAPER, tau=(0, "0.5", 1, 10, 200))
    assert enclosed.w.shape == enclosed.steady.shape == enclosed.harmonic.shape == enclosed.transient.shape == (2, 5)
    assert radius(enclosed.w[:, 1:]) < 1e-11
    assert radius(enclosed.w[:, 2:]) < 1e-15
    assert radius(enclosed.w[:, 0]) < 2e-9
    assert all(w.contains(0) for w in enclosed.w[:, 0])
    assert all(abs(x) < 1e-9 for x in enclosed.transient[:, 4])  # e^{−η_b τ} = 5e-5, times the cut's own decay
    sizes = [
        min(abs(float(x)) for x in part[:, 0]) for part in (enclosed.steady, enclosed.harmonic, enclosed.transient)
    ]
    assert min(sizes) > 1e-5  # what cancels at the start


THREE = Case(alpha="0.5", eta_b="0.05", eta_m=("40", "10", "40"), positions=("0", "0.5", "1.25"))


@pytest.mark.slow
def test_rows_of_masses_agree_with_float64_to_few_digits() -> None:
    case = Case(alpha="0.5", eta_b="0.2", eta_m=("40", "10", "40"), positions=("0", 1, "2.5"))
    enclosed = balls_of_case(case, tau=6, digits=3)
    found = response(case, tau=6).w
    assert radius(enclosed.w) < 1e-3
    assert all(abs(x - float(ball.mid())) < 1e-3 for x, ball in zip(found.ravel(), enclosed.w.ravel(), strict=True))


@pytest.mark.slow
def test_three_masses_in_balls() -> None:
    loads = [Load(1, "0.3", "0.4", 1), Load("0.5"), Load()]
    enclosed = balls_of_case(THREE, loads, xi=(0, -1), tau=(0, 3, 20), digits=8)
    assert all(w.contains(0) for w in enclosed.w[:, 0])
    assert radius(enclosed.w) < 1e-5
    assert radius(enclosed.w[:, 1:]) < 1e-8
    found = response(THREE, loads, (0, -1), (0, 3, 20)).w
    assert np.max(np.abs(np.vectorize(float)([x.mid() for x in np.ravel(enclosed.w)]) - found.ravel())) < 1e-5


def test_far_positions_and_merged_masses() -> None:
    merged = Case(alpha="0.5", eta_b="0.05", eta_m=("30", "40"), positions=("0", "0"))
    one = balls_of_case(merged, [Load("0.25"), Load("0.75")], (0, 40), (5,), digits=8)
    other = balls_of_case(LONE, None, (0, 40), (5,), digits=8)
    assert all(a.overlaps(b) for a, b in zip(one.w.ravel(), other.w.ravel(), strict=True))
    assert radius(one.w) < 1e-8


@pytest.mark.parametrize(
    ("case", "arguments", "message"),
    [
        (LONE, {"tau": -1}, "before 0"),
        (LONE, {"digits": 0}, "whole number"),
        (LONE, {"loads": [Load(), Load()]}, "one for each"),
        (Case(alpha=Exact.root4(2), eta_b="0.1", eta_m=5), {"tau": 1}, "irrational"),
    ],
)
def test_what_is_not_covered_is_refused(case: Case, arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        balls_of_case(case, **arguments)


def test_spent_effort_is_the_reason_that_is_raised() -> None:
    with pytest.raises(EffortError):
        balls_of_case(LONE, tau=5, effort=Effort(evaluations=50))


def test_a_spectrum_must_be_of_the_case() -> None:
    with pytest.raises(InputError, match="spectrum"):
        balls_of_case(PAPER, tau=5, spectrum=certify(LONE))


def test_waves_that_run_ahead_are_in_the_balls_and_in_float64() -> None:
    """At ξ = 40 the beam moves by 1.5e-7 at τ = 5: short waves, at frequencies far above those of the masses."""
    (ball,) = balls_of_case(LONE, xi=40, tau=5, digits=10).w.ravel()
    assert 1.4877e-7 < float(ball.mid()) < 1.4878e-7
    found = response(LONE, xi=(0, 40), tau=5)
    assert abs(found.w[1, 0] - float(ball.mid())) < 1e-8 * found.w[0, 0]


def test_no_times_or_positions_give_empty_arrays() -> None:
    assert balls_of_case(LONE, tau=()).w.shape == (1, 0)
    assert balls_of_case(LONE, xi=(), tau=1).w.shape == (0, 1)


def test_the_numbers_are_right_to_their_digits() -> None:
    precise = response(LONE, tau=(12, 20), digits=20)
    sharp = response(LONE, tau=(12, 20), digits=40, balls=True)
    assert precise.w.shape == (1, 2)
    for name in ("w", "steady", "harmonic", "transient"):
        for value, ball in zip(getattr(precise, name).ravel(), getattr(sharp, name).ravel(), strict=True):
            with precision(300):
                exact = arb(tuple(map(int, value.man_exp)) if value >= 0 else (-int(value.man), int(value.exp)))
                assert abs(exact - ball) < arb(10) ** -20
    with mpmath.workdps(40):
        total = precise.steady + precise.harmonic + precise.transient - precise.w
        assert all(abs(value) < mpmath.mpf(10) ** -19 for value in total.ravel())


def test_float64_agrees_with_the_balls() -> None:
    tau = (0.5, 3, 40)
    plain, balls = response(LONE, tau=tau), response(LONE, tau=tau, balls=True)
    assert np.allclose(plain.w, balls.w.astype(float), rtol=0, atol=1e-9)


def test_digits_that_the_tail_does_not_allow_are_refused() -> None:
    with pytest.raises(PrecisionError, match=r"at τ = 0.001 the motion is known to .* decays slowly near τ = 0"):
        numbers_of_case(LONE, tau="0.001", digits=20)


@pytest.mark.slow
def test_a_force_next_to_an_induced_frequency() -> None:
    """The steady and the unsteady part grow without bound there, and cancel: the motion itself is smooth in ω."""
    case, tau = Case(alpha="0.5", eta_b=0, eta_m=70), (3, 200)
    (q,) = (root.q.real for root in certify(case, digits=40).roots if root.q.real > 0)
    around = [response(case, [Load(1, 1, float(q) + shift)], tau=tau).w for shift in (-2e-5, 2e-5)]
    for digits in (8, 30, 12):
        near = response(case, [Load(1, 1, q.str(digits, radius=False))], tau=tau, digits=15)
        assert np.allclose(near.w.astype(float), sum(around) / 2, rtol=1e-5, atol=0)  # the curvature of w in ω
        assert abs(float(near.harmonic[0, 1])) > 10.0 ** (digits - 3)
    plain = response(case, [Load(1, 1, q.str(12, radius=False))], tau=tau)
    off = np.abs(plain.w - near.w.astype(float)).max()  # the parts cancel, and the error says so
    assert off < 3 * plain.error * np.abs(plain.harmonic).max()


@pytest.mark.slow
def test_a_growing_motion_gets_the_digits_that_it_needs() -> None:
    fast = Case(alpha="1.2", eta_b="0.05", eta_m=70)
    precise = response(fast, tau=500, digits=15)
    assert abs(precise.w[0, 0]) > 1e12
    sharper = response(fast, tau=500, digits=25, balls=True).w[0, 0]
    with precision(300):
        value = arb(str(precise.w[0, 0]))
        assert abs(value - sharper) < arb(10) ** -1
    plain = response(fast, tau=500).w[0, 0]
    assert plain == pytest.approx(float(precise.w[0, 0]), rel=1e-9)


def test_frequencies_of_few_digits_are_enough_as_circles_go_round_them() -> None:
    given = response(LONE, tau=20, spectrum=certify(LONE, digits=20), digits=25)
    sharp = response(LONE, tau=20, digits=30, balls=True)
    with precision(300):
        for name in ("w", "harmonic"):
            value, ball = getattr(given, name)[0, 0], getattr(sharp, name)[0, 0]
            assert abs(arb(mpmath.nstr(value, 40)) - ball) < arb(10) ** -25


def test_a_force_too_fast_for_the_path_is_refused() -> None:
    with pytest.raises(PrecisionError, match="turns too often"):
        response(LONE, [Load(0, 1, "1e5")], tau=(1, 20), balls=True)


@pytest.mark.parametrize("digits", [0, -2, True, "15", 15.0, 101])
def test_digits_are_a_whole_number(digits: object) -> None:
    with pytest.raises(InputError, match=r"digits: is .* whole number from 1 to 100"):
        response(LONE, tau=12, digits=digits)  # type: ignore[call-overload]
