"""The path of integration: up the line Re σ = α, then along a parabola that leaves it to the left, across the cuts.

σ(r) = α − δ(r − r₀) + ir² for r ≥ r₀: there p-roots that are waves keep |Im p| bounded, and e^{σt} falls.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.image import BallImage, hull

_SIZE = 0.2
"""Of ω: the first try of a cell."""
_LEAST = 2.0**-16


@dataclass(frozen=True)
class Path:
    """α, r₀ and δ > 0, exact floats, scaled."""

    alpha: float
    start: float
    delta: float

    @property
    def corner(self) -> Any:
        """Where it leaves the line."""
        return self.lifted(arb(self.start))

    def line(self, omega: Any) -> Any:
        """The point of the line at the height ω."""
        return acb(self.alpha) + acb(0, 1) * omega

    def lifted(self, r: Any) -> Any:
        """σ(r), of a real or complex r."""
        return acb(self.alpha) - (r - self.start) * self.delta + acb(0, 1) * r * r

    def slope(self, r: Any) -> Any:
        """σ'(r)."""
        return acb(-self.delta) + acb(0, 2) * r

    def left(self, omega: float) -> float:
        """A lower bound of Re σ on the path at heights up to ω."""
        gone = arb(0).max(arb(omega).sqrt() - self.start)
        return math.nextafter(float((arb(self.alpha) - gone * self.delta).lower()), -math.inf)


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
    right, left, width, count = path.alpha, path.left(high), high - low, 0
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
