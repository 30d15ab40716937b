"""A string at rest is one exponential, which the field knows in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import receptance
from mpsolve.tracks import String


def test_the_receptance_is_one_exponential() -> None:
    """G(ξ, ω) = e^(−κ|ξ|)/(2 T κ) with T κ² = k + iωc − mω², Re κ > 0."""
    wire = String(T=27000, m="1.07", k=500, c=2)
    places, omega = np.array([-3.0, 0.0, 2.5]), np.array([1.0, 15.0, 40.0])
    kappa = np.sqrt((500 + 2j * omega - 1.07 * omega**2) / 27000)
    truth = np.exp(-kappa * abs(places)[:, None]) / (2 * 27000 * kappa)
    assert receptance(wire, xi=places, omega=omega, v=0) == pytest.approx(truth, rel=1e-12)
