"""Rows over ranges of velocities have one bound of the frequencies that are looked at."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from endless_rows import masses

from mpsolve import InputError, Problem, tracks, vehicles
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.row import row_of
from mpsolve.endless.row_scope import row_scope
from mpsolve.errors import PrecisionError


def test_beyond_the_bound_every_motion_decays() -> None:
    row = masses("0.5")
    scope = row_scope(row, Fraction("0.1"), Fraction("0.5"))
    for v in ("0.1", "0.3", "0.5"):
        here = row.at_velocity(v)
        q = np.linspace(scope.X, 5 * scope.X, 200)
        ahead, back = Bloch(here).middle(1j * q)
        assert (np.abs(ahead) < 1).all()
        assert (np.abs(back) > 1).all()


def test_refusals() -> None:
    rayleigh = tracks.Rayleigh(EI=1, m=1, J="0.1", k=1, c="0.1")
    row = row_of(Problem(rayleigh, vehicles.Mass(3), v="0.3"), 2)
    with pytest.raises(PrecisionError):
        row_scope(row, Fraction("0.2"), Fraction("0.4"))
    string = tracks.String(T=1, m=1, k=1, c="0.1")
    row = row_of(Problem(string, vehicles.Mass(3), v="0.3"), 2)
    with pytest.raises(InputError, match="speed"):
        row_scope(row, Fraction("0.5"), Fraction("1.5"))
