"""What is left out is listed, put in and taken out again; what comes only together is put in together."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import InputError, Problem, tracks, vehicles
from mpsolve.problem.left_out import left_out, put_in

RAIL = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
BARE = {"wheel": 1500, "frame": 3000, "inertia": 155, "wheelbase": "2.5", "k": "4.8e6", "c": 250}
BOGIE = vehicles.Bogie(**BARE)
COACH = vehicles.Coach(body=20000, inertia="1e6", bogie=BOGIE, pivots=18, k2="5e5")


def test_each_optional_number_is_listed_with_its_meaning() -> None:
    found = left_out(Problem(RAIL, [vehicles.Mass(900).at(9), BOGIE.at(0)], v=10))
    assert {path: quantity.without for path, quantity in found.items()} == {
        "vehicles[0].k_contact": "rigid contact",
        "vehicles[0].body": "no body",
    }
    assert "vehicles[0].bogie.k_contact" in left_out(Problem(RAIL, COACH, v=10))


def test_each_optional_number_of_any_model_says_what_it_means_to_leave_it_out() -> None:
    from mpsolve.numbers.model import Quantity, quantities

    numbers = [
        quantity
        for model in (*tracks.CATALOGUE, *vehicles.CATALOGUE)
        for quantity in quantities(model).values()
        if type(quantity) is Quantity and quantity.optional
    ]
    assert len(numbers) >= 4
    assert all(quantity.without for quantity in numbers)


def test_what_is_put_in_is_the_model_with_it_and_comes_out_again() -> None:
    before = Problem(RAIL, [BOGIE.at(0), COACH.at(30)], v=10)
    values = {"vehicles[0].body": "5 t", "vehicles[0].k2": "1e6", "vehicles[1].bogie.k_contact": "1e9 N/m", "v": 20}
    after = put_in(before, values)
    inner = vehicles.Bogie(**BARE, k_contact="1e9")
    coach = vehicles.Coach(body=20000, inertia="1e6", bogie=inner, pivots=18, k2="5e5")
    assert after == Problem(RAIL, [vehicles.Bogie(**BARE, body=5000, k2="1e6").at(0), coach.at(30)], v=20)
    out = {"vehicles[0].body": None, "vehicles[0].k2": 0, "vehicles[1].bogie.k_contact": None, "v": 10}
    assert put_in(after, out) == before


def test_as_changed_where_nothing_is_left_out() -> None:
    before = Problem(RAIL, [BOGIE.at(30), BOGIE.at(0)], v=10)
    for path in ("track.k", "vehicles[1].wheel", "gap[0]", "v"):
        value = before.parameters[path] + Fraction(1, 7)
        assert put_in(before, {path: value}).parameters == before.changed(path, value).parameters


@pytest.mark.parametrize(
    ("values", "key"),
    [
        ({"vehicles[0].body": 5000}, "vehicles[0].k2"),
        ({"vehicles[0].k2": 5000}, "vehicles[0].body"),
        ({"vehicles[0].wheel": None}, "vehicles[0].wheel"),
        ({"vehicles[0].k_contact": 0}, "vehicles[0].k_contact"),
        ({"vehicles[0].nothing": 1}, "vehicles[0].nothing"),
        ({"v": None}, "v"),
    ],
)
def test_what_cannot_be_is_named(values: dict[str, object], key: str) -> None:
    with pytest.raises(InputError) as caught:
        put_in(Problem(RAIL, BOGIE, v=10), values)
    assert caught.value.key == key
