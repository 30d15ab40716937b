"""The precision holds in a block and comes back, other threads wait; balls of rationals and polynomials hold them."""

from __future__ import annotations

import threading
from fractions import Fraction

import flint
import pytest

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import (
    Balls,
    acb,
    arb,
    bits_now,
    exact_ball,
    greatest,
    least,
    precision,
    rational_ball,
    square,
)  # fmt: skip


def test_precision_is_put_back() -> None:
    before = flint.ctx.prec
    with precision(200):
        assert bits_now() == 200
        with pytest.raises(ZeroDivisionError), precision(300):
            raise ZeroDivisionError
        assert bits_now() == 200
    assert bits_now() == before


def test_another_thread_waits() -> None:
    seen, asking = [], threading.Event()

    def work() -> None:
        asking.set()
        with precision(900):
            seen.append(flint.ctx.prec)

    thread = threading.Thread(target=work)
    with precision(70):
        thread.start()
        assert asking.wait(10)
        thread.join(0.2)
        assert (flint.ctx.prec, seen, thread.is_alive()) == (70, [], True)
    thread.join(10)
    assert seen == [900]


def test_a_rational_is_held_at_every_precision() -> None:
    K, third = Balls(), Fraction(1, 3)
    for bits in (30, 300):
        with precision(bits):
            assert K.number(third).contains(flint.fmpq(1, 3))
            assert rational_ball(third).rel_accuracy_bits() >= bits - 3
            assert K.number(third).rel_accuracy_bits() >= bits - 3


def test_squares_and_floats() -> None:
    assert square(arb(2)).contains(acb(2, -2))
    assert not square(arb(2)).contains(acb(2.1, 0))
    assert exact_ball(0.1 + 1e300j) == acb(0.1, 1e300)
    assert exact_ball(0.1 + 0j).real.is_exact()


def test_a_polynomial_on_a_wide_ball_costs_its_own_width() -> None:
    """About the middle (z − 2)² has no spurious width: naive evaluation gives 4 and more times the radius."""
    K, half = Balls(), 0.01
    with precision(64):
        found = K.evaluate((Fraction(4), Fraction(-4), Fraction(1)), acb(2) + square(half))
        assert found.contains(acb(half * half * 0.99, 0))
        assert float(found.abs_upper()) < 4 * half * half
        assert K.evaluate((Fraction(4), Fraction(-4), Fraction(1)), acb(3)) == 1


def test_a_matrix_that_may_be_singular() -> None:
    K = Balls()
    wide = K.matrix([[acb(arb(0, 1))]])
    with pytest.raises(PrecisionError, match="singular"):
        K.solve(wide, K.matrix([[acb(1)]]))


def test_the_least_and_the_greatest_hold_what_floats_do_not_tell_apart() -> None:
    with precision(128):
        close = [arb(1), arb(1) + arb(2) ** -60, arb(1) - arb(2) ** -60, arb(1, 2.0**-70)]
        assert least(close) == close[2]
        assert greatest(close) == close[1]
        assert least([arb(0, 1), arb(2)]).contains(arb(-1))
