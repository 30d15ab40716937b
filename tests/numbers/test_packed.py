"""Packed balls come back exactly."""

from __future__ import annotations

import copy
import pickle
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from flint import acb, arb

from mpsolve.numbers.balls import precision
from mpsolve.numbers.packed import Portable, dyadic, exact_ends, pack, unpack


def test_balls_travel_exactly() -> None:
    with precision(400):
        balls = [arb.pi(), arb(0), arb("0.1") * arb(10) ** 40, -arb(2).sqrt() + arb(0, arb(2) ** -300)]
    for ball in balls:
        same = unpack(pack(ball))
        assert same.mid().man_exp() == ball.mid().man_exp()
        assert same.rad() >= ball.rad()
        assert same.rad() <= ball.rad() * arb("1.000001")


@dataclass(frozen=True)
class Held(Portable):
    """What results look like: balls in tuples and dictionaries, beside other values."""

    q: Any
    parts: tuple[Any, ...]
    named: dict[str, Any]
    text: str = "x"


def test_what_holds_balls_can_be_pickled_and_copied() -> None:
    with precision(300):
        held = Held(acb(arb.pi(), -arb(2).sqrt()), (arb(3).log(), 5, None), {"a": acb(1, arb(2).sqrt())})
    for same in (pickle.loads(pickle.dumps(held)), copy.deepcopy(held)):
        assert type(same) is Held
        assert same.q.contains(held.q)
        assert same.q.real.mid().man_exp() == held.q.real.mid().man_exp()
        assert same.parts[0].contains(held.parts[0])
        assert same.parts[0].rel_accuracy_bits() >= 290
        assert same.parts[1:] == (5, None)
        assert same.named["a"].contains(held.named["a"])
        assert same.text == "x"


def test_arrays_of_balls_travel_and_infinite_ones_stay_so() -> None:
    made = Held(0, (np.array([[arb("0.1", "1e-9")], [arb("nan")], [acb(1, arb(0, "inf"))]], object),), {})
    again, given = pickle.loads(pickle.dumps(made)).parts[0], made.parts[0]
    assert again.shape == (3, 1)
    assert again[0, 0].contains(given[0, 0])
    assert not again[1, 0].is_finite()
    assert again[1, 0].contains(arb(10) ** 1000)
    assert again[2, 0].real == 1
    assert not again[2, 0].imag.is_finite()


def test_the_ends_of_a_ball_are_exact() -> None:
    ball = arb(7, arb(2) ** -80) / 4
    assert dyadic(ball.mid()) == Fraction(7, 4)
    low, high = exact_ends(ball)
    assert Fraction(7, 4) - low == high - Fraction(7, 4) == dyadic(ball.rad()) >= Fraction(2) ** -82
