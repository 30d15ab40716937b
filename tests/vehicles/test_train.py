"""Equal vehicles in a row."""

from __future__ import annotations

from typing import Any

import pytest

from mpsolve import vehicles
from mpsolve.errors import InputError
from mpsolve.problem.problem import Problem
from mpsolve.tracks import String

TRACK = String(T=1, m=1, k=1, c=1)


def test_a_train_stands_among_other_vehicles() -> None:
    train = vehicles.train(vehicles.Mass(2), 3, "2.5")
    assert Problem(TRACK, train, v=0).pencil.places == (0, 2.5, 5)
    problem = Problem(TRACK, [train, vehicles.Mass(1).at(-1), vehicles.Mass(7)], v=0)
    assert problem.pencil.places == (-1, 0, 0, 2.5, 5)
    assert [row[i] for i, row in enumerate(problem.pencil.M)] == [2, 2, 2, 1, 7]


@pytest.mark.parametrize(
    ("values", "key"),
    [
        ((TRACK, 2, 1), "vehicle"),
        ((vehicles.Mass(1).at(0), 2, 1), "vehicle"),
        ((vehicles.Mass(1), 0, 1), "count"),
        ((vehicles.Mass(1), True, 1), "count"),
        ((vehicles.Mass(1), 2.0, 1), "count"),
        ((vehicles.Mass(1), 10**9, 1), "count"),
        ((vehicles.Mass(1), 2, 0), "spacing"),
        ((vehicles.Mass(1), 2, "root4(2)"), "spacing"),
    ],
)
def test_what_is_no_train_is_refused(values: Any, key: str) -> None:
    with pytest.raises(InputError) as caught:
        vehicles.train(*values)
    assert caught.value.key == key
