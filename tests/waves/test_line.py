"""Double p-roots at a critical velocity, by a simple root of the discriminant and over the field: one answer."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from flint import fmpq, fmpq_poly

from mpsolve.errors import InputError
from mpsolve.tracks import EulerBernoulli, FloatingIce, String
from mpsolve.tracks.waveguide import Waveguide
from mpsolve.waves.line import double_roots, line
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


def test_a_string_at_a_frequency() -> None:
    """T p² − m(ω − vp)² + k at T = 4, m = 1, k = 9, ω = 5."""
    found = line(String(T=4, m=1, k=9).waveguide, Fraction(5))
    unit = found.rows[0][0] / -16
    assert [row * (1 / unit) for row in found.rows] == [fmpq_poly([-16]), fmpq_poly([0, 10]), fmpq_poly([4, 0, -1])]
    assert (found.stripped, found.content.degree(), found.squared) == (0, 0, False)


def test_the_beam_without_frequency_in_squares() -> None:
    """y²/4 − wy + 1, whose discriminant is w² − 1."""
    found = line(EulerBernoulli(EI="1/4", m=1, k=1).waveguide, Fraction(0))
    assert found.squared
    d = found.discriminant
    assert d.degree() == 2
    assert d(fmpq(1)) == d(fmpq(-1)) == 0


def test_a_string_without_stiffness_is_one_wave_of_every_length() -> None:
    found = line(String(T=4, m=1).waveguide, Fraction(0))
    assert (found.stripped, len(found.rows)) == (1, 1)
    assert found.content(fmpq(4)) == 0


def test_water_takes_out_one_power() -> None:
    found = line(FloatingIce(B=100, h=1, rho_ice=9, rho_water=10, depth=2).waveguide, Fraction(0))
    assert (found.stripped, len(found.rows)) == (1, 3)


def test_branches_that_coincide_are_told() -> None:
    twice = String(T=4, m=1, k=9).waveguide.matrix[0][0]
    guide = Waveguide(((twice, {}), ({}, twice)))
    assert line(guide, Fraction(0)).repeated
    assert not line(String(T=4, m=1, k=9).waveguide, Fraction(0)).repeated


def test_no_mass_no_wave() -> None:
    with pytest.raises(InputError, match="no undamped wave"):
        line(Waveguide((({(0, 0): Fraction(1), (2, 0): Fraction(-1)},),)), Fraction(3))
