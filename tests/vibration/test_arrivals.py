import numpy as np
import pytest

from mpsolve.vibration.arrivals import reach_of_waves


def wave(delay, size):
    """A channel next to a large one that does not travel; delay: of ω, integrated."""
    return lambda sigma: np.stack([1 / sigma, size(sigma) * np.exp(-1j * delay(sigma.imag))], 1)


def test_short_waves_that_run_ahead_are_followed_as_far_as_they_are_felt():
    bending = lambda w: 2 * 40 * np.sqrt(w)  # d(ω) = 40/√ω  # noqa: E731
    image = wave(bending, lambda s: 1 / s)
    reach = [reach_of_waves(image, 0.0, np.array([t]), 1e-9, [slice(0, 2)]) for t in (4.0, 8.0)]
    assert reach[0] == pytest.approx(4 * reach[1], rel=0.5)  # ω = (40/t)²
    assert reach[0] > 2 * (40 / 4.0) ** 2
    faint = wave(bending, lambda s: 1e-12 / s)
    assert reach_of_waves(faint, 0.0, np.array([4.0]), 1e-9, [slice(0, 2)]) == 0


def test_waves_of_one_velocity_have_a_front_and_need_no_more():
    image = wave(lambda w: 5 * w, lambda s: 1 / s)
    assert reach_of_waves(image, 0.0, np.array([5.0]), 1e-9, [slice(0, 2)]) == 0
