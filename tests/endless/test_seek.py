"""The first place along a grid, to many digits; None where there is none."""

from __future__ import annotations

from fractions import Fraction
from math import sqrt

from mpsolve.endless.seek import first_where, threshold_of

GRID = [Fraction(k, 10) for k in range(31)]


def test_a_factor_comes_to_one() -> None:
    asked: list[Fraction] = []

    def factor(x: Fraction) -> float:
        asked.append(x)
        return float(x) ** 3 / 5

    found = threshold_of(GRID, factor)
    assert found is not None
    assert abs(found - 5 ** (1 / 3)) < 1e-12
    assert len(asked) < 18 + 20
    assert threshold_of(GRID[:10], factor) is None
    assert threshold_of(GRID[20:], factor) == 2.0


def test_a_kink_is_no_obstacle() -> None:
    found = threshold_of(GRID, lambda x: max(0.5, 1 + 40 * (float(x) - sqrt(2))))
    assert found is not None
    assert abs(found - sqrt(2)) < 1e-12


def test_a_statement_begins_to_hold() -> None:
    found = first_where(GRID, lambda x: x * x > 2)
    assert found is not None
    assert abs(found - sqrt(2)) < 1e-6
    assert first_where(GRID, lambda x: x > 5) is None
    assert first_where(GRID, lambda _: True) == 0.0
