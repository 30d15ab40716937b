"""The number of growing motions is the same for every κ where no root is on the real axis."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from endless_rows import bogies, masses

from mpsolve import InputError, Problem, tracks, vehicles
from mpsolve.characteristic.start import start
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.boxes import ROUND, Boxes, LatticeArrays
from mpsolve.endless.decide import close, count_growing
from mpsolve.endless.lattice import Lattice
from mpsolve.endless.row import row_of
from mpsolve.errors import EffortError, PrecisionError
from mpsolve.proof.effort import Effort


def budget(n: int = 300_000) -> Effort:
    return Effort(evaluations=n)


def test_below_the_threshold_nothing_grows_and_above_the_number_changes_with_kappa() -> None:
    assert count_growing(masses("0.18"), budget()).growing == 0
    with pytest.raises(PrecisionError, match="smallest boxes do not pass"):
        count_growing(masses("0.2"), budget())


def test_a_row_of_bogies() -> None:
    assert count_growing(bogies("0.3"), budget()).growing == 0


def test_far_apart_each_vehicle_grows_by_itself() -> None:
    """At 1.3 one mass of 40 has a pair of growing frequencies; 12 apart the next is hardly felt."""
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.6")
    row = row_of(Problem(beam, vehicles.Mass(40), v="1.3"), 12)
    found = count_growing(row, budget())
    assert found.growing == 2
    for theta in (0.0, 1.0, 3.0):  # floats: the change of the argument along the real axis and back far below
        closed = found.closed
        assert closed is not None
        corner = complex(closed.rho, -closed.depth)
        way = [-closed.rho, closed.rho, corner, complex(-closed.rho, -closed.depth), -closed.rho]
        q = np.concatenate([np.linspace(a, b, 4001)[1:] for a, b in pairwise(way)])
        value = Bloch(row).delta(1j * q, np.full(len(q), np.exp(1j * theta)))[0]
        steps = np.angle(value / np.roll(value, 1))
        assert np.abs(steps).max() < 0.5
        assert round(-steps.sum() / (2 * np.pi)) == 2


def test_at_rest_nothing_grows() -> None:
    assert count_growing(masses("0"), budget()).growing == 0


def test_what_cannot_be_decided() -> None:
    with pytest.raises(EffortError):
        count_growing(masses("0.18"), budget(500))
    undamped = tracks.EulerBernoulli(EI="0.25", m=1, k=1)
    with pytest.raises(InputError, match="without damping"):
        count_growing(row_of(Problem(undamped, vehicles.Mass(40), v="0.1"), "1.5"), budget())


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
