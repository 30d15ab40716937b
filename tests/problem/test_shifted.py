"""A shifted family is the same function on another line."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import Case, Problem, tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.problem.cases import as_problem
from mpsolve.problem.family import family_of
from mpsolve.problem.shifted import shifted

PAIR = as_problem(Case(alpha="0.7", eta_b="0.05", eta_m=(70, 40), positions=(0, "1.5")))
LAYERS = tracks.TwoLayer(
    EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
)
SPRUNG = Problem(LAYERS, vehicles.Oscillator(wheel=900, body=2000, k="1.2e6", c=4000), v=100)


@pytest.mark.parametrize(
    ("problem", "path", "ends"),
    [(PAIR, "gap[0]", (1, 2)), (PAIR, "v", ("0.5", "0.8")), (SPRUNG, "track.c_ballast", (60000, 90000))],
)
@pytest.mark.parametrize("s", [Fraction(1, 8), Fraction(-1, 256)])
def test_the_determinant_is_moved(problem: Problem, path: str, ends: tuple[object, object], s: Fraction) -> None:
    low, high = (Fraction(str(end)) for end in ends)
    family = family_of(problem, {path: (low, high)})
    moved = shifted(family, s)
    x = [(low + high) / 2 / family.units[0]]
    sigma = np.array([0.3 + 0.2j, 0.5 + 1j, 0.25 + 3j])
    here = Floats(family.reduced(x)).delta(sigma)
    there = Floats(moved.reduced(x)).delta(sigma - float(s))
    for one, other in zip(here, there, strict=True):
        np.testing.assert_allclose(other, one, rtol=1e-9)
    assert shifted(family, Fraction(0)) is family
