"""Long waves in ice run as in open shallow water; without water to carry, the plate rests on its weight."""

from __future__ import annotations

import pytest

from mpsolve import dispersion, receptance
from mpsolve.tracks import EulerBernoulli, FloatingIce

ICE = {"B": "5e7", "h": "0.6", "rho_ice": 917, "rho_water": 1025, "depth": "6.8", "g": "9.8"}


def test_long_waves_run_at_the_shallow_water_velocity() -> None:
    p = 1e-4
    assert dispersion(FloatingIce(**ICE), [p])[0].real.max() / p == pytest.approx((9.8 * 6.8) ** 0.5, rel=1e-5)


def test_a_wave_of_any_length() -> None:
    """Ω² = (B p⁴ + ρ_w g)/(ρ_i h + ρ_w/(H p²)): plate, buoyancy, and the water that moves along."""
    p = 0.15
    squared = (5e7 * p**4 + 1025 * 9.8) / (917 * 0.6 + 1025 / (6.8 * p**2))
    assert dispersion(FloatingIce(**ICE), [p])[0].real.max() == pytest.approx(squared**0.5, rel=1e-12)


def test_under_a_slow_force_water_is_a_winkler_foundation() -> None:
    plate = EulerBernoulli(EI="5e7", m=1, k=1025 * 9.8)
    at = {"xi": [0, 10], "omega": [1e-6], "v": 0}
    assert receptance(FloatingIce(**ICE, c=1), **at) == pytest.approx(receptance(plate, **at), rel=1e-5)
