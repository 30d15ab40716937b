from fractions import Fraction

import numpy as np
import pytest

from mpsolve import tracks
from mpsolve.characteristic.symbol import Symbols
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.problem.reduced import track_guide
from mpsolve.vibration.balls.moving import moving_roots, sharp_roots

TWO = tracks.TwoLayer(EI="6.4e6", m=60, m_sleeper=150, k_pad="1e8", c_pad="5e4", k_ballast="5e7", c_ballast="1e5")
GUIDE = track_guide(TWO, Fraction(60))
SYMBOLS = Symbols.of(GUIDE)


def known(sigma):
    """Roots and N/D_P in float64, from the exact coefficients."""
    D, N = np.zeros(GUIDE.degree + 1, complex), np.zeros(GUIDE.degree + 1, complex)
    for rows, polynomial in ((D, GUIDE.D), (N, GUIDE.N)):
        for (i, j), c in polynomial.items():
            rows[i] += float(c) * sigma**j
    z = np.roots(D[::-1])
    return z, np.polyval(N[::-1], z) / np.polyval(np.polyder(D[::-1]), z)


def test_roots_and_weights_are_held_all_over_the_ball():
    ball = acb(arb(-0.5, 0.1), arb(12, 0.1))
    with precision(100):
        found = moving_roots(SYMBOLS, ball)
        for corner in (-0.59 + 11.91j, -0.41 + 12.09j, -0.5 + 12j):
            z, w = known(corner)
            for one in found:
                at, weight = one.at(acb(corner.real, corner.imag)), one.weight
                k = int(np.argmin(abs(z - complex(at.mid()))))
                assert abs(z[k] - complex(at.mid())) <= 1.5 * float(one.radius) + 1e-9
                assert abs(w[k] - complex(weight.mid())) <= 1.5 * float(weight.rad()) + 1e-9


def test_a_thin_ball_gives_all_digits():
    with precision(300):
        sigma = acb(-1, 40)
        sharp = sharp_roots(SYMBOLS, sigma, moving_roots(SYMBOLS, sigma))
        assert all(one.at(sigma).rel_accuracy_bits() > 250 for one in sharp)


def test_a_wide_ball_is_refused():
    with precision(100), pytest.raises(PrecisionError, match="split"):
        moving_roots(SYMBOLS, acb(arb(0, 5), arb(6, 5)))
