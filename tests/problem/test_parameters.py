"""Parameters by path: listed, changed one at a time, refused with the list."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve import Problem, tracks, vehicles
from mpsolve.errors import InputError

BOGIE = vehicles.Bogie(wheel=1500, frame=3000, inertia=155, wheelbase="2.5", k="4.8e6", c=250)
COACH = vehicles.Coach(body=20000, inertia="1e6", bogie=BOGIE, pivots=18, k2="5e5")
RAIL = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)


def problem() -> Problem:
    return Problem(RAIL, [COACH.at(40), vehicles.Mass(900).at(3), COACH.at(0)], v=100)


def test_every_parameter_is_listed_with_its_value() -> None:
    values = problem().parameters
    assert values["v"] == 100
    assert values["track.k"] == 10**6
    assert values["vehicles[0].bogie.wheel"] == values["vehicles[2].bogie.wheel"] == 1500
    assert values["vehicles[1].M"] == 900
    assert (values["gap[0]"], values["gap[1]"]) == (3, 37)
    assert "vehicles.M" not in values
    assert Problem(RAIL, [COACH.at(0), COACH.at(25)], v=1).parameters["vehicles.bogie.k"] == 4_800_000


@given(st.data())
def test_one_change_changes_that_parameter_and_nothing_else(data: st.DataObject) -> None:
    before = problem()
    own = [p for p in before.parameters if not p.startswith(("scale", "vehicles.")) and "bogie.k2" not in p]
    path = data.draw(st.sampled_from([p for p in own if "bogie.c2" not in p]))  # a bogie in a coach has no k2, c2
    value = before.parameters[path] + Fraction(1, 7)
    after = before.changed(path, value)
    assert after.parameters == before.parameters | {path: value}


def test_factors_scale_all_masses_and_all_gaps_and_leave_bodies_rigid() -> None:
    heavy = problem().changed("scale.mass", "3/2")
    expected = [[x * Fraction(3, 2) for x in row] for row in problem().pencil.M]
    assert [list(row) for row in heavy.pencil.M] == expected
    assert (heavy.pencil.K, heavy.pencil.places) == (problem().pencil.K, problem().pencil.places)
    wide = problem().changed("scale.gap", 2)
    assert (wide.parameters["gap[0]"], wide.parameters["gap[1]"]) == (6, 74)
    assert wide.parameters["vehicles[0].bogie.wheelbase"] == Fraction(5, 2)


def test_all_vehicles_at_once() -> None:
    both = Problem(RAIL, [vehicles.Mass(1).at(0), vehicles.Mass(2).at(5)], v=1).changed("vehicles.M", 7)
    assert both.parameters["vehicles.M"] == 7


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        ("track.kk", 1, "did you mean track.k"),
        ("track.K", 1, "did you mean track.k"),
        ("V", 1, "did you mean v"),
        ("speed", 1, "the parameters are v, "),
        ("gap[2]", 1, "did you mean gap"),
        ("gap[0]", -1, "must be above 0"),
        ("scale.mass", 0, "must be above 0"),
        ("vehicles[1].M", -900, "must be above 0"),
        ("vehicles.M", 1, "is unknown"),
        ("v", "fast", "fast"),
    ],
)
def test_what_cannot_be_is_told_under_its_path(path: str, value: object, said: str) -> None:
    with pytest.raises(InputError, match="(?s)" + said.replace("[", r"\[")) as caught:
        problem().changed(path, value)
    assert caught.value.key == path


def test_what_is_no_number_is_told_with_what_there_is() -> None:
    matrices = vehicles.Vehicle(M=[[1]], C=[[0]], K=[[0]], B=[[1]], places=[0])
    for vehicle, path, said in (
        (matrices, "vehicles[0].M", "scale.mass is a factor of all masses"),
        (vehicles.Oscillator(wheel=1, body=1, k=1), "vehicles.k_contact", "these are wheel, body, k, c"),
    ):
        with pytest.raises(InputError, match=f"is no single number .*: {said}"):
            Problem(RAIL, vehicle, v=1).changed(path, 2)
