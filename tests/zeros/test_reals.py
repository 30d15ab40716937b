"""Tiles of an interval: every zero in one of them, none elsewhere; multiple zeros and cuts refused by name."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
from flint import arb
from functions import function

from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.proof.effort import Effort
from mpsolve.zeros.reals import OpenTileError, bracket, tile

F = Fraction


@pytest.mark.parametrize(
    ("text", "a", "b", "zeros"),
    [("sin(z)", -10, 10, 7), ("exp(z) + 0*z", -5, 5, 0), ("z**3 - z", -1, 1, 3), ("sin(z)", 0, 10, 4),
     ("log(z)", 1, 3, 1), ("sin(z*z)", 1, 6, 11), ("cosh(z) - 1.0000001", -1, 1, 2)],
)  # fmt: skip
def test_zeros_are_counted(text: str, a: int, b: int, zeros: int) -> None:
    tiles = tile(function(text), 1, F(a), F(b), Effort(evaluations=5000))
    assert tiles.kinds.count("1") == zeros
    assert tiles.places[0] == a
    assert tiles.places[-1] == b
    assert all(x < y for x, y in pairwise(tiles.places))


@pytest.mark.parametrize(("text", "place"), [("1 - cos(z)", 0.0), ("sqrt(z)", 0.0), ("z*sin(z) + 0*z - 0", None)])
def test_zeros_that_meet_and_what_is_not_smooth_are_refused(text: str, place: float | None) -> None:
    if place is None:
        assert tile(function(text).parts[0][0], 1, F(-1), F(2), Effort()).kinds.count("1") == 1
        return
    with pytest.raises(OpenTileError) as found:
        tile(function(text), 1, F(-1), F(2), Effort(evaluations=50_000))
    assert found.value.place <= place + 1e-6
    assert isinstance(found.value, PrecisionError)


def test_effort_ends_it() -> None:
    with pytest.raises(EffortError):
        tile(function("sin(z*z)"), 1, F(1), F(100), Effort(evaluations=20))


def test_a_bracket_is_narrow_and_holds_the_zero() -> None:
    f = function("z**2 - 2")
    with precision(200):
        low, high = bracket(f, F(1), F(2), arb(2).sqrt() + arb(0, 1e-30))
        assert low**2 < 2 < high**2
        assert high - low < F(1, 10**25)
        assert bracket(f, F(1), F(2), arb(1.8, 1e-9)) == (1, 2)
        assert bracket(function("z - 1"), F(1), F(2), arb(1, 1e-9)) == (1, 1)
