"""Winkler's beam at rest, and the first critical velocity of its moving load."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import critical_velocities, receptance
from mpsolve.tracks import EulerBernoulli


def test_the_static_deflection_is_winklers() -> None:
    """w(ξ) = β/(2k) e^(−β|ξ|)(cos βξ + sin β|ξ|) with β⁴ = k/(4 EI)."""
    track = EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
    beta, x = (1e6 / (4 * 6.4e6)) ** 0.25, np.array([-4.0, 0.0, 1.0, 7.0])
    truth = beta / 2e6 * np.exp(-beta * abs(x)) * (np.cos(beta * x) + np.sin(beta * abs(x)))
    assert receptance(track, xi=x, omega=[0], v=0)[:, 0] == pytest.approx(truth, rel=1e-12)


def test_damping_of_the_rail_is_a_complex_stiffness() -> None:
    """At ω the factor 1 + iηω: the entry P⁴ s is EI η."""
    (entry,) = EulerBernoulli(EI=4, m=1, eta="0.5").waveguide.matrix[0]
    assert entry == {(4, 0): 4, (4, 1): 2, (0, 2): 1}


def test_the_critical_velocity() -> None:
    """v⁴ = 4 k EI/m²; the Pasternak shear modulus adds kp/m to v²."""
    plain = critical_velocities(EulerBernoulli(EI="1/4", m=1, k=1), omega=0, over={"v": (0, 2)})
    assert [float(x.value) for x in plain.velocities] == pytest.approx([1])
    sheared = critical_velocities(EulerBernoulli(EI="1/4", m=1, k=1, kp=Fraction(1, 2)), omega=0, over={"v": (0, 2)})
    assert [float(x.value) for x in sheared.velocities] == pytest.approx([1.5**0.5])
