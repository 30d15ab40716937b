"""That û is analytic between the line of a path and the parabola that leaves it, which rows of cells prove."""

from __future__ import annotations

import math

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.image import BallImage, hull
from mpsolve.vibration.path import Path

_SIZE = 0.2
"""Of ω: the first try of a cell."""
_LEAST = 2.0**-16


def leftmost(path: Path, omega: float) -> float:
    """A lower bound of Re σ on the path at heights up to ω."""
    gone = arb(0).max(arb(omega).sqrt() - path.start)
    return math.nextafter(float((arb(path.alpha) - gone * path.delta).lower()), -math.inf)


def prove_strip(image: BallImage, path: Path, top: float, effort: Effort) -> int:
    """û is analytic between the line and the path up to the height `top`, which cells prove; their number.

    Each row of cells begins at the line, where the upper p-roots are known; PrecisionError where no cells prove it.
    """
    low = math.nextafter(path.start**2, 0.0)  # at or below the corner
    size, count = _SIZE * low, 0
    while low < top:
        high = low + size
        found = _row(image, path, low, high, effort)
        count += abs(found)
        if found > 0:
            low, size = high, max(1.3 * size, _LEAST)
            size = min(size, _SIZE * high)
        elif size < _LEAST * high:
            raise PrecisionError(
                "a root, or a point where p-roots meet, may lie between the cuts and the path: lower it"
            )
        else:
            size /= 2
    return count


def _row(image: BallImage, path: Path, low: float, high: float, effort: Effort) -> int:
    """The number of cells between two heights; below 0 where they do not prove it."""
    right, left, width, count = path.alpha, leftmost(path, high), high - low, 0
    point = acb(right, (low + high) / 2)
    cell = image.start(point)
    while right > left:
        next_right = max(right - width, left)
        ball = hull(acb(right, low), acb(next_right, high))
        effort.spend(1)
        count += 1
        try:
            cell = image.beside(ball, point, cell)
            image.sizes(cell)
        except PrecisionError:
            return -count
        right = next_right
        point = acb(right, (low + high) / 2)
    return count
