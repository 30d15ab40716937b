"""Wave speeds with names are those at which the degree of D in p drops."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mpsolve import dispersion
from mpsolve.numbers.realroots import as_fmpq
from mpsolve.tracks import EulerBernoulli, Rayleigh, Slab, String, ThreeLayer, Timoshenko, Track, TwoLayer
from mpsolve.tracks.undamped import undamped
from mpsolve.waves.line import line
from mpsolve.waves.speeds import slow_waves, wave_speeds


@pytest.mark.parametrize(
    ("track", "count"),
    [
        (String(T=4, m=3, k=1), 1),
        (Rayleigh(EI=4, m=1, J="0.5", k=1), 1),
        (Timoshenko(EI=4, m=1, S=9, J="0.5", k=1), 2),
        (Timoshenko(EI=4, m=1, S=9, J="0.5", k=1, N=2, kp="0.5"), 2),
        (ThreeLayer(EI=4, m=1, k_pad=30, m_sleeper=2, k_ballast=5, m_ballast=7, k_ground=3, shear=2), 1),
        (EulerBernoulli(EI=4, m=1, k=1), 0),
    ],
)
def test_the_leading_coefficient_vanishes_there(track: Track, count: int) -> None:
    speeds = wave_speeds(track)
    assert len(speeds) == count
    lead = line(track.waveguide, Fraction(0)).lead
    assert all(lead(as_fmpq(square)) == 0 for square in speeds.values())
    assert lead.degree() == count + (isinstance(track, ThreeLayer))


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
