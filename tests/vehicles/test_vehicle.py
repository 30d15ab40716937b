"""Parts become one vehicle: links add up as energies do, and joined parts do not feel each other."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from vehicle_models import random_vehicles

from mpsolve import vehicles
from mpsolve.errors import InputError
from mpsolve.problem.problem import Problem
from mpsolve.tracks import String
from mpsolve.vehicles.vehicle import AnyVehicle, assemble, joined, linked

NUMBERS = st.integers(-5, 5).map(Fraction)


def energy(rows: object, y: list[Fraction]) -> Fraction:
    return sum((a * y[i] * y[j] for i, row in enumerate(rows) for j, a in enumerate(row)), Fraction(0))  # type: ignore[arg-type, var-annotated]


@given(st.lists(st.tuples(NUMBERS, NUMBERS, NUMBERS), max_size=4), st.tuples(NUMBERS, NUMBERS))
def test_a_spring_stores_half_k_times_its_lengthening_squared(
    links: list[tuple[Fraction, Fraction, Fraction]], at: tuple[Fraction, Fraction]
) -> None:
    one = Fraction(1)
    springs = [({0: a, 1: b}, k, Fraction(0)) for a, b, k in links]
    pencil = assemble(("first", "second"), (one, one), springs, [(Fraction(0), {0: one})], None)
    assert energy(pencil.K, list(at)) == sum(k * (a * at[0] + b * at[1]) ** 2 for a, b, k in links)


@given(random_vehicles(), random_vehicles())
def test_joined_vehicles_are_blocks_and_their_contacts_are_in_order(first: AnyVehicle, second: AnyVehicle) -> None:
    a, b = first.pencil, second.pencil
    both = joined([(a, Fraction(0), " 1"), (b, Fraction(1, 3), " 2")])
    assert both.places == tuple(sorted([*a.places, *(x + Fraction(1, 3) for x in b.places)]))
    for key in "MCK":
        whole = getattr(both, key)
        assert [row[: a.size] for row in whole[: a.size]] == list(getattr(a, key))
        assert [row[a.size :] for row in whole[a.size :]] == list(getattr(b, key))
        assert not any(x for row in whole[: a.size] for x in row[a.size :])


def test_a_body_is_linked_behind_the_others() -> None:
    one = Fraction(1)
    wheel = assemble(("wheel",), (Fraction(2),), [], [(Fraction(0), {0: one})], None)
    car = linked(wheel, {"body": Fraction(3)}, [({1: one, 0: -one}, Fraction(5), Fraction(7))])
    assert (car.M, car.K, car.C) == (((2, 0), (0, 3)), ((5, -5), (-5, 5)), ((7, -7), (-7, 7)))


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
