"""Taylor coefficients hold the true ones."""

from __future__ import annotations

import pytest
from flint import acb, arb

from mpsolve.numbers.balls import precision
from mpsolve.numbers.taylor import SAMPLES, Taylor, pellet, taylor


def test_taylor_coefficients_hold_the_true_ones() -> None:
    """1/(2 − z) = Σ z^k/2^{k+1}; the bound of 1 holds on |z| ≤ 1."""
    with precision(200):
        found = taylor(lambda z: 1 / (2 - z), acb(0), arb(1), arb(1), 8)
        for k, coefficient in enumerate(found.coefficients):
            assert coefficient.contains(acb(arb(2) ** (-k - 1)))
            assert (coefficient - coefficient.mid()).abs_upper() < arb(2) ** (8 * k - 100)


def series(*coefficients: complex, error: float = 0) -> Taylor:
    """A polynomial about 0, as if it were known for |z| < 1 with a bound of 20."""
    padded = [*coefficients, *[0] * (SAMPLES - len(coefficients))]
    wide = acb(arb(0, error), arb(0, error))
    return Taylor(acb(0), tuple(acb(a) + wide for a in padded), arb(20), arb(1))


# (z − 0.001)(z + 0.001)(z − 3), (z − 0.001i)³ (z − 2), z² + 1e-9
TOYS = [((3e-6, -1e-6, -3, 1), 2), ((-2j * 1e-9, 6e-6 + 1e-9j, 6e-3j - 3e-6, -2 - 3e-3j, 1), 3), ((1e-9, 0, 1), 2)]


@pytest.mark.parametrize(("coefficients", "roots"), TOYS)
def test_pellet_counts_the_roots_of_a_disc(coefficients: tuple[complex, ...], roots: int) -> None:
    with precision(100):
        for radius in (0.01, 0.03, 0.1):
            assert [m for m in range(6) if pellet(series(*coefficients), m, arb(radius))] == [roots]


def test_pellet_stays_silent_near_a_root() -> None:
    with precision(100):
        near = series(3e-6, -1e-6, -3, 1)
        assert not any(pellet(near, m, arb(0.001)) for m in range(6))
        assert not any(pellet(near, m, arb(3)) for m in range(6)), "beyond the disc in which the series is known"
        assert not any(pellet(series(3e-6, -1e-6, -3, 1, error=1), m, arb(0.01)) for m in range(6))
