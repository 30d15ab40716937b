"""A slab without bending stiffness is a row of sleepers; a stiff one stands still under the pads."""

from __future__ import annotations

import pytest

from mpsolve import receptance
from mpsolve.tracks import EulerBernoulli, Slab, TwoLayer

RAIL = {"EI": "6.4e6", "m": 60}
AT = {"xi": [0, 2], "omega": [150], "v": 25}


def test_without_bending_stiffness_it_is_two_layers() -> None:
    slab = Slab(**RAIL, k_pad="5e8", c_pad="2e5", m_slab=1094, k="1e8", c="1e5")
    layers = TwoLayer(**RAIL, k_pad="5e8", c_pad="2e5", m_sleeper=1094, k_ballast="1e8", c_ballast="1e5")
    assert receptance(slab, **AT) == pytest.approx(receptance(layers, **AT), rel=1e-12)


def test_a_slab_that_does_not_move_leaves_the_rail_on_its_pads() -> None:
    slab = Slab(**RAIL, k_pad="5e8", c_pad="2e5", EI_slab="1e8", m_slab=1, k="1e16")
    pads = EulerBernoulli(**RAIL, k="5e8", c="2e5")
    assert receptance(slab, **AT) == pytest.approx(receptance(pads, **AT), rel=1e-6)
