"""What is checked before a march, and how a motion is read between its steps."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from track_models import DAMPED

from mpsolve import InputError, Load, Problem, vehicles
from mpsolve.finite.case import Case

PROBLEM = Problem(DAMPED["two-layer"], [vehicles.Mass(900), vehicles.Mass(900).at(3)], v=10)


def _case(**changed: Any) -> Case:
    given = {"loads": None, "length": 60, "times": [0.01, 0.1], "places": None, "start": None, "tolerance": 1e-3}
    return Case(PROBLEM, **(given | changed))


def test_without_a_start_the_load_runs_through_the_middle() -> None:
    case = _case()
    assert case.origin == pytest.approx((60 - 3 - 1) / 2)
    assert case.duration == 0.1
    assert _case(loads=[Load(1, 1, 9000)] * 2).first_steps == 900


def test_times_at_equal_distances_are_ends_of_steps() -> None:
    """Nothing is interpolated there; a little later a wave that turns many times in a step is read less well."""
    times = np.linspace(0, 0.1, 26)[1:]

    def off(shift: float) -> Any:
        case = _case(times=times + shift)
        return np.abs(case.solve(200, 25).rail - case.solve(200, 3200).rail).max()

    assert _case(times=times[2:]).first_steps == 25
    assert _case(times=[0.1 / np.pi, 0.1]).first_steps == 16
    assert off(7.5e-4) > 4 * off(0)


@pytest.mark.parametrize(
    ("key", "changed"),
    [
        ("length", {"length": 3}),
        ("start", {"start": -1}),
        ("times", {"times": [0.2, 0.1]}),
        ("tolerance", {"tolerance": 2}),
        ("unilateral", {"unilateral": True}),
        ("loads", {"loads": [Load(1)]}),
    ],
)
def test_what_cannot_be_is_named(key: str, changed: dict[str, Any]) -> None:
    with pytest.raises(InputError) as error:
        _case(**changed)
    assert error.value.key == key


def test_more_times_read_the_same_motion() -> None:
    """At common times the answers are one, to the error of reading between steps."""
    few, many = (_case(times=np.linspace(0.02, 0.1, n)) for n in (3, 9))
    one, other = (case.solve(200, 800) for case in (few, many))
    assert one.rail[:, few.asked] == pytest.approx(other.rail[:, many.asked[::4]], rel=1e-12)
    assert one.force[:, few.asked] == pytest.approx(other.force[:, many.asked[::4]], rel=1e-9)


def test_few_times_are_watched_with_some_before_the_last() -> None:
    case = _case(times=[0.01, 0.06, 0.1])
    assert case.watched[case.asked] == pytest.approx(case.times)
    assert len(case.watched) == 11
    assert np.array_equal(_case(times=np.linspace(0, 1, 16)).watched, np.linspace(0, 1, 16))
