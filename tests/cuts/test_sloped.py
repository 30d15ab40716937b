"""Balls with slopes, and (eʷ − 1)/w, against integrals and differences."""

import numpy as np
import pytest

from mpsolve.cuts.sloped import Sloped, quotient
from mpsolve.numbers.balls import acb, precision


@pytest.mark.parametrize("w", [0, 1e-3, 0.4 + 0.1j, 0.5j, 3 - 2j, -30 + 1j])
def test_the_quotient_is_an_integral(w: complex) -> None:
    """E(w) = ∫ e^{tw} dt and E′(w) = ∫ t e^{tw} dt by Simpson's rule."""
    t = np.linspace(0, 1, 4001)
    weights = np.where(np.arange(4001) % 2, 4, 2) / 12000
    weights[[0, -1]] /= 2
    with precision(80):
        value, rate = quotient(acb(complex(w).real, complex(w).imag))
        for ball, power in ((value, 0), (rate, 1)):
            assert abs(complex(ball.mid()) - np.sum(weights * t**power * np.exp(t * w))) < 1e-9
            assert float(ball.real.rad()) < 1e-20


def test_slopes_are_those_of_differences() -> None:
    def f(x: float) -> Sloped:
        one = Sloped(acb(x, 0.25), (acb(1),))
        return (one * one + -one.exp()).inverse() * one.times(2j).quotient()

    with precision(120):
        step = 2.0**-30
        truth = (f(0.5 + step).value - f(0.5 - step).value) / (2 * step)
        assert abs(complex(f(0.5).slopes[0].mid()) - complex(truth.mid())) < 1e-14
