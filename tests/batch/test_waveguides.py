"""D and N over arrays against the exact polynomials of each track."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from sympy import I, symbols

from mpsolve import tracks
from mpsolve.batch.waveguides import expanded
from mpsolve.numbers.model import quantities


@pytest.mark.parametrize("kind", tracks.CATALOGUE, ids=lambda kind: kind.name)
def test_every_track(kind: Any) -> None:
    names = list(quantities(kind))
    rows = [{name: Fraction(k + 3 * j + 2, 7) for k, name in enumerate(names)} for j in range(3)]
    made = [kind(**{**row, **({"N": 0} if "N" in row else {})}) for row in rows]
    values = {name: np.array([float(track.parameters[name]) for track in made]) for name in names}
    D, N = expanded(made[0])
    for polynomial, exact in ((D, "dispersion"), (N, "numerator")):
        found = polynomial.at(values, 3)
        for k, track in enumerate(made):
            expected = getattr(track.waveguide, exact)
            assert all(np.isclose(found[key][k], float(c), rtol=1e-14) for key, c in expected.items())
            assert all(abs(c[k]) < 1e-13 for key, c in found.items() if key not in expected)


def test_what_cancels_exactly_leaves_nothing() -> None:
    """k_pad² of a two-layer track is gone before any number is put in."""
    track = tracks.TwoLayer(EI=1, m=1, k_pad="1e12", c_pad=1, m_sleeper=1, k_ballast="1e-3", c_ballast=1)
    D, _ = expanded(track)
    assert D.at({name: float(x) for name, x in track.parameters.items()}, 1)[0, 0][0] == pytest.approx(1e9, rel=1e-15)


def test_a_made_up_waveguide() -> None:
    p, Omega = symbols("p Omega")
    track = tracks.Waveguide([[2 * p**4 + 1 + I * Omega / 10 - Omega**2]])
    D, N = expanded(track)
    assert {key: c.tolist() for key, c in D.at({}, 2).items()}[4, 0] == [2, 2]
    assert {key: c.tolist() for key, c in N.at({}, 2).items()} == {(0, 0): [1, 1]}
