import numpy as np
import pytest

from mpsolve.vibration.case_motion import modulus


def test_the_modulus_bounds_the_sum_of_waves():
    tau = np.linspace(0, 50, 501)
    pairs = [(0.3 + 0.01j, np.array([1 - 2j])), (0.5 + 0j, np.array([0.5j]))]
    wave = sum((a[0] * np.exp(1j * q * tau)).real for q, a in pairs)
    assert np.all(np.abs(wave) <= modulus(pairs, tau)[0] + 1e-12)
    assert modulus(pairs[1:], tau)[0] == pytest.approx(0.5)
