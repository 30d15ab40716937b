"""The shape is drawn under the vehicles and beside them."""

from __future__ import annotations

from mpsolve import read_problem
from mpsolve.batch.view import look
from mpsolve.explorer.shaping import root_picture, stretch

PROBLEM = read_problem("examples/two_layer_bogie.toml").problem


def test_it_reaches_beyond_the_contacts() -> None:
    x = stretch(PROBLEM, 81)
    assert len(x) == 81
    assert x[0] < min(PROBLEM.pencil.places) < max(PROBLEM.pencil.places) < x[-1]


def test_a_root_moves_rail_and_bodies() -> None:
    drawn = root_picture(PROBLEM, complex(look(PROBLEM).roots[-1]))
    assert drawn.count("<animate") >= 1 + 2 + len(PROBLEM.pencil.names)
