"""A path in the q-plane and what its pieces stand for: straight ones, arcs of a circle, discs that hold either.

Points are complex floats q̂ (scaled); σ̂ = i q̂.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.jets import UP, U
from mpsolve.proof.cover import Middle, midpoints

Kind = Literal["link", "turn", "passive"]
_WIDER = 1 + 2.0**-12  # of a disc, against half of its piece
_OFF_ARC = 2.0**-14  # of a piece's length: how far from the circle the points of an arc may lie


@frozen
class Path:
    """Break points in order, and what is proved between them.

    arc: the radius of the circle round 0 along which the last part of the path runs, from that point of the real axis
    on: there points lie on the circle, and discs hold the circle's arcs too. None: all pieces are straight.
    """

    kind: Kind
    points: Complexes
    arc: float | None = None

    @property
    def pieces(self) -> int:
        return len(self.points) - 1


@frozen
class Proved:
    """Paths whose pieces all passed; for each the change of arg Δ̂ and a bound of its error (0 unless it turns).

    corners: G between the places (middle, radius) at the last point of each path.
    """

    paths: tuple[Path, ...]
    turns: tuple[tuple[float, float], ...]
    corners: tuple[tuple[Any, Any], ...]

    @property
    def pieces(self) -> int:
        return sum(path.pieces for path in self.paths)


def discs(a: Any, b: Any) -> tuple[Complexes, Reals]:
    """Midpoints and radii in σ̂ of discs that hold the pieces from a to b, and any whose ends are rounded to a and b.

    They are wider than need be by 2⁻¹².
    """
    m = (a + b) / 2
    r = np.maximum(np.abs(a - m), np.abs(b - m)) * _WIDER * UP + 4 * U * (np.abs(a) + np.abs(b))
    return 1j * m, r


def between(arc: float | None) -> Middle:
    """Where pieces are halved: in the middle, on an arc at the middle of the arc."""

    def on_circle(a: Any, b: Any) -> Any:
        m = (a + b) / 2
        with np.errstate(all="ignore"):
            moved = m * (arc / np.abs(m)) if arc else m
        return np.where(_curved(a, b, arc), moved, m)

    return midpoints if arc is None else on_circle


def _curved(a: Any, b: Any, arc: float | None) -> Any:
    """Which pieces from a to b stand for an arc of the circle: those that run below the real axis."""
    return (np.minimum(a.imag, b.imag) < 0) & (arc is not None)


def on_arc(path: Path) -> Any:
    """True for straight pieces, and for those whose disc is proved to hold their arc of the circle |q̂| = arc.

    Let both ends be within η = 2⁻¹³ c of the circle, 2c their distance. The arc between the nearest points of the
    circle is shorter than a half circle, so it lies in the disc that has those points as a diameter; the disc of the
    piece holds that one, as its middle is within η of the other middle and c(1 + 2⁻¹²) ≥ (c + η) + η.
    """
    a, b = path.points[:-1], path.points[1:]
    if path.arc is None:
        return np.ones(len(a), bool)
    off = np.maximum(np.abs(np.abs(a) - path.arc), np.abs(np.abs(b) - path.arc)) + 8 * U * path.arc
    near = (off <= _OFF_ARC * (1 - 8 * U) * np.abs(b - a)) & (np.abs(b - a) < path.arc)
    return near | ~_curved(a, b, path.arc)


def check_chain(paths: tuple[Path, ...], depth: float, reached: tuple[complex, ...] = ()) -> None:
    """Every path begins where an earlier one ends, the first at −i depth, or at a reached point; ValueError else."""
    ends = [complex(0, -depth), *reached]
    for path in paths:
        if complex(path.points[0]) not in ends:
            raise ValueError("a path begins where no earlier one ends")
        ends.append(complex(path.points[-1]))
