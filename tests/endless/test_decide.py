"""The number of growing motions is the same for every κ where no root is on the real axis."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from endless_rows import bogies, masses

from mpsolve import InputError, Problem, tracks, vehicles
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.decide import count_growing
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
