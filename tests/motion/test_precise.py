"""`response` in mpmath numbers and in balls: the numbers lie in balls of twice the digits, or are refused."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from flint import arb

from mpsolve import Case, response
from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic

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
    assert np.allclose(plain.w, balls.w.astype(float), rtol=0, atol=1e-12)


def test_digits_that_the_tail_does_not_allow_are_refused() -> None:
    with pytest.raises(PrecisionError, match="at τ = 0 the motion is known to"):
        response(LONE, tau=(0, 10), digits=20)
