"""Gains per vehicle are the extreme roots z over the real axis, to more digits than a grid has."""

from __future__ import annotations

import numpy as np
from endless_rows import masses

from mpsolve.endless.axis import closest, gains
from mpsolve.endless.bloch import Bloch


def test_gains_are_larger_than_those_of_any_grid() -> None:
    bloch = Bloch(masses("0.4"))
    ahead, back = gains(bloch, 1.0)
    a, b = bloch.middle(1j * np.linspace(1e-3, 1, 7001))
    assert 0 <= ahead.factor - np.abs(a).max() < 1e-5
    assert 0 <= back.factor - (1 / np.abs(b)).max() < 1e-5
    assert abs(back.factor - 1.05285) < 1e-5
    assert abs(abs(back.z) * back.factor - 1) < 1e-12


def test_at_rest_both_directions_are_alike() -> None:
    ahead, back = gains(Bloch(masses("0")), 1.0)
    assert abs(ahead.factor - back.factor) < 1e-9
    assert ahead.factor < 1


def test_the_moduli_meet_above_the_limit_only() -> None:
    assert closest(Bloch(masses("0.44")), 1.0)[0] > 1.005
    assert closest(Bloch(masses("0.45")), 1.0)[0] < 1 + 1e-8
