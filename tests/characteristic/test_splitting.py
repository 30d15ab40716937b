"""The two monic factors: their derivative, their Newton step, and the proved number of upper roots."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from multiprecision import Multiprecision
from residue import Residues, random_track

from mpsolve.characteristic.splitting import factor_balls, monic, sharpened, sides, sylvester, upper_count
from mpsolve.characteristic.symbol import Symbol, Symbols, product
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision, square
from mpsolve.numbers.float64 import Float64
from mpsolve.problem.reduced import track_guide

UPPER, LOWER = [-1 + 2j, -0.5 - 1j], [2 + 0j, 1 - 1j, 0.25 + 1j]


def test_monic_is_the_product() -> None:
    assert np.allclose([*monic(UPPER), 1][::-1], np.poly(UPPER))
    assert monic([]) == ()


def test_sylvester_is_the_derivative_of_the_product() -> None:
    U, L = list(monic(UPPER)), list(monic(LOWER))
    step = np.array([0.3, -1j, 0.2, 1, 2j]) * 1e-6
    moved = np.array([*U, *L]) + step
    change = np.array(product([*moved[:2], 1], [*moved[2:], 1])) - np.array(product([*U, 1], [*L, 1]))
    assert np.allclose(np.array(sylvester(U, L)) @ step, change[:-1], rtol=0, atol=1e-11)
    assert change[-1] == 0


@pytest.mark.parametrize("K", [Float64(), Multiprecision(30)])
def test_a_newton_step_squares_the_error(K: Float64 | Multiprecision) -> None:
    """Also with an upper root that is double."""
    for upper in (UPPER, [-1 + 0.5j, -1 + 0.5j]):
        U, L = list(monic(upper)), list(monic(LOWER))
        D = [3 * c for c in product([*U, 1], [*L, 1])]
        found = sharpened(K, D, [c + 1e-5 for c in U], [c - 1e-5j for c in L])
        for part, exact in zip(found, (U, L), strict=True):
            assert max(abs(complex(a) - complex(b)) for a, b in zip(part, exact, strict=True)) < 1e-9


@pytest.mark.parametrize("seed", range(6))
def test_upper_roots_are_counted_wherever_growth_is(seed: int) -> None:
    """The number of roots with Re P < 0 is the same at every σ with Re σ > 0."""
    guide = track_guide(random_track(1 + seed % 3, seed), Fraction(seed, 3))
    truth = Residues(guide, 30)
    count = upper_count(Symbols.of(guide).D)
    for s in (1.5, 0.125 + 1j, 0.25 - 2j, 1e-3 + 0.5j):
        assert sum(1 for z in truth.roots(s) if z.real < 0) == count


def test_real_roots_everywhere_are_not_counted() -> None:
    """P² + 1: a wave for every σ."""
    with pytest.raises(PrecisionError, match="told apart"):
        upper_count(Symbol.of({(2, 0): Fraction(1), (0, 0): Fraction(1)}))


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
