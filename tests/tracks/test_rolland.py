"""D and N against mobilities that rolland computed (github.com/mantelmax/rolland, BSD-3): |iω G| at rest."""

from __future__ import annotations

import csv
from math import pi
from pathlib import Path

import numpy as np
import pytest

from mpsolve import tracks
from mpsolve.tracks.waveguide import Polynomial

FILE = Path(__file__).parents[1] / "data" / "rolland_mobility.csv"
RAIL = {"EI": "6380430", "m": "60.2"}
TRACKS = {
    "one_layer_mobility_m_per_Ns": tracks.EulerBernoulli(**RAIL, k="300e6", c="3e4"),
    "two_layer_mobility_m_per_Ns": tracks.TwoLayer(
        **RAIL, k_pad="300e6", c_pad="3e4", m_sleeper=250, k_ballast="100e6", c_ballast="8e4"
    ),
}


def in_p(a: Polynomial, omega: float) -> np.ndarray:
    """Coefficients in p, highest first, at P = ip, s = iω."""
    line = np.zeros(max(i for i, _ in a) + 1, complex)
    for (i, j), c in a.items():
        line[i] += float(c) * 1j**i * (1j * omega) ** j
    return line[::-1]


@pytest.mark.parametrize("column", TRACKS)
def test_the_mobility_at_rest(column: str) -> None:
    guide = TRACKS[column].waveguide
    with FILE.open() as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) > 100
    for row in rows:
        omega = 2 * pi * float(row["frequency_Hz"])
        D, N = (in_p(a, omega) for a in (guide.dispersion, guide.numerator))
        upper = [p for p in np.roots(D) if p.imag > 0]
        G = 1j * sum(np.polyval(N, p) / np.polyval(np.polyder(D), p) for p in upper)
        assert abs(1j * omega * G) == pytest.approx(float(row[column]), rel=1e-9)
