"""The rail's receptance in the track's own units: others' numbers, Fourier integrals, limits, bad input."""

from __future__ import annotations

import csv
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy

from mpsolve.characteristic.forced import receptance
from mpsolve.errors import InputError
from mpsolve.tracks import EulerBernoulli, String, TwoLayer, Waveguide

CSV = Path(__file__).parents[1] / "data" / "rolland_mobility.csv"
EI = 210 * 10**9 * Fraction("3038.30e-8")
LAYERS = {
    "one": EulerBernoulli(EI=EI, m="60.2", k="300e6", c="3e4"),
    "two": TwoLayer(EI=EI, m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper=250, k_ballast="100e6", c_ballast="8e4"),
}
BEAM = EulerBernoulli(EI="1/4", m=1, k=1, c="0.2", N="0.2")


@pytest.mark.parametrize("layers", LAYERS)
def test_the_mobilities_of_rolland(layers: str) -> None:
    """tests/data/README.md has their source."""
    with CSV.open() as stream:
        rows = list(csv.DictReader(stream))
    omega = 2 * np.pi * np.array([float(row["frequency_Hz"]) for row in rows])
    published = np.array([float(row[f"{layers}_layer_mobility_m_per_Ns"]) for row in rows])
    assert len(rows) > 100
    assert np.abs(np.abs(1j * omega * receptance(LAYERS[layers], 0, omega)[0]) / published - 1).max() < 1e-9


def integral(xi: float, omega: complex, v: float) -> complex:
    """(1/2π) ∫ e^{ipξ}/D dp over |p| ≤ 400, by Gauss–Legendre panels; beyond, 1/D is below 4p⁻⁴."""
    ends = np.concatenate([np.linspace(0, 12, 121), np.linspace(12, 400, 1001)[1:]])
    nodes, weights = np.polynomial.legendre.leggauss(16)
    half = np.diff(ends)[:, None] / 2
    p = ((ends[1:] + ends[:-1])[:, None] / 2 + half * nodes).ravel()
    total = 0j
    for k in (p, -p):
        moving = omega - v * k
        D = k**4 / 4 - 0.2 * k * k - moving**2 + 0.2j * moving + 1
        total += complex(np.sum((half * weights).ravel() * np.exp(1j * k * xi) / D))
    return total / (2 * np.pi)


def test_it_is_the_fourier_integral() -> None:
    xi, omega = [-1.5, 0.0, 0.7], [0.3 - 0.2j, 1.5 - 0.4j, -0.1 - 1j, 0.5]
    table = receptance(BEAM, xi, omega, v="0.8")
    assert table.shape == (3, 4)
    for i, place in enumerate(xi):
        for j, point in enumerate(omega):
            assert abs(table[i, j] - integral(place, point, 0.8)) < 2e-8


def test_real_frequencies_are_limits_from_below() -> None:
    """Also where every wave is undamped, and where the string is outrun."""
    for track, v in ((EulerBernoulli(EI="1/4", m=1, k=1), "0.6"), (String(T=4, m=1, k=1), 3), (BEAM, "1.3")):
        omega = np.linspace(1.2, 3, 30)
        axis, below = (receptance(track, [-1, 0, 2], w, v=v) for w in (omega, omega - 1e-8j))
        assert np.abs(axis - below).max() < 1e-6 * np.abs(axis).max()


def test_symmetry_and_scalars() -> None:
    table = receptance(BEAM, 0.4, np.array([0.3 - 0.2j, -0.3 - 0.2j]), v="0.8")
    assert abs(table[0, 1] - table[0, 0].conj()) < 1e-13


def test_bare_equations_are_a_track_too() -> None:
    assert np.array_equal(receptance(BEAM.waveguide, [0, 1], 0.3), receptance(BEAM, [0, 1], 0.3))


@pytest.mark.parametrize(
    ("track", "xi", "omega", "v", "key"),
    [
        ("beam", 0, 0, 0, "track"),
        (BEAM, [np.nan], [0], 0, "xi"),
        (BEAM, [[0.0]], [0], 0, "xi"),
        (BEAM, ["a"], [0], 0, "xi"),
        (BEAM, [], [0], 0, "xi"),
        (BEAM, [0], [1 + 0.1j], 0, "omega"),
        (BEAM, [0], [np.inf], 0, "omega"),
        (BEAM, [0], [0], -1, "v"),
        (String(T=1, m=1), [0], [0], 0, "omega"),
        (BEAM, [0], [1], "1e300", "omega"),
        (EulerBernoulli(EI=1, m=1, k=1, c=1, N=3), [0], [1], 0, "track"),
    ],
)
def test_bad_input(track: Any, xi: Any, omega: Any, v: Any, key: str) -> None:
    with pytest.raises(InputError) as caught:
        receptance(track, xi, omega, v=v)
    assert caught.value.key == key


def beside_an_oscillator(xi: float, omega: float, v: float) -> complex:
    """The string T = m = k = 1 by itself: D_p = ±2√… at its two waves, ahead of the force or behind it."""
    root = np.sqrt(omega**2 - (1 - v**2) + 0j)  # half of the discriminant of (1 − v²) p² + 2 v ω p − ω² + 1
    waves = [((-v * omega + sign * root) / (1 - v**2), sign) for sign in (1, -1)]
    if v > 1:
        ahead, behind = [], waves
    else:  # energy runs ahead in the wave with D_p < 0 at real frequencies
        ahead, behind = [waves[1]], [waves[0]]
    side, turn = (ahead, 1j) if xi >= 0 else (behind, -1j)
    return complex(sum(turn * np.exp(1j * p * xi) / (2 * sign * root) for p, sign in side))


@pytest.mark.parametrize(("v", "omega"), [("2", 1e4), ("2", 1e6), ("1/1000000", 2.0), ("1/1000000", 50.0)])
def test_waves_that_floats_do_not_tell_apart(v: str, omega: float) -> None:
    """Oscillators that nothing couples to the string carry two more waves, near ω/v and nearly one."""
    p, frequency = sympy.symbols("p Omega")
    track = Waveguide([[p**2 - frequency**2 + 1, 0], [0, sympy.Rational(31, 16) - 5 * frequency**2]], loaded=0)
    xi = [0.0, 0.5, -0.5, 3.0, -3.0]
    expected = np.array([beside_an_oscillator(x, omega, float(Fraction(v))) for x in xi])
    found = receptance(track, xi, omega, v=v)[:, 0]
    assert np.abs(found - expected).max() < 1e-6 * np.abs(expected).max()
