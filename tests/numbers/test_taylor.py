"""Taylor coefficients hold the true ones."""

from __future__ import annotations

from flint import acb, arb

from mpsolve.numbers.balls import precision
from mpsolve.numbers.taylor import taylor


def test_taylor_coefficients_hold_the_true_ones() -> None:
    """1/(2 − z) = Σ z^k/2^{k+1}; the bound of 1 holds on |z| ≤ 1."""
    with precision(200):
        found = taylor(lambda z: 1 / (2 - z), acb(0), arb(1), arb(1), 8)
        for k, coefficient in enumerate(found.coefficients):
            assert coefficient.contains(acb(arb(2) ** (-k - 1)))
            assert (coefficient - coefficient.mid()).abs_upper() < arb(2) ** (8 * k - 100)
