"""Slow short waves: what is said against dispersion curves in floats."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve import dispersion
from mpsolve.tracks import EulerBernoulli, Slab, String, ThreeLayer, Timoshenko, TwoLayer
from mpsolve.tracks.undamped import undamped
from mpsolve.waves.slow import slow_waves

LAYERS: dict[str, Any] = {"EI": "6.4e6", "m": 60, "k_pad": "3e8", "c_pad": "3e4", "k_ballast": "1e8"}


@pytest.mark.parametrize(
    ("track", "slow"),
    [
        (TwoLayer(**LAYERS, m_sleeper=250, c_ballast="8e4"), True),
        (TwoLayer(**LAYERS), False),  # one layer: pads and ballast in series
        (ThreeLayer(**LAYERS, m_sleeper=250, m_ballast=500, k_ground="1e8", shear="1e7"), True),
        (Slab(EI="6.4e6", m=60, k_pad="3e8", m_slab=1000, k="1e8"), True),
        (Slab(EI="6.4e6", m=60, k_pad="3e8", EI_slab="1e8", m_slab=1000, k="1e8"), False),
        (EulerBernoulli(EI="6.4e6", m=60, k="1e8", c=1000), False),
        (Timoshenko(EI="6.4e6", m=60, S="4e8", J="0.24", k="1e8"), False),
        (String(T=9, m=1, k=4), False),
    ],
    ids=lambda x: getattr(x, "name", x),
)
def test_against_the_curves(track: Any, slow: bool) -> None:
    p = np.geomspace(1e-3, 1e4, 2001)
    speed = np.abs(dispersion(undamped(track), p).real) / p[:, None]
    least = float(np.nanmin(speed[np.isfinite(speed)]))
    assert slow_waves(track) is slow is (least < 1.0)
