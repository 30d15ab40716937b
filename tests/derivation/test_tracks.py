"""The equations of motion give the matrices that the numerical models hold, for all parameters at once."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
import sympy as sp

from mpsolve import tracks
from mpsolve.derivation.tracks import Omega, derived, p, symbols_of


@pytest.mark.parametrize("model", tracks.CATALOGUE, ids=lambda model: model.name)
def test_the_matrix_is_the_one_that_is_computed_with(model: type[tracks.Track]) -> None:
    found = derived(model)
    names = SimpleNamespace(P=sp.I * p, s=sp.I * Omega, **vars(symbols_of(model)))
    rows = model.equations(names)
    assert model.loaded == 0
    assert sp.expand(sp.Matrix(rows) - found.matrix) == sp.zeros(len(rows))


@pytest.mark.parametrize("model", tracks.CATALOGUE, ids=lambda model: model.name)
def test_D_and_N_at_numbers(model: type[tracks.Track]) -> None:
    """sympy's determinants against the exact polynomials, at distinct primes."""
    found, primes = derived(model), [sp.prime(k) for k in range(3, 20)]
    values = dict(zip(vars(symbols_of(model)).values(), primes, strict=False))
    track = model(*(int(value) for value in values.values()))
    for expression, polynomial in (
        (found.dispersion, track.waveguide.dispersion),
        (found.numerator, track.waveguide.numerator),
    ):
        exact = sum(sp.Rational(c) * (sp.I * p) ** i * (sp.I * Omega) ** j for (i, j), c in polynomial.items())
        assert sp.expand(expression.subs(values) - exact) == 0


def test_every_parameter_has_a_part() -> None:
    for model in tracks.CATALOGUE:
        used = derived(model).matrix.free_symbols
        assert set(vars(symbols_of(model)).values()) <= used
