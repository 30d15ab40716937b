"""The exponentials of the modes are the rational function N/D, with its double poles set apart."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import grid
from track_models import DAMPED

from mpsolve import tracks
from mpsolve.finite.discretization import Discretization, discretized, in_s
from mpsolve.finite.exponentials import Waves, exponentials, gauss, moments, nested_moments, separated, wave_tables


def _ratio(track: Discretization, s: complex) -> np.ndarray:
    k = track.wavenumbers
    N, D = (sum(c * s**j for j, c in enumerate(in_s(a, k, 8))) for a in (track.numerator, track.dispersion))
    return N / D


def _sum(track: Discretization, s: complex) -> np.ndarray:
    """The image of Re(weight e^{rate t}): half of it, and of its conjugate."""
    found = exponentials(track)
    return (found.weight / (s - found.rate) + found.weight.conj() / (s - found.rate.conj())).sum(0) / 2


@pytest.mark.parametrize("name", DAMPED)
def test_the_exponentials_sum_to_the_answer_of_the_modes(name: str) -> None:
    track = discretized(DAMPED[name].waveguide, 100.0, 400)
    for s in (5.0 + 0j, 1 + 300j, 2 + 5000j):
        truth = _ratio(track, s)
        assert np.abs(_sum(track, s) - truth).max() < 1e-8 * np.abs(truth).max()
        assert np.median(np.abs(_sum(track, s) / truth - 1)) < 1e-9


def test_a_critically_damped_mode_keeps_its_answer() -> None:
    """s² + 2cs + κ⁴ + k with c² = κ⁴ + k for the first mode, on either side of it and there."""
    critical = np.sqrt((np.pi / 10) ** 4 + 1)
    for shift in (-1e-9, -1e-14, 0, 1e-14, 1e-9):
        beam = tracks.EulerBernoulli(EI=1, m=1, k=1, c=2 * float(critical) * (1 + shift))
        track = discretized(beam.waveguide, 10.0, 8)
        assert _sum(track, 0.3 + 0.2j) == pytest.approx(_ratio(track, 0.3 + 0.2j), rel=1e-8)


def test_roots_that_meet_are_set_apart_and_stay_conjugates() -> None:
    z = np.array([[-1 + 2j, -1 + 2j, -1 - 2j, -1 - 2j], [-3, -3, -5, -7], [-1 + 1e-9j, -1 - 1e-9j, -2, -4]])
    apart = separated(z)
    for before, after in zip(z, apart, strict=True):
        gaps = np.abs(after[:, None] - after) + np.eye(4)
        assert gaps.min() > 0.5e-5
        assert np.allclose(np.sort_complex(after), np.sort_complex(after.conj()), rtol=0, atol=1e-12)
        assert abs(after.sum() - before.sum()) < 1e-12


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
