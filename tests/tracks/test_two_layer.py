"""Springs in series, and a sleeper that is a mass on two springs."""

from __future__ import annotations

import pytest

from mpsolve import receptance
from mpsolve.tracks import EulerBernoulli, TwoLayer

RAIL = {"EI": "6.4e6", "m": 60}


def test_at_rest_pads_and_ballast_are_springs_in_series() -> None:
    layered = TwoLayer(**RAIL, k_pad="3e8", c_pad="3e4", m_sleeper=250, k_ballast="1e8", c_ballast="8e4")
    series = EulerBernoulli(**RAIL, k="7.5e7")
    at = {"xi": [0, "0.7"], "omega": [0], "v": 0}
    assert receptance(layered, **at) == pytest.approx(receptance(series, **at), rel=1e-12)


def test_at_a_frequency_it_is_a_foundation_with_the_layers_dynamic_stiffness() -> None:
    """κ(ω) = pad · below/(pad + below), below = ballast − m_sleeper ω²."""
    omega = 400.0
    pad, below = 3e8 + 3e4j * omega, 1e8 + 8e4j * omega - 250 * omega**2
    kappa = pad * below / (pad + below)
    layered = TwoLayer(**RAIL, k_pad="3e8", c_pad="3e4", m_sleeper=250, k_ballast="1e8", c_ballast="8e4")
    beam = EulerBernoulli(**RAIL, k=kappa.real, c=kappa.imag / omega)
    at = {"xi": [0, "0.7"], "omega": [omega], "v": 0}
    assert receptance(layered, **at) == pytest.approx(receptance(beam, **at), rel=1e-10)
