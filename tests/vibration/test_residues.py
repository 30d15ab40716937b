"""Residues of functions that are known: simple, double, and nearly double ones."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest

from mpsolve.vibration.residues import Mode, Pole, clustered, modes


def _image(a: complex, b: complex) -> object:
    """1/((σ − a)(σ − ā)(σ − b)(σ − b̄)), in a second channel times σ."""

    def image(sigma: np.ndarray) -> np.ndarray:
        value = 1 / ((sigma - a) * (sigma - np.conj(a)) * (sigma - b) * (sigma - np.conj(b)))
        return np.stack([value, sigma * value], 1)

    return image


def _truth(a: complex, gap: float, times: np.ndarray) -> np.ndarray:
    """By partial fractions in 60 digits; a double pole as two at the distance 1e-25."""
    mp = mpmath.MPContext()
    mp.dps = 60
    z = mp.mpmathify(a)
    other = z + mp.mpf(gap or 1e-25)

    def part(one: Any, two: Any, t: float) -> Any:
        return mp.exp(one * t) / ((one - mp.conj(one)) * (one - two) * (one - mp.conj(two)))

    return np.array([float(2 * (part(z, other, t) + part(other, z, t)).real) for t in times])


@pytest.mark.parametrize("gap", [0.3, 1e-4])
def test_simple_poles(gap: float) -> None:
    a, b = -0.1 + 2j, -0.1 + 2j + gap
    times = np.array([0.0, 1.0, 20.0])
    found = modes(_image(a, b), [Pole(a), Pole(b)], np.zeros(0), -1.0, 20.0)
    assert len(found) == 2
    total = sum(mode.motion(times) for mode in found)
    assert total[0] == pytest.approx(_truth(a, gap, times), rel=1e-11 / gap)


@pytest.mark.parametrize("gap", [0.0, 1e-13, 1e-7])
@pytest.mark.parametrize("last", [20.0, 1000.0])
def test_poles_that_are_too_near_have_one_circle(gap: float, last: float) -> None:
    a, b = -0.001 + 2j, -0.001 + 2j + gap
    times = np.array([0.0, 1.0, last])
    for poles in ([Pole(a), Pole(b)], [Pole(a, 2, 1e-6)]):
        (mode,) = modes(_image(a, b), poles, np.zeros(0), -1.0, last)
        assert mode.multiplicity == 2
        known = _truth(a, gap, times)
        assert mode.motion(times)[0] == pytest.approx(known, abs=1e-9 * np.abs(known).max())


def test_what_is_apart_stays_apart() -> None:
    poles = [Pole(-0.1 + 1j), Pole(-0.1 + 1.000001j), Pole(-0.2 + 1j, 3)]
    assert [pole.multiplicity for pole in clustered(poles)] == [3, 2]
    assert clustered(poles)[1].sigma == pytest.approx(-0.1 + 1.0000005j)


@pytest.mark.parametrize("terms", [1, 2, 3])
def test_no_later_motion_is_larger_than_told(terms: int) -> None:
    moments = np.arange(1.0, terms + 1)[:, None] * np.array([[1.0, -2.0 + 1j]])
    mode, later = Mode(-0.2 + 3j, terms, moments), np.linspace(0, 60, 4001)
    for time in (0.0, 4.0, 20.0):
        size = np.abs(mode.motion(later[later >= time])).max(1)
        assert (size <= mode.most(time)).all()
        assert (mode.most(time) < 4 * terms * size).all()
    assert np.isinf(Mode(0.1 + 3j, 1, moments).most(1.0)).all()
    assert np.isinf(Mode(3j, 2, moments).most(1.0)).all() == (terms > 1)
