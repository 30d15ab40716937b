"""Arguments are parsed exactly, and what cannot be names itself."""

from __future__ import annotations

import pytest

from mpsolve import Exact, InputError
from mpsolve.problem.checked import above_zero, at_least_zero, check_ascending, errors_under, parsed


def test_bounds_are_decided_exactly() -> None:
    assert above_zero("1e-300", "m", "mass") == Exact("1e-300")
    assert at_least_zero(0, "c", "damping") == Exact(0)
    with pytest.raises(InputError, match=r"m: is 0, but must be above 0: give the mass"):
        above_zero(0, "m", "mass")
    with pytest.raises(InputError, match=r"c: is -0\.1, but must not be below 0"):
        at_least_zero("-1/10", "c", "damping")


def test_one_number_or_many() -> None:
    assert parsed("0.1", "x") == (Exact("1/10"),)
    assert parsed((1, "2.5"), "x") == (Exact(1), Exact("5/2"))
    with pytest.raises(InputError) as caught:
        parsed([1, "two"], "x")
    assert caught.value.key == "x[2]"
    with pytest.raises(InputError):
        parsed({1, 2}, "x")  # a set has no order


def test_places_ascend_and_may_be_equal() -> None:
    check_ascending(parsed([0, 0, 1], "p"), "p[{j}]")
    with pytest.raises(InputError) as caught:
        check_ascending(parsed([0, 2, 1], "p"), "p[{j}]")
    assert caught.value.key == "p[3]"


def test_errors_inside_get_the_prefix_once() -> None:
    with pytest.raises(InputError) as caught, errors_under("mass[2]."):
        above_zero(-1, "M", "mass in kg")
    assert caught.value.key == "mass[2].M"
    assert str(caught.value) == "mass[2].M: is -1, but must be above 0: give the mass in kg"
