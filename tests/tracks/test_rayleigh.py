"""Rotary inertia: short waves have a greatest velocity, and without it the beam is Euler's."""

from __future__ import annotations

import pytest

from mpsolve import dispersion
from mpsolve.tracks import EulerBernoulli, Rayleigh

RAIL = {"EI": "6.4e6", "m": 60, "k": "1e6"}


def test_short_waves_run_at_the_bar_velocity() -> None:
    track = Rayleigh(**RAIL, J="0.25")
    p = 1e5
    assert dispersion(track, [p])[0].real.max() / p == pytest.approx((6.4e6 / 0.25) ** 0.5, rel=1e-6)


def test_the_rotary_inertia_is_the_only_difference() -> None:
    (with_it,), (without,) = (
        Rayleigh(**RAIL, J="0.25").waveguide.matrix[0],
        EulerBernoulli(**RAIL).waveguide.matrix[0],
    )
    assert with_it == without | {(2, 2): -0.25}
