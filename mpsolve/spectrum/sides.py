"""The turn of Δ̂ along straight sides, from a splitting that is known far below the real axis."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.path import Proved
from mpsolve.characteristic.paths import Paths
from mpsolve.proof.effort import Effort
from mpsolve.proof.turning import number_of_zeros

_PIECES = 12  # of a side, with which halving begins


def along_sides(paths: Paths, corners: list[complex], effort: Effort) -> Proved:
    """The turn from corner to corner; the first lies below the axis, or off all cuts on the way there."""
    around = np.concatenate([side(x, y, _PIECES)[:-1] for x, y in pairwise(corners)] + [corners[-1:]])
    link = side(complex(0, -paths.start.depth), corners[0], _PIECES)
    return paths.prove((paths.plan("link", link, effort), paths.plan("turn", around, effort)), effort)


def side(a: complex, b: complex, pieces: int) -> Any:
    """Points from a to b, no two the same."""
    points = a + (b - a) * np.linspace(0, 1, pieces + 1)
    points[0], points[-1] = a, b
    return points[np.concatenate([[True], points[1:] != points[:-1]])]


def whole_turn(proved: Proved) -> arb:
    """The change of arg Δ̂ along all paths that turn."""
    return sum((arb(value, error) for value, error in proved.turns), arb(0))


def zeros(turns: arb) -> int:
    """How many zeros so many turns go round; PrecisionError where that is open."""
    return number_of_zeros(turns, "the characteristic function")
