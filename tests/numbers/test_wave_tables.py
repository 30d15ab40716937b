import numpy as np
import pytest

from mpsolve.numbers.wave_tables import Waves, wave_tables


def test_a_wave_decays_over_a_step_as_it_must():
    waves = Waves(np.array([1.3]), np.array([-0.2 + 3j]), np.array([1.0 + 0j]), 10.0, 2.0)
    assert wave_tables(waves, np.array([0.0]), 0.1, 1, 1).decay.ravel() == pytest.approx(np.exp(0.1 * (-0.2 + 3j)))
