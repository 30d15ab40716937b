"""The faded integral along a line, against an inverse that is known."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve.vibration.integral import CLEAR, extended, faded, sampled_line
from mpsolve.vibration.path import Path


def _image(sigma: np.ndarray) -> np.ndarray:
    """σ^{−3/2}·… has a corner at t = 0: 1/((σ + 1)^{5/2}), whose inverse is t^{3/2} e^{−t} 4/(3√π)."""
    return np.stack([(sigma + 1) ** -2.5, (sigma + 1) ** -1.5], 1)


def _known(t: np.ndarray) -> np.ndarray:
    return np.stack([4 * t**1.5, 6 * t**0.5]) * np.exp(-t) / (3 * np.sqrt(np.pi))


@pytest.mark.parametrize("omega", [80.0, 1000.0])
def test_clear_of_the_start_the_fading_is_not_felt(omega: float) -> None:
    line = sampled_line(_image, Path(0.05), omega)
    times = np.array([1.0, 1.5, 3.0]) * CLEAR / omega
    off = np.abs(line.motion(times) - _known(times)).max()
    assert off < 1e-9
    assert line.settled


def test_the_change_from_half_of_it_tells_where_it_is_felt() -> None:
    line = sampled_line(_image, Path(0.05), 160.0)
    times = np.array([0.02, 0.1, 0.4])
    off, change = np.abs(line.motion(times) - _known(times)), np.abs(line.change(times))
    assert (off <= 2.5 * change + 1e-10).all()
    assert (change[:, 0] > 1e-6).all()
    before = line.motion(np.array([-0.6]))
    assert np.abs(before).max() < 1e-9


def test_an_extended_line_is_one_that_was_sampled_so_far() -> None:
    times = np.array([0.05, 1.0])
    one, other = extended(_image, sampled_line(_image, Path(0.05), 80.0)), sampled_line(_image, Path(0.05), 160.0)
    assert one.omega == other.omega == 160
    assert one.motion(times) == pytest.approx(other.motion(times), abs=1e-10)
    assert one.only([1]).motion(times) == pytest.approx(one.motion(times)[1:])


def test_the_fading() -> None:
    assert faded(np.array([0.0, 20.0, 50.0, 80.0, 100.0]), 100.0) == pytest.approx([1, 1, 0.5, 0, 0], abs=1e-3)
    assert 1 - faded(0.0, 1.0) < 1e-9 > faded(1.0, 1.0)
