"""A problem holds its vehicles in any order, and refuses what is none."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from catalogue_models import made
from hypothesis import given
from hypothesis import strategies as st
from vehicle_models import random_vehicles

from mpsolve import tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.problem.problem import Problem
from mpsolve.tracks import String
from mpsolve.vehicles import Mass, Oscillator, train

TRACK = String(T=1, m=1, k=1, c=1)


@given(st.lists(random_vehicles(), min_size=1, max_size=3), st.randoms())
def test_the_order_of_the_vehicles_does_not_matter(given_: list[Any], random: Any) -> None:
    """The pencil of shuffled vehicles is the same one with its coordinates renamed."""
    placed = [vehicle.at(100 * k) for k, vehicle in enumerate(given_)]
    order = list(range(len(placed)))
    random.shuffle(order)
    first, second = (Problem(TRACK, vs, v=1).pencil for vs in (placed, [placed[k] for k in order]))
    sizes = [one.vehicle.pencil.size for one in placed]
    starts = [sum(sizes[:k]) for k in range(len(sizes))]
    moved = [starts[k] + i for k in order for i in range(sizes[k])]
    assert (first.places, first.h) == (second.places, second.h)
    for key in "MCK":
        rows = getattr(first, key)
        assert getattr(second, key) == tuple(tuple(rows[i][j] for j in moved) for i in moved)
    assert tuple(first.B[i] for i in moved) == second.B


def test_a_bare_vehicle_stands_at_the_origin() -> None:
    problem = Problem(TRACK, Mass(3), v="0.1")
    assert problem.v == Fraction(1, 10)
    assert problem.pencil.places == (0,)
    assert problem.pencil.names == ("wheel",)
    two = Problem(TRACK, [Mass(3), Oscillator(1, 1, 1).at(2)], v=0)
    assert two.pencil.names == ("wheel of vehicle 1", "wheel of vehicle 2", "body of vehicle 2")


@pytest.mark.parametrize(
    ("values", "key"),
    [
        (("rail", Mass(1), 0), "track"),
        ((TRACK, [], 0), "vehicles"),
        ((TRACK, [Mass(1), 5], 0), "vehicles[2]"),
        ((TRACK, "mass", 0), "vehicles[1]"),
        ((TRACK, Mass(1), -1), "v"),
        ((TRACK, Mass(1), None), "v"),
    ],
)
def test_what_is_no_problem_is_refused(values: Any, key: str) -> None:
    with pytest.raises(InputError) as caught:
        Problem(*values)
    assert caught.value.key == key


def test_a_train_too_long_for_its_matrices_is_refused() -> None:
    assert Problem(TRACK, train(Mass(1), 1000, 1), v=1).pencil.size == 1000
    with pytest.raises(InputError, match="3000 coordinates"):
        _ = Problem(TRACK, [train(Mass(1), 1000, 1)] * 3, v=1).pencil


@pytest.mark.parametrize("vehicle", vehicles.CATALOGUE)
def test_a_problem_shows_itself_as_it_is_typed(vehicle: Any) -> None:
    names = {**vars(tracks), **vars(vehicles), "Problem": Problem}
    for track in tracks.CATALOGUE:
        problem = Problem(made(track), made(vehicle).at("1/3"), v="0.25")
        assert eval(repr(problem), names) == problem
    assert (
        repr(Problem(TRACK, Mass(3).at("0.5"), 2))
        == "Problem(String(T=1, m=1, k=1, c=1), [Mass(M=3).at('0.5')], v=2)"
    )
