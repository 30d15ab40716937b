"""The dispersion relation on the line of a force: powers of p and factors in v are taken out."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq, fmpq_poly

from mpsolve.errors import InputError
from mpsolve.tracks import EulerBernoulli, FloatingIce, String
from mpsolve.tracks.waveguide import Waveguide
from mpsolve.waves.line import line


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
