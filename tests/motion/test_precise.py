"""`response` in mpmath numbers and in balls: the numbers lie in balls of twice the digits, or are refused."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from flint import arb

from mpsolve import Case, certify, response
from mpsolve.errors import InputError, PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.vehicles.load import Load

LONE = Case(alpha="0.5", eta_b="0.05", eta_m=70)


def test_the_numbers_are_right_to_their_digits() -> None:
    precise = response(LONE, tau=(12, 20), digits=20)
    sharp = response(LONE, tau=(12, 20), digits=40, balls=True)
    assert precise.w.shape == (1, 2)
    for name in ("w", "steady", "harmonic", "transient"):
        for value, ball in zip(getattr(precise, name).ravel(), getattr(sharp, name).ravel(), strict=True):
            with ball_arithmetic(300):
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
    with pytest.raises(PrecisionError, match=r"at τ = 0 the motion is known to .* decays slowly near τ = 0"):
        response(LONE, tau=(0, 10), digits=20)


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


def test_a_growing_motion_gets_the_digits_that_it_needs() -> None:
    fast = Case(alpha="1.2", eta_b="0.05", eta_m=70)
    precise = response(fast, tau=500, digits=15)
    assert abs(precise.w[0, 0]) > 1e12
    sharper = response(fast, tau=500, digits=25, balls=True).w[0, 0]
    with ball_arithmetic(300):
        value = arb(str(precise.w[0, 0]))
        assert abs(value - sharper) < arb(10) ** -1
    plain = response(fast, tau=500).w[0, 0]
    assert plain == pytest.approx(float(precise.w[0, 0]), rel=1e-9)


def test_frequencies_given_with_too_few_digits_are_the_reason_that_is_said() -> None:
    with pytest.raises(PrecisionError, match="leave `spectrum` out"):
        response(LONE, tau=50, spectrum=certify(LONE, digits=20), digits=30)


def test_a_force_too_fast_for_the_path_is_refused() -> None:
    with pytest.raises(InputError, match="loads: a force changes too fast"):
        response(LONE, [Load(0, 1, "1e5")], tau=(1, 20), balls=True)


@pytest.mark.parametrize("digits", [0, -2, True, "15", 15.0, 101])
def test_digits_are_a_whole_number(digits: object) -> None:
    with pytest.raises(InputError, match=r"digits: is .* whole number from 1 to 100"):
        response(LONE, tau=12, digits=digits)  # type: ignore[call-overload]
