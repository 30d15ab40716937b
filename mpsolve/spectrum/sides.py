"""The turn of Δ̂ along straight sides, from a splitting that is known far below the real axis."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.path import Proved
from mpsolve.characteristic.paths import Paths
from mpsolve.numbers.arrays import Complexes
from mpsolve.proof.effort import Effort
from mpsolve.proof.winding import number_of_zeros

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


def descent(depth: float, h: float) -> Complexes:
    """From −i·depth, where a splitting is known, along the imaginary axis to i h."""
    down = -1j * depth * np.array([1, 0.75, 0.5, 0.3, 0.2, 0.1, 0.05, 0.02])
    up = [0j, complex(0, h)] if h else [0j]
    return np.concatenate([down.astype(np.complex64).astype(complex), up])


def down_at(rho: float, h: float) -> Complexes:
    """From i h to ρ + i h and down to ρ."""
    corner = complex(rho, h)
    line = side(complex(0, h), corner, 24)
    return np.concatenate([line, side(corner, rho + 0j, 4)[1:]]) if h else line


def whole_turn(proved: Proved) -> arb:
    """The change of arg Δ̂ along all paths that turn."""
    return sum((arb(value, error) for value, error in proved.turns), arb(0))


def zeros(turns: arb) -> int:
    """How many zeros so many turns go round; PrecisionError where that is open."""
    return number_of_zeros(turns, "the characteristic function")
