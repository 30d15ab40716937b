"""The curve q(κ) comes back to itself, and each of its points is a root by the sum over the row."""

from __future__ import annotations

import numpy as np
from endless_rows import brute_sum, masses

from mpsolve.endless.bloch import Bloch
from mpsolve.endless.curve import around
from mpsolve.endless.growing import find_growing


def test_it_closes_and_crosses_the_real_axis() -> None:
    row = masses("0.4")
    seed = find_growing(row, 1.0)
    assert seed is not None
    theta, sigma = around(Bloch(row), seed.theta, 1j * complex(seed.q), 100)
    assert abs(sigma[-1] - sigma[0]) < 1e-12
    assert sigma.real.max() > 0.0018
    assert sigma.real.min() < -0.005
    k = int(np.argmin(np.abs(sigma - (0.0015 + 0.26j))))
    G = complex(row.reduced.guide.g) * brute_sum(row, row.step * 0, np.exp(1j * theta[k]), sigma[k], 600)
    assert abs(1 + 40 * sigma[k] ** 2 * G) < 1e-4
