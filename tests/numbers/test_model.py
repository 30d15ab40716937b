"""A model describes its parameters once: values are exact, bounds hold, and every mistake names its key."""

from __future__ import annotations

import pickle
from fractions import Fraction
from typing import Annotated, Any

import numpy as np
import pytest

from mpsolve.errors import InputError
from mpsolve.numbers.model import (
    Entries,
    Model,
    Part,
    Quantity,
    Rational,
    Texts,
    checked_range,
    defaults,
    nonnegative,
    positive,
    quantities,
    rational,
    real,
    whole,
)


class Wheel(Model, frozen=True):
    """For tests."""

    mass: Annotated[Rational, positive("kg", "mass")]
    c: Annotated[Rational, nonnegative("N s/m", "damping")] = Fraction(0)
    force: Annotated[Rational | None, Quantity("N", "force", optional=True)] = None


class Rig(Model, frozen=True):
    """For tests."""

    wheel: Annotated[Wheel, Part("", "wheel", kind=Wheel)]
    shift: Annotated[Rational, real("", "shift")]
    rows: Annotated[Any, Entries("m", "table", depth=2)] = ()
    names: Annotated[Any, Texts("", "names", optional=True)] = None

    def check(self) -> None:
        if len(self.rows) > 2:
            raise InputError("rows", "is too long: give two rows")


def test_values_are_exact_and_in_order() -> None:
    wheel = Wheel("0.1", 2.5)
    assert wheel.parameters == {"mass": Fraction(1, 10), "c": Fraction(5, 2)}
    assert Wheel("1/3", force=-2).parameters == {"mass": Fraction(1, 3), "c": 0, "force": -2}
    rig = Rig(wheel, -1, [["1/2", 3], (4, "0.5")], names=["a", "b"])
    assert rig.rows == ((Fraction(1, 2), 3), (4, Fraction(1, 2)))
    assert list(rig.parameters) == ["wheel", "shift", "rows", "names"]
    assert pickle.loads(pickle.dumps(rig)) == rig
    assert hash(rig) == hash(Rig(wheel, -1, [["1/2", 3], (4, "0.5")], names=("a", "b")))


def test_a_model_cannot_be_changed() -> None:
    with pytest.raises(AttributeError):
        Wheel(1).mass = 2  # type: ignore[misc]


def test_the_description() -> None:
    assert list(quantities(Wheel)) == ["mass", "c", "force"]
    assert [quantity.bound for quantity in quantities(Wheel).values()] == ["above 0", "at least 0", ""]
    assert [quantity.told for quantity in quantities(Rig).values()] == ["wheel", "shift", "table in m", "names"]
    assert defaults(Wheel) == {"c": 0, "force": None}


@pytest.mark.parametrize(
    ("make", "key", "said"),
    [
        (lambda: Wheel(0), "mass", "is 0, but must be above 0: give the mass in kg"),
        (lambda: Wheel(1, -1), "c", "must not be below 0"),
        (lambda: Wheel("one"), "mass", "not a number"),
        (lambda: Wheel(True), "mass", "not a number"),
        (lambda: Wheel(None), "mass", "not a number"),
        (lambda: Wheel("root4(2)"), "mass", "irrational"),
        (lambda: Rig(3, 1), "wheel", "of type int: give a Wheel"),
        (lambda: Rig(Wheel(1), 1, 5), "rows", "list of rows"),
        (lambda: Rig(Wheel(1), 1, [5]), r"rows[1]", "list of numbers"),
        (lambda: Rig(Wheel(1), 1, [[1], [2, "x"]]), r"rows[2][2]", "not a number"),
        (lambda: Rig(Wheel(1), 1, ["12"]), r"rows[1]", "list of numbers"),
        (lambda: Rig(Wheel(1), 1, [[1]] * 3), "rows", "too long"),
        (lambda: Rig(Wheel(1), 1, names="ab"), "names", "list of texts"),
        (lambda: Rig(Wheel(1), 1, names=["a", 5]), r"names[2]", "no text"),
        (lambda: rational("nan", "v"), "v", "not finite"),
    ],
)
def test_mistakes_are_named(make: Any, key: str, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        make()
    assert caught.value.key == key


def test_ends_are_exact() -> None:
    low, high = checked_range(("0.1", Fraction(1, 3)), "alpha")
    assert (low, high) == (Fraction(1, 10), Fraction(1, 3))


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (3, "alpha: is 3: give a range"),
        ((1, 2, 3), r"alpha: is \(1, 2, 3\): give a range"),
        ((0, "root4(2)"), r"alpha: is 1\.18921, which is irrational: give a decimal or a ratio"),
        ((1, 1), "alpha: ends at 1, not above its start 1"),
        ((2, 1), "alpha: ends at 1, not above its start 2"),
    ],
)
def test_what_is_no_range_is_refused(given: object, said: str) -> None:
    with pytest.raises(InputError, match=f"^{said}"):
        checked_range(given, "alpha")


@pytest.mark.parametrize("value", [1, 7, np.int64(3)])
def test_a_whole_number_within_its_bounds(value: object) -> None:
    found = whole(value, "count", 1, 7)
    assert (found, type(found)) == (value, int)


@pytest.mark.parametrize("value", [0, 8, True, 2.0, "3", None])
def test_what_is_no_whole_number_or_out_of_bounds(value: object) -> None:
    with pytest.raises(InputError, match=r"count: is .*: give a whole number from 1 to 7"):
        whole(value, "count", 1, 7)
