"""A simple root of an analytic function in its ball: isolated, on a line of symmetry where it has one, and sharpened.

A box that is symmetric to a line on which roots come in mirrored pairs, and holds one root, holds it on the line.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from flint import acb

from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import arb, precision
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid
from mpsolve.proof.newton import Analytic, Isolated, isolated, sharpened

_GUARD = 24
_NEAR = 2.0**-30


@frozen
class Line:
    """A line that mirrors roots onto roots: the symmetry that is then known of q, and z ↦ the nearest point of it."""

    symmetry: Symmetry
    onto: Callable[[Any], Any]

    def is_near(self, z: acb, size: Any) -> bool:
        """Whether the exact z is so near that a root on the line is likely."""
        return bool(abs(z - self.onto(z)) < arb(_NEAR) * size)


@frozen
class Enclosed:
    """The box that holds one root and its image; the line on which the root is proved to lie, or None."""

    found: Isolated
    line: Line | None

    @property
    def symmetry(self) -> Symmetry:
        return Symmetry.NONE if self.line is None else self.line.symmetry


def enclosed(f: Analytic, start: Any, size: Any, lines: Sequence[Line]) -> Enclosed:
    """A box round the exact `start`, on the first of the lines near to it on which one is proved, else off them.

    size: what half-widths are relative to. `PrecisionError` where none is proved.
    """
    for line in lines:
        if line.is_near(start, size):
            try:
                found = isolated(f, line.onto(start).mid(), size)
            except PrecisionError:
                continue
            return Enclosed(Isolated(found.box, line.onto(found.image)), line)
    return Enclosed(isolated(f, start, size), None)


def root_ball(
    f: Analytic,
    root: Enclosed,
    digits: int,
    in_units: Callable[[Any], Any] = lambda z: z,
    multiplicity: int = 1,
    least: float = 0.0,
) -> RootBall:
    """The root in a ball of relative radius below 10^−digits, after the exact map `in_units` of z to q.

    least: a size below which a root counts as one of this size. `PrecisionError` where it cannot be sharpened so far.
    """
    goal = math.ceil(digits * math.log2(10)) + 1
    onto = None if root.line is None else root.line.onto
    image = sharpened(f, root.found.image, goal + _GUARD, onto, arb(least))
    with precision(goal + 3 * _GUARD):
        ball = on_grid(in_units(image), goal, multiplicity, root.symmetry, least)
        if not (in_units(root.found.box).contains(ball.q) and ball.q.contains(in_units(image))):
            raise PrecisionError(f"the root near {image.str(6)} could not be sharpened to {digits} digits")
    return ball
