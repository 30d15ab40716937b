"""Double p-roots at a critical velocity, by a simple root of the discriminant and over the field: one answer."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve.tracks import EulerBernoulli
from mpsolve.tracks.waveguide import Waveguide
from mpsolve.waves.double import double_roots
from mpsolve.waves.line import line
from mpsolve.waves.place import places_of
from mpsolve.waves.velocity import Kind

BEAM = EulerBernoulli(EI=4, m=1, k=1).waveguide


def doubles(guide: Waveguide, omega: Any, single: bool) -> list[tuple[float, float, Kind]]:
    along = line(guide, Fraction(omega))
    found = places_of(along.discriminant, along.squared, Fraction(0), Fraction(50), 100)
    return [
        (float(place.velocity(100)), float(p), kind)
        for place, _ in found
        for p, kind in double_roots(along, place, single, 100)
    ]


@pytest.mark.parametrize("single", [True, False])
def test_both_ways_find_what_closed_forms_have(single: bool) -> None:
    """4 y² − w y + 1 has a double root at w = 4, y = 1/2. With ω = 1: p⁴ = 3/4 at v⁴ = 108, Ω = −2."""
    assert doubles(BEAM, 0, single) == [(2.0, 0.5, Kind.MINIMUM)]
    (v, p, kind), = doubles(BEAM, 1, single)  # fmt: skip
    assert (v**4, p**4, kind) == (pytest.approx(108), pytest.approx(0.75), Kind.TOUCHING)


def test_branches_that_cross_are_told_over_the_field() -> None:
    """Ω² = 4p² + 9 and Ω² = p² + 12 cross at p = 1, v² = 13."""
    terms = [{(0, 2): Fraction(1), (2, 0): Fraction(-T), (0, 0): Fraction(k)} for T, k in ((4, 9), (1, 12))]
    guide = Waveguide(((terms[0], {}), ({}, terms[1])))
    assert (pytest.approx(13**0.5), 1.0, Kind.MEETING) in doubles(guide, 0, False)
