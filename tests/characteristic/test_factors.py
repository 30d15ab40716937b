"""U and L in balls: they hold the exact factors, also of double roots, and say which side their roots are on."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mpsolve.characteristic.factors import factor_balls, sides
from mpsolve.characteristic.splitting import monic
from mpsolve.characteristic.symbol import Symbol
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision, square

DOUBLE = Symbol.of({(4, 0): Fraction(3), (2, 0): Fraction(-12), (0, 0): Fraction(12), (0, 1): Fraction(3)})
"""3 ((P² − 2)² + σ): at σ = 0 ∓√2 are double."""
NEAR = np.array([-1.4, -1.43, 1.41, 1.42])


def test_a_double_root_in_each_factor() -> None:
    for bits in (64, 300):
        with precision(bits):
            U, L = factor_balls(DOUBLE, acb(0), NEAR, 2)
            root = arb(2).sqrt()
            for part, exact in ((U, (acb(2), 2 * root)), (L, (acb(2), -2 * root))):
                assert all(
                    ball.contains(acb(x)) or ball.overlaps(acb(x)) for ball, x in zip(part, exact, strict=True)
                )
                assert all(float(ball.rad()) < 2.0 ** (20 - bits) for ball in part)
            assert sides((U, L), NEAR, 2)


@pytest.mark.parametrize("half", [1e-9, 1e-3, 1e-1])
def test_a_wide_ball_holds_all_factors(half: float) -> None:
    with precision(64):
        U, L = factor_balls(DOUBLE, acb(0) + square(half), NEAR, 2)
        signed = sides((U, L), NEAR, 2)
    assert signed
    for turn in (0, 1, -1, 1j, 1 + 1j):
        roots = np.sort_complex(np.roots([3, 0, -12, 0, 12 + 3 * half * 0.999 * turn]))
        for part, exact in ((U, monic(roots[:2])), (L, monic(roots[2:]))):
            for ball, x in zip(part, exact, strict=True):
                spread = square(1e-7 if turn == 0 else 1e-12)  # numpy's double roots are good to 1e-8
                assert (acb(complex(x)) + spread).overlaps(ball)
                assert float(ball.rad()) < 3 * half + 1e-12


def test_the_pair_that_is_asked_for() -> None:
    """Any split: here the roots of U are on both sides, and that is told."""
    symbol = Symbol.of({(2, 0): Fraction(1), (1, 0): Fraction(0), (0, 0): Fraction(-4)})
    with precision(64):
        factors: Any = factor_balls(symbol, acb(0.5), np.array([2.0, -2.0]), 1)
        assert factors[0][0].contains(-2)
        assert not sides(factors, np.array([2.0, -2.0]), 1)
        assert sides(factor_balls(symbol, acb(0.5), np.array([-2.0, 2.0]), 1), np.array([-2.0, 2.0]), 1)


def test_nodes_do_not_say_where_the_roots_are() -> None:
    """U = P − 2 has its root on the right, however far left its node is; L = (P − 2)² likewise."""
    with precision(64):
        assert not sides(((acb(-2),), ()), np.array([-1.0]), 1)
        assert sides(((acb(2),), ()), np.array([-1.5]), 1)
        assert not sides(((), (acb(4), acb(4))), np.array([2.0, 2.0]), 0)
        assert sides(((), (acb(4), acb(-4))), np.array([2.0, 2.0]), 0)


def test_all_roots_on_one_side() -> None:
    symbol = Symbol.of({(2, 0): Fraction(1), (1, 0): Fraction(3), (0, 0): Fraction(2)})
    with precision(64):
        U, L = factor_balls(symbol, acb(0.5), np.array([-2.0, -1.0]), 2)
    assert L == ()
    assert U[0].contains(2)
    assert U[1].contains(3)


def test_what_it_refuses() -> None:
    with precision(64):
        with pytest.raises(PrecisionError, match="split the piece"):
            factor_balls(DOUBLE, acb(0) + square(3), NEAR, 2)
        with pytest.raises(PrecisionError, match=r"too close|cannot be proved"):
            factor_balls(DOUBLE, acb(0), np.array([-1.41, 1.41, -1.42, 1.42]), 2)
