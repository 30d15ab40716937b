"""All zeros are found, also where candidates lack; candidates by AAA are near the truth."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from flint import acb
from functions import function

from mpsolve.numbers.rootball import RootBall
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.zeros import find
from mpsolve.zeros.count import count_zeros
from mpsolve.zeros.enclose import enclose
from mpsolve.zeros.find import corners_of, find_zeros
from mpsolve.zeros.regions import Rectangle

BOX = Rectangle("-10.1", "10.2", "-1.3", "1.4")


def found(text: str, digits: int = 15) -> list[RootBall]:
    f = function(text)
    return find_zeros(f, count_zeros(f, BOX.polygon, (), Effort()), digits, Effort(evaluations=100_000), silent)


def test_the_zeros_of_the_sine() -> None:
    middles = sorted(complex(ball.q).real for ball in found("sin(z)"))
    assert middles == pytest.approx([k * np.pi for k in range(-3, 4)], abs=1e-14)


def test_halves_find_what_the_candidates_miss(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(find, "_MANY", 2)
    assert sum(ball.multiplicity for ball in found("sin(z) + 0.1*exp(z/9)")) == 7


def test_a_grid_finds_them_without_any_candidates(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(find, "poles_by_aaa", lambda *_: np.zeros(0, complex))
    monkeypatch.setattr(find, "_DEEPEST", 4)
    assert sum(ball.multiplicity for ball in found("z**3 - 2*z + exp(z/5)/9")) == 3


def test_corners_are_exact() -> None:
    ball = enclose(function("z**2 - 2"), 1.4, 2.0, 20)[0]
    low, high = corners_of(ball)
    assert low[0] < Fraction(14142135623730950488, 10**19) < high[0]
    assert ball.q.overlaps(acb(2).sqrt())
