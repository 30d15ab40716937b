"""Trains joined as scatterers have the determinant of the whole matrix, and the counts that are proved otherwise."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from endless_rows import bogies, masses

from mpsolve import Problem, certify, tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.doubling import growing_in_floats, train_piece
from mpsolve.endless.row import Row, row_of
from mpsolve.problem.reduced import reduce_problem


@pytest.mark.parametrize(("make", "most"), [(masses, 9), (bogies, 4)])
def test_the_determinant_is_that_of_the_train(make: Callable[[str], Row], most: int) -> None:
    row, sigma = make("0.4"), np.array([0.2j, 0.1 + 0.3j, 0.02 + 0.5j])
    for count in range(1, most):
        piece = train_piece(Bloch(row), count, sigma)
        ratio = np.exp(piece.size + 1j * piece.turn) / Floats(reduce_problem(row.train(count))).delta(sigma)[0]
        assert np.allclose(ratio, ratio[0], rtol=1e-9)


@pytest.mark.parametrize(("count", "v"), [(2, "0.73"), (2, "0.745"), (8, "0.56"), (16, "0.47"), (16, "0.485")])
def test_its_counts_are_those_that_are_proved(count: int, v: str) -> None:
    """The onsets of 2, 4, 8, 16 masses are 0.738, 0.610, 0.551, 0.479."""
    proved = certify(masses(v).train(count), region="unstable", digits=15, check=False)
    assert proved.proved
    assert growing_in_floats(Bloch(masses(v)), count, 1.0, 0.5) == proved.unstable


def test_long_trains_grow_above_the_limit() -> None:
    """Onsets of 64 and 128 masses: 0.4536 and below; the limit is 0.44507."""
    found = [
        growing_in_floats(Bloch(masses(v)), n, 1.0, 0.5) > 0
        for n, v in ((64, "0.452"), (64, "0.455"), (128, "0.445"))
    ]
    assert found == [False, True, False]


def test_a_resonance_that_each_vehicle_has_is_followed() -> None:
    """16 bogies turn 16 times as fast as one where its frame shakes: 4 growing roots were told where none is."""
    layers = tracks.TwoLayer(
        EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
    )
    bogie = vehicles.Bogie(wheel=900, frame=1500, inertia=800, wheelbase="2.5", k="1.2e6", c="1e4", k_contact="1e9")
    row = row_of(Problem(layers, bogie, v=100), 6)
    assert growing_in_floats(Bloch(row), 16, 1.0, 1.0) == 0


@pytest.mark.slow
def test_counts_of_64_masses_that_are_proved_lie_above_the_limit() -> None:
    for v, growing in (("0.452", 0), ("0.455", 4)):
        found = certify(masses(v).train(64), region="unstable", digits=15, check=False)
        assert found.proved
        assert found.count == growing
