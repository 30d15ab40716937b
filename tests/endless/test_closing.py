"""Outside the rectangle the row takes energy, for every z: floats do not contradict what boxes prove."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from endless_rows import masses

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.start import start
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.boxes import ROUND, Boxes, LatticeArrays
from mpsolve.endless.closing import close
from mpsolve.endless.lattice import Lattice
from mpsolve.endless.row import row_of
from mpsolve.errors import PrecisionError
from mpsolve.proof.effort import Effort


def test_the_row_is_passive_on_the_walls_and_beyond() -> None:
    row = masses("0.4")
    boxes = Boxes(LatticeArrays.of(row), start(row.reduced.guide).up)
    closed = close(boxes, row, Effort(evaluations=200_000))
    bloch, lattice = Bloch(row), Lattice((Fraction(0),), row.step)
    axis = np.geomspace(closed.rho, 8 * closed.X, 200) + 0j
    walls = np.concatenate(
        [
            closed.rho - 1j * np.linspace(0, closed.depth, 60),
            np.linspace(-closed.rho, closed.rho, 60) - 1j * closed.depth,
            np.array([0.2 - 3j, 2 - 2j, -5 - 1j]),
        ]
    )
    for q in (axis, walls):
        for theta in np.linspace(-np.pi, np.pi, 40):
            G = lattice.sums(bloch.terms(1j * q), bloch.upper, np.exp(1j * theta), float, np.exp)[0][0]
            assert ((1j * q * G).real > 0).all()


def test_the_arcs_are_the_whole_circle() -> None:
    assert np.pi < ROUND


def test_faster_than_the_waves_there_is_no_theorem() -> None:
    wire = tracks.String(27000, "1.07", 500, 2)
    row = row_of(Problem(wire, vehicles.Mass(1), v=200), 20)
    boxes = Boxes(LatticeArrays.of(row), start(row.reduced.guide).up)
    with pytest.raises(PrecisionError, match="faster than short waves"):
        close(boxes, row, Effort(evaluations=10_000))
