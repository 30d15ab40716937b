"""Balls are rounded outward, and all data is such as JSON knows."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from enum import Enum
from fractions import Fraction

import numpy as np
from flint import acb, arb

from mpsolve.numbers.balls import precision
from mpsolve.numbers.plain import disc_of, float_beside, outward, plain, shown_digits
from mpsolve.outcome import Reason


class Colour(Enum):
    RED = "red"


@dataclass
class Inner:
    x: object
    hidden: int = field(default=1, repr=False)


def test_floats_of_a_ball_hold_it() -> None:
    with precision(200):
        ball = arb(1) / 3
        low, high = outward(ball, up=False), outward(ball, up=True)
        assert arb(low) < ball < arb(high)
        assert high - low < 1e-15
    assert (outward(arb(0.5), up=False), outward(arb(0.5), up=True)) == (0.5, 0.5)


def test_floats_beside_an_exact_number_are_next_to_it() -> None:
    for x in (Fraction(1, 3), Fraction(-1, 3), Fraction(2, 3), Fraction(1, 10), Fraction(10**400 + 1, 10**399)):
        low, high = float_beside(x, up=False), float_beside(x, up=True)
        assert Fraction(low) < x < Fraction(high)
        assert high == np.nextafter(low, np.inf)
    assert [float_beside(Fraction(3, 4), up) for up in (False, True)] == [0.75, 0.75]


def test_data_is_plain() -> None:
    data = plain({"a": arb(2), "b": (Fraction(1, 3), None)})
    assert float(data["a"]["decimal"]) == data["a"]["lower"] == 2
    assert data["b"] == [{"exact": "1/3", "decimal": 1 / 3}, None]


def test_all_that_answers_hold_is_plain() -> None:
    given = {
        "none": None, "int": 1, "inf": float("inf"), "complex": 1 + 2j, "enum": Colour.RED, "ball": acb(1, 2),
        "open": arb(0, float("inf")), "array": np.array([[1, 2.5]]), "scalar": np.int64(3), "inner": Inner((arb(1),)),
        "reason": Reason("code", "it is open", {}, "wait"), "other": range(2),
    }  # fmt: skip
    data = json.loads(json.dumps(plain(given), allow_nan=False))
    assert (data["inf"], data["open"], data["array"], data["scalar"]) == (None, None, [[1, 2.5]], 3)
    assert (data["enum"], data["complex"], data["other"]) == ("red", {"real": 1, "imag": 2}, "range(0, 2)")
    assert float(data["ball"]["imag"]["decimal"]) == 2
    assert list(data["inner"]) == ["x"]
    assert data["reason"]["remedy"] == "wait"


def test_digits_that_are_shown_are_sure() -> None:
    assert shown_digits(arb("0.123456", "1e-4")).startswith("0.123")
    assert not shown_digits(arb("0.123456", "1e-4")).startswith("0.123456")


def test_a_disc_in_floats_holds_the_ball() -> None:
    ball = acb(arb(1) / 3, arb(-2) / 7) + acb(arb(0, 1e-20), arb(0, 1e-5))
    middle, radius = disc_of(ball)
    assert (ball - acb(middle.real, middle.imag)).abs_upper() <= radius < 1.1e-5
