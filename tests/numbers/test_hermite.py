import numpy as np
import pytest

from mpsolve.numbers.hermite import hermite


def test_cubics_are_kept_as_they_are():
    nodes, times = np.array([0.0, 0.5, 2.0]), np.linspace(0, 2, 9)
    cubic, slope = (lambda t: t**3 - 2 * t + 1), (lambda t: 3 * t**2 - 2)
    assert hermite(nodes, cubic(nodes)[None], slope(nodes)[None], times)[0] == pytest.approx(cubic(times), abs=1e-14)
