"""Wave speeds with names are those at which the degree of D in p drops."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve.numbers.realroots import as_fmpq
from mpsolve.tracks import EulerBernoulli, Rayleigh, String, ThreeLayer, Timoshenko, Track
from mpsolve.waves.line import line
from mpsolve.waves.speeds import wave_speeds


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
