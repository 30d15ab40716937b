"""The frequency beyond which contacts are passive, against eigenvalues: never too low, and not much too high."""

from __future__ import annotations

import numpy as np
import pytest
from passive_subjects import RAIL, TRACKS, family_and_envelope, least, reduced_and_envelope

from mpsolve import Problem, tracks, vehicles
from mpsolve.passivity.box import halved, passive_beyond
from mpsolve.passivity.far import far


@pytest.mark.parametrize("count", [1, 2, 4])
@pytest.mark.parametrize("name", TRACKS)
def test_against_eigenvalues(name: str, count: int) -> None:
    reduced, envelope = reduced_and_envelope(name, count)
    X = passive_beyond(envelope)
    q = np.geomspace(1e-3, 100, 3000)
    values = least(reduced.guide, reduced.places, q)
    assert (values[q >= X] > -1e-13).all()
    bad = q[values < 1e-5]
    slack = 2.5 if name in ("kelvin-voigt", "string") else 1.4  # narrow waves: cells of q are wider than these
    assert max(slack * bad.max(initial=0.0), 0.15) >= X
    assert far(envelope) >= X


def test_a_box_within_the_box() -> None:
    pair = Problem(RAIL, [vehicles.Mass(900), vehicles.Mass(900).at("2.5")], v=150)
    whole, part = (
        passive_beyond(family_and_envelope(pair, {"track.k": (5e5, k), "v": (0, v)})[1])
        for k, v in ((15e5, 200), (625000, 25))
    )
    assert part <= whole


def test_none_where_short_waves_are_outrun() -> None:
    wire = tracks.String(T=27000, m="1.07", k=500, c=2)
    pair = Problem(wire, [vehicles.Mass(9), vehicles.Mass(9).at(20)], v=100)
    _, envelope = family_and_envelope(pair, {"v": (170, 180)})
    assert passive_beyond(envelope) is None


def test_halves() -> None:
    low, high, cell = halved(np.array([[1.0, 0.0]]), np.array([[1.5, 4.0]]), np.array([7]))
    assert low.tolist() == [[1.0, 0.0], [1.0, 2.0]]
    assert high.tolist() == [[1.5, 2.0], [1.5, 4.0]]
    assert cell.tolist() == [7, 7]
