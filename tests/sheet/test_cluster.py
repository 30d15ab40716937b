"""Multiple and nearly multiple roots: Pellet's test on known functions, and two masses far apart."""

from __future__ import annotations

import math

import flint
import pytest
from oracle import Truth, holds

from mpsolve import Case
from mpsolve.fields import ball_arithmetic
from mpsolve.sheet.cluster import SAMPLES, Taylor, pellet, separate, taylor

acb, arb = flint.acb, flint.arb


def series(*coefficients: complex, error: float = 0) -> Taylor:
    """A polynomial about 0, as if it were known for |z| < 1 with a bound of 20."""
    padded = [*coefficients, *[0] * (SAMPLES - len(coefficients))]
    wide = acb(arb(0, error), arb(0, error))
    return Taylor(acb(0), tuple(acb(a) + wide for a in padded), arb(20), arb(1))


# (z − 0.001)(z + 0.001)(z − 3), (z − 0.001i)³ (z − 2), z² + 1e-9
TOYS = [((3e-6, -1e-6, -3, 1), 2), ((-2j * 1e-9, 6e-6 + 1e-9j, 6e-3j - 3e-6, -2 - 3e-3j, 1), 3), ((1e-9, 0, 1), 2)]


@pytest.mark.parametrize(("coefficients", "roots"), TOYS)
def test_pellet_counts_the_roots_of_a_disc(coefficients: tuple[complex, ...], roots: int) -> None:
    with ball_arithmetic(100):
        for radius in (0.01, 0.03, 0.1):
            assert [m for m in range(6) if pellet(series(*coefficients), m, arb(radius))] == [roots]


def test_pellet_stays_silent_near_a_root() -> None:
    with ball_arithmetic(100):
        near = series(3e-6, -1e-6, -3, 1)
        assert not any(pellet(near, m, arb(0.001)) for m in range(6))
        assert not any(pellet(near, m, arb(3)) for m in range(6)), "beyond the disc in which the series is known"
        assert not any(pellet(series(3e-6, -1e-6, -3, 1, error=1), m, arb(0.01)) for m in range(6))


def test_taylor_coefficients_hold_the_true_ones() -> None:
    """1/(2 − z) = Σ z^k/2^{k+1}; the bound of 1 holds on |z| ≤ 1."""
    with ball_arithmetic(200):
        found = taylor(lambda z: 1 / (2 - z), acb(0), arb(1), arb(1), 8)
        for k, coefficient in enumerate(found.coefficients):
            assert coefficient.contains(acb(arb(2) ** (-k - 1)))
            assert (coefficient - coefficient.mid()).abs_upper() < arb(2) ** (8 * k - 100)


@pytest.mark.parametrize("d", [20, 40, 60, 100])
@pytest.mark.parametrize("digits", [15, 30])
def test_two_far_masses_have_a_close_pair_of_roots(d: int, digits: int) -> None:
    """Each near the single mass's root; they come apart like e^{−cd} until the digits cannot tell them."""
    case = Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, d))
    single = Truth(Case(alpha="0.5", eta_b="0.05", eta_m=70), 60).root(0.1548 + 0.0016j)
    balls = separate(case, complex(single), digits)
    assert sum(ball.multiplicity for ball in balls) == 2
    assert len(balls) == 2 or holds(balls[0].q, single)
    for k, ball in enumerate(balls):
        assert (ball.q - ball.q.mid()).abs_upper() <= 10.0**-digits * ball.q.abs_upper()
        assert abs(complex(ball.q.mid()) - complex(single)) < 1e-3
        assert not any(ball.q.overlaps(other.q) for other in balls[:k])


def test_separated_roots_hold_the_true_ones() -> None:
    case = Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, 40))
    truth = Truth(case, 80)
    balls = separate(case, 0.15484109 + 0.0016363620j, 30)
    assert len(balls) == 2
    for ball in balls:
        assert holds(ball.q, truth.root(truth.middle(ball.q), 1e-25))


def test_a_simple_root_is_no_cluster() -> None:
    case = Case(alpha="0.5", eta_b="0.05", eta_m=70)
    (ball,) = separate(case, 0.15484109 + 0.0016363620j, 20)
    assert ball.multiplicity == 1
    assert math.isclose(float(ball.q.real.mid()), 0.1548411, rel_tol=1e-6)


def test_nothing_is_found_where_there_is_no_root() -> None:
    assert separate(Case(alpha="0.5", eta_b="0.05", eta_m=70), 0.4 - 0.2j, 15) == []
