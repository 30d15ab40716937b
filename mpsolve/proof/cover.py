"""Covering a path by pieces that each pass a test: all open pieces are tried at once, those that fail are halved."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from mpsolve.errors import PrecisionError
from mpsolve.proof.effort import Effort

Test = Callable[[Any, Any], Any]
"""(starts, ends) → which pieces pass."""


class OpenPieceError(PrecisionError):
    """A piece passes its test at no length; `place` is its middle."""

    def __init__(self, place: complex, length: float) -> None:
        super().__init__(f"pieces of the path shorter than {length:.2g} do not pass near {place:.6g}")
        self.place = place


def halfway(a: Any, b: Any, radius: float = 0.0) -> Any:
    """The middles of pieces; that of a slanted one on the circle |q| = radius, if there is one."""
    middle = (a + b) / 2
    if not radius:
        return middle
    slanted = (a.real != b.real) & (a.imag != b.imag)
    with np.errstate(all="ignore"):
        return np.where(slanted, middle * (radius / np.abs(middle)), middle)


def cover(points: Any, test: Test, effort: Effort, smallest: float = 2.0**-40, radius: float = 0.0) -> Any:
    """The break points of a refinement of the polyline through `points` (complex) whose pieces all pass.

    radius: of the circle of which slanted pieces are arcs, 0 for none. `smallest` is relative to the length of the path. Raises OpenPieceError where halving does not help, EffortError
    where the effort is spent.
    """
    points = np.asarray(points, complex)
    a, b = points[:-1], points[1:]
    length = float(np.abs(b - a).sum())
    following: dict[complex, complex] = {}
    while len(a):
        effort.spend(len(a))
        passed = test(a, b)
        following.update(zip(a[passed].tolist(), b[passed].tolist(), strict=True))
        a, b = a[~passed], b[~passed]
        short = np.abs(b - a) < smallest * length
        if short.any():
            raise OpenPieceError(complex((a[short][0] + b[short][0]) / 2), smallest * length)
        middle = halfway(a, b, radius)
        a, b = np.concatenate([a, middle]), np.concatenate([middle, b])
    out = [complex(points[0])]
    while out[-1] in following:
        out.append(following.pop(out[-1]))
    return np.array(out)
