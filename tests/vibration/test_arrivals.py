import numpy as np
import pytest

from mpsolve.vibration.arrivals import reach_of_waves
from mpsolve.vibration.path import Path

FIRST = 40.0


def reach(wave, size, time):
    """Next to a large channel at the contact one that is FIRST away."""

    def image(sigma):
        return np.stack([1 / sigma, size / sigma], 1)

    return reach_of_waves(image, wave, [[0.0], [FIRST]], Path(0.0), np.array([time]), 1e-9)


def bending(sigma):
    """P = 2√(iσ), so that d = 40/√ω."""
    return np.stack([-2 * np.sqrt(1j * sigma), -2 * np.sqrt(sigma / 1j)], 1)


def test_short_waves_that_run_ahead_are_followed_as_far_as_they_are_felt():
    early, late = reach(bending, 1.0, 4.0), reach(bending, 1.0, 8.0)
    assert early == pytest.approx(4 * late, rel=0.5)  # ω = (40/t)²
    assert early > 2 * (FIRST / 4.0) ** 2
    assert reach(bending, 1e-12, 4.0) == 0


def test_waves_of_one_velocity_have_a_front_and_need_no_more():
    assert reach(lambda sigma: np.stack([-sigma / 8, sigma / 8], 1), 1.0, 5.0) == 0
