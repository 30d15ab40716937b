"""The faded integral along a line, against an inverse that is known."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from mpsolve.vibration.integral import (
    CLEAR,
    ORDER,
    extended,
    faded,
    inverse,
    joined,
    sampled,
    sampled_line,
    spherical,
)
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


@pytest.mark.parametrize("z", [0.0, 0.3, 2.4, 2.6, 9.9, 10.1, 29.0, 31.0, 400.0])
def test_moments_are_integrals_of_legendre_polynomials(z: float) -> None:
    found = spherical(np.array([z]))[0]
    for n in (0, 1, 7, ORDER - 1):
        truth = (
            2
            * mpmath.mpc(0, 1) ** n
            * (mpmath.sqrt(mpmath.pi / (2 * z)) * mpmath.besselj(n + 0.5, z) if z else n == 0)
        )
        assert found[n] == pytest.approx(complex(truth), abs=2e-13)


def _known_panels(sigma: np.ndarray) -> np.ndarray:
    """1/(σ + 1)³ and 1/((σ + 0.01)² + 9)²: their inverses are t²e^{−t}/2 and (sin 3t − 3t cos 3t) e^{−0.01t}/54."""
    return np.stack([1 / (sigma + 1) ** 3, 1 / ((sigma + 0.01) ** 2 + 9) ** 2], 1)


@pytest.mark.parametrize("alpha", [0.5, 0.003, -0.003])
def test_the_inverse_of_known_functions(alpha: float) -> None:
    """Next to a pole at the distance 0.007 too, and at times up to 1,000."""
    breaks = np.concatenate([[0.0], 2.0 ** np.arange(-4, 18)])
    panels, left_open, settled = sampled(
        lambda w: _known_panels(alpha + 1j * w), breaks, lambda size: 1e-12 * size, 4000
    )
    assert settled
    assert (left_open < 1e-9 * panels.integral()).all()
    assert len(panels.middle) < 120
    times = np.array([0.01, 1.0, 7.0, 50.0, *([1000.0] if alpha < 0.1 else [])])
    found = inverse(panels, np.ones_like, alpha, times)
    wave = (np.sin(3 * times) - 3 * times * np.cos(3 * times)) * np.exp(-0.01 * times) / 54
    assert found[0] == pytest.approx(times**2 * np.exp(-times) / 2, abs=1e-10 * np.exp(max(alpha, 0) * times[-1]))
    assert found[1] == pytest.approx(wave, abs=1e-9 * np.exp(max(alpha, 0) * times[-1]))


def test_what_the_work_does_not_reach_is_said() -> None:
    panels, left_open, settled = sampled(
        lambda w: _known_panels(-0.00999 + 1j * w), [0.0, 8.0], lambda size: 1e-14 * size, 6
    )
    assert not settled
    assert (left_open > 1e-9 * panels.integral()).any()
    assert np.sum(2 * panels.half) == pytest.approx(8)


def test_no_panel_is_wider_than_allowed_and_parts_join() -> None:
    one, _, _ = sampled(lambda w: _known_panels(1 + 1j * w), [0.0, 1.0], lambda size: size, 100, widest=0.3)
    assert one.half.tolist() == [0.125] * 4
    assert len(joined([one, one]).middle) == 8
