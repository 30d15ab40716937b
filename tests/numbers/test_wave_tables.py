import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import grid

from mpsolve.numbers.wave_tables import Waves, gauss, moments, nested_moments, wave_tables


def test_a_wave_decays_over_a_step_as_it_must():
    waves = Waves(np.array([1.3]), np.array([-0.2 + 3j]), np.array([1.0 + 0j]), 10.0, 2.0)
    assert wave_tables(waves, np.array([0.0]), 0.1).decay.ravel() == pytest.approx(np.exp(0.1 * (-0.2 + 3j)))


def test_moments_are_what_quadrature_has():
    nodes, weights = gauss(40)
    for z in (0.0, 0.3 - 2j, -5 + 1j):
        known = [(weights * np.exp(z * nodes) * nodes**k).sum() for k in range(3)]
        assert moments(np.array([z]), 2).ravel() == pytest.approx(known, rel=1e-10)


def test_nested_moments_by_quadrature():
    nodes, weights = gauss(40)
    p, q = -0.4 + 1j, 0.2 - 3j
    inner = [(weights * t * np.exp(q * nodes * t)).sum() for t in nodes]
    known = (weights * np.exp(p * nodes) * inner).sum()
    assert nested_moments(np.array([p]), np.array([q]))[0, 0, 0] == pytest.approx(known, rel=1e-10)


@settings(max_examples=40)
@given(
    size=st.floats(1e-3, 60), turn=grid(0.25, 0.75), other=grid(-40, 40), a=st.integers(0, 1), power=st.integers(0, 1)
)
def test_integrals_agree_with_quadrature(size: float, turn: float, other: float, a: int, power: int) -> None:
    q, p = size * np.exp(2j * np.pi * turn), 1j * other - 0.1
    theta, weight = gauss(150)
    single = weight @ (theta**power * np.exp(q * theta))
    assert abs(moments(np.array([q]), power)[power, 0] - single) < 1e-12
    sigma = np.multiply.outer(theta, theta)
    inner = theta * (sigma**power * np.exp(q * sigma) @ weight)
    double = weight @ (theta**a * np.exp(p * theta) * inner)
    assert abs(nested_moments(np.array([p]), np.array([q]))[a, power, 0] - double) < 1e-12
