"""Three springs in series at rest; ballast that does not move leaves two layers."""

from __future__ import annotations

import pytest

from mpsolve import receptance
from mpsolve.errors import InputError
from mpsolve.tracks import EulerBernoulli, ThreeLayer, TwoLayer

RAIL = {"EI": "6.4e6", "m": 60}


def test_at_rest_the_layers_are_springs_in_series() -> None:
    layered = ThreeLayer(
        **RAIL, k_pad="3e8", m_sleeper=250, k_ballast="1e8", m_ballast=900, k_ground="6e7", c_ground=1
    )
    series = EulerBernoulli(**RAIL, k=1 / (1 / 3e8 + 1 / 1e8 + 1 / 6e7))
    at = {"xi": [0, 1], "omega": [0], "v": 0}
    assert receptance(layered, **at) == pytest.approx(receptance(series, **at), rel=1e-12)


def test_heavy_ballast_stands_still_so_two_layers_are_left() -> None:
    layers = {"k_pad": "3e8", "c_pad": "3e4", "m_sleeper": 250, "k_ballast": "1e8", "c_ballast": "8e4"}
    three, two = ThreeLayer(**RAIL, **layers, m_ballast="1e15", k_ground=1), TwoLayer(**RAIL, **layers)
    at = {"xi": [0, 1], "omega": [300], "v": 20}
    assert receptance(three, **at) == pytest.approx(receptance(two, **at), rel=1e-6)


def test_layers_that_do_not_feel_each_other_are_refused() -> None:
    with pytest.raises(InputError, match="do not feel each other"):
        ThreeLayer(**RAIL, k_pad=1)
