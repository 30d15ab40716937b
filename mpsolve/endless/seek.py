"""Where something begins to hold along a grid of velocities: in floats, without proof."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np

_HALVINGS = 18  # of the grid
_STEPS, _CLOSE = 40, 1e-13  # of the rule of false position


def threshold_of(grid: list[Fraction], factor: Callable[[Fraction], float]) -> float | None:
    """In floats: where the factor comes to 1 for the first time on the grid, by the rule of false position."""
    before: tuple[Fraction, float] | None = None
    for x in grid:
        f = factor(x) - 1
        if f > 0:
            return float(x) if before is None else _sharpened(before, (x, f), factor)
        before = (x, f)
    return None


def _sharpened(
    low: tuple[Fraction, float], high: tuple[Fraction, float], factor: Callable[[Fraction], float]
) -> float:
    (a, fa), (b, fb) = ((float(x), f) for x, f in (low, high))
    for k in range(_STEPS):
        if b - a <= _CLOSE * b:
            break
        x = (a + b) / 2 if k % 3 == 2 else b - fb * (b - a) / (fb - fa)
        f = factor(Fraction(x)) - 1
        if abs(f) < _CLOSE:
            return x
        a, fa, b, fb = (a, fa, x, f) if f > 0 else (x, f, b, fb)
    return (a + b) / 2


def first_where(grid: list[Fraction], test: Callable[[Fraction], bool]) -> float | None:
    """Where the test begins to hold, to some nine digits, if it holds at a point of the grid and not at the first."""
    at = next((k for k, x in enumerate(grid) if test(x)), None)
    if at is None:
        return None
    if at == 0:
        return float(grid[0])
    low, high = grid[at - 1], grid[at]
    for _ in range(_HALVINGS):
        middle = Fraction(float((low + high) / 2))
        low, high = (low, middle) if test(middle) else (middle, high)
    return float(np.float64((low + high) / 2))
