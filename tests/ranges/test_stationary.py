"""Lowest points of curves that are known in closed form."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import pytest
from flint import arb

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, precision
from mpsolve.ranges.stationary import lowest_near, proved_lowest, sharpened


@dataclass(frozen=True)
class Cubic:
    """The height x³/3 − 2x (times a sign) over x: lowest at √2."""

    sign: int = 1

    def _at(self, x: Any) -> Any:
        return acb(0, self.sign * (x**3 / 3 - 2 * x))

    def near(self, _state: Any, x: Any) -> tuple[Any, Any]:
        return (self._at(arb(x)).mid(),), (acb(0, self.sign * (arb(x) ** 2 - 2)).mid(),)

    def rise(self, rates: Any) -> Any:
        return rates[0].imag

    def enclosed(self, _state: Any, x: Any, _goal: int) -> tuple[Any, Any]:
        return (self._at(x),), self.sign * (arb(x) ** 2 - 2)

    def over(self, _state: Any, x: Any) -> Any:
        return (self._at(x),)


@pytest.mark.parametrize("goal", [60, 400, 3000])
def test_a_minimum_inside(goal: int) -> None:
    ends = arb(1), arb(3)
    found = lowest_near(Cubic(), (acb(0),), 2.7, ends, 0.1)
    assert found.where == "inside"
    lowest = sharpened(Cubic(), found, goal)
    with precision(goal + 200):
        assert lowest.x.overlaps(arb(2).sqrt())
        assert lowest.x.contains(arb(2).sqrt())
        assert lowest.x.rad() < arb(2) ** (2 - goal)
        assert lowest.state[0].imag.contains(-4 * arb(2).sqrt() / 3)


@pytest.mark.parametrize(("start", "end", "where"), [(2, 3, "start"), (0.5, 1, "end")])
def test_a_minimum_at_an_end(start: float, end: float, where: str) -> None:
    found = lowest_near(Cubic(), (acb(0),), (start + end) / 2, (arb(start), arb(end)), 0.1)
    assert found.where == where
    x = arb(start if where == "start" else end)
    ends = Fraction(start), Fraction(end)
    assert proved_lowest(Cubic(), found, ends, 100).state[0].imag.overlaps(x**3 / 3 - 2 * x)


def test_a_maximum_is_no_minimum() -> None:
    found = lowest_near(Cubic(), (acb(0),), 1.5, (arb(1), arb(3)), 0.1)
    with pytest.raises(PrecisionError):
        sharpened(Cubic(-1), found, 60)
