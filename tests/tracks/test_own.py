"""Anybody's own track from a sympy matrix: exact, and refused where it is no passive, stable track."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from sympy import I
from track_models import DAMPED

from mpsolve import certify, tracks
from mpsolve.derivation.tracks import derived, symbols_of
from mpsolve.errors import InputError
from mpsolve.problem.problem import Problem
from mpsolve.tracks.structure import passive_by_equations
from mpsolve.vehicles import Mass

p, Omega = sp.symbols("p Omega")
BEAM = sp.Rational(1, 4) * p**4 + 1 + I * Omega / 10 - Omega**2


@pytest.mark.parametrize("name", DAMPED)
def test_the_derived_matrix_of_every_track_gives_the_track(name: str) -> None:
    """From the equations of motion to the exact data, with the numbers put in."""
    track = DAMPED[name]
    numbers = track.parameters
    values = {symbol: sp.Rational(numbers[key]) for key, symbol in vars(symbols_of(type(track))).items()}
    own = tracks.Waveguide(derived(type(track)).matrix.subs(values))
    assert own.matrix == track.waveguide.matrix
    assert eval(repr(own), {"Waveguide": tracks.Waveguide}) == own
    assert (own.dispersion, own.numerator) == (track.waveguide.dispersion, track.waveguide.numerator)


def test_it_is_a_track() -> None:
    own = tracks.Waveguide([[BEAM]])
    assert own.dispersion == {(4, 0): Fraction(1, 4), (0, 0): 1, (0, 1): Fraction(1, 10), (0, 2): 1}
    assert own.numerator == {(0, 0): 1}
    assert repr(own) == "Waveguide([['1/4*p**4 - 1*Omega**2 + 1/10*I*Omega + 1']], loaded=0)"
    assert Problem(own, Mass(1), v=1).track.waveguide is own
    assert hash(own) == hash(tracks.Waveguide(sp.Matrix([[BEAM]])))
    assert tracks.Waveguide([[1, 0], [0, BEAM]], loaded=1).numerator == own.numerator


def test_decimals_are_read_as_they_are_printed() -> None:
    own = tracks.Waveguide([[0.1 * p**4 + 1.5 + 0.3 * I * Omega - 0.25 * Omega**2]])
    assert own.dispersion == {
        (4, 0): Fraction(1, 10), (0, 0): Fraction(3, 2), (0, 1): Fraction(3, 10), (0, 2): Fraction(1, 4)
    }  # fmt: skip


def test_symbols_may_carry_assumptions() -> None:
    q, W = sp.symbols("p Omega", positive=True)
    assert tracks.Waveguide([[BEAM.subs({p: q, Omega: W})]]) == tracks.Waveguide([[BEAM]])


@pytest.mark.parametrize(
    ("matrix", "loaded", "key", "said"),
    [
        ("rail", 0, "matrix", "sympy matrix"),
        ([[1, 2]], 0, "matrix", "1 rows and 2 columns"),
        ([[BEAM]], 1, "loaded", "0 to 0"),
        ([[BEAM]], True, "loaded", "0 to 0"),
        ([[BEAM + sp.Symbol("k")]], 0, "matrix[1][1]", "the symbol k"),
        ([[BEAM + sp.exp(p)]], 0, "matrix[1][1]", "no polynomial"),
        ([[BEAM + 1 / p]], 0, "matrix[1][1]", "no polynomial"),
        ([[BEAM + sp.sqrt(2)]], 0, "matrix[1][1]", "irrational"),
        ([[BEAM + Omega]], 0, "matrix[1][1]", "not real"),
        ([[BEAM + I * p]], 0, "matrix", "odd powers"),
        ([[0]], 0, "matrix", "no wave"),
        ([[p**4 + 1]], 0, "matrix", "mass or damping"),
        ([[I * Omega - Omega**2]], 0, "matrix", "without end"),
        ([[BEAM, BEAM], [1, 1]], 0, "matrix", "no wave"),
        ([[BEAM - 2]], 0, "matrix", "buckles"),
        ([[BEAM - 3 * p**2]], 0, "matrix", "buckles"),
        ([[BEAM - I * Omega]], 0, "matrix", "grows"),
    ],
)
def test_what_is_no_track_is_refused(matrix: Any, loaded: Any, key: str, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        tracks.Waveguide(matrix, loaded)
    assert caught.value.key == key


def test_what_gives_energy_is_refused() -> None:
    """A force g z that follows the deflection late, z + ż = w: stable for g < 0.21, and active at low frequencies."""
    g = sp.Rational(3, 20)
    assert tracks.Waveguide([[BEAM, g / 3], [-1, 1 + I * Omega]]).dispersion
    with pytest.raises(InputError, match="not passive: it gives energy to a force near"):
        tracks.Waveguide([[BEAM, g], [-1, 1 + I * Omega]])


PAD, BALLAST = 3 + I * Omega / 5, 1 + I * Omega / 10
RAIL = p**4 / 4 - Omega**2 + PAD
LAYERS = [[RAIL, -PAD], [-PAD, -2 * Omega**2 + PAD + BALLAST]]


@pytest.mark.parametrize("factors", [(2, 1), (1, 2), (-3, 1), (sp.Rational(1, 3), -5)])
def test_rows_and_fields_may_have_any_scale(factors: tuple[Any, Any]) -> None:
    """The sleeper's equation times a number, or its motion in another unit: the same track, seen to be passive."""
    row, unit = factors
    given = [[RAIL, -PAD * unit], [-PAD * row, LAYERS[1][1] * row * unit]]
    own, plain = tracks.Waveguide(given), tracks.Waveguide(LAYERS)
    ratio = own.dispersion[0, 0] / plain.dispersion[0, 0]
    assert own.dispersion == {key: ratio * c for key, c in plain.dispersion.items()}
    assert own.numerator == {key: ratio * c for key, c in plain.numerator.items()}
    assert passive_by_equations(own)


def test_a_track_that_does_not_show_its_passivity_is_counted_in_a_half_disc() -> None:
    """The sleeper's motion relative to the rail: no certificate can show passivity by these equations."""
    relative = [[RAIL - PAD, -PAD], [-2 * Omega**2 + BALLAST, -2 * Omega**2 + PAD + BALLAST]]
    own = tracks.Waveguide(relative)
    assert own.numerator == tracks.Waveguide(LAYERS).numerator
    assert not passive_by_equations(own)
    pair = [Mass(5).at(0), Mass(5).at(1)]
    found, plain = (certify(Problem(track, pair, v="1.3"), region="unstable")
                    for track in (own, tracks.Waveguide(LAYERS)))  # fmt: skip
    assert found.proved
    assert found.stable is plain.stable is False
    assert [root.q.overlaps(other.q) for root, other in zip(found.roots, plain.roots, strict=True)] == [True, True]
    assert "by itself" in found.note
