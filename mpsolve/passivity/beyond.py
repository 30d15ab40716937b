"""No passive vehicle has a root with Im q < 0 outside a rectangle: a theorem about track, velocity and places alone.

V = σG is proved passive (V + V* positive definite) for real q from ρ to X by pieces, beyond X by the tail theorem,
and on the walls of the rectangle |Re q| ≤ ρ, −d ≤ Im q ≤ 0; G vanishes at infinity. By Phragmén–Lindelöf V is
passive in all of Im q ≤ 0 outside the rectangle (SPEC, half-plane).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.path import Path
from mpsolve.characteristic.paths import Paths
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.arrays import Reals
from mpsolve.numbers.float64 import distinct, short
from mpsolve.passivity.decay import overtakes, vanishes
from mpsolve.passivity.far import FarNumbers, prove_tail
from mpsolve.proof.effort import Effort

_NO_TAIL = {
    True: "no passivity beyond a frequency: the contacts run faster than short waves of the track",
    False: "no passivity beyond a frequency is found: the track is damped too little for contacts so close",
}
_SHARE = 12000  # evaluations that one rectangle may take


@frozen
class Beyond:
    """The rectangle (ρ, d) in scaled units, the tail theorem, and the paths on walls and axis, still to be linked."""

    rho: float
    depth: float
    tail: FarNumbers
    walls: Path
    axis: Path


def plan_beyond(paths: Paths, effort: Effort, least: float = 0.0) -> Beyond | str:
    """The theorem with a small rectangle, of at least the half-width `least`, or the reason why there is none."""
    arrays = paths.arrays
    guide = arrays.reduced.guide
    if not vanishes(guide.D, guide.N, guide.v):
        return "the receptance is not proved to vanish at infinity"
    tail = prove_tail(guide, arrays.reduced.smallest_gap, effort)
    if tail is None:
        return _NO_TAIL[overtakes(guide, guide.v)]
    reason, passive = "", partial(_least, arrays, paths.up)
    for ratio in (1e-2, 1e-4, 1.0):
        rho = max(first_passive(passive, tail.X, ratio, 1.1), least)
        rho = short(min(rho, max(tail.X, least)))
        depth = depth_of(passive, rho, 1e-9, (0.5, 1.0, 2.0, 4.0))
        corner = complex(rho, -depth)
        axis = _axis(rho, tail.X)
        around = [axis[::-1], _line(rho, corner)[1:], _line(corner, complex(0, -depth))[1:]]
        share = effort.share(_SHARE)
        try:
            points = paths.plan("passive", np.concatenate(around), share).points
        except PrecisionError as error:
            reason = str(error)
            continue
        finally:
            effort.spend(share.spent)
        at = int(np.flatnonzero(points == axis[0])[0])  # a corner, so that it stays where pieces are joined
        walls, axis = points[at:], points[at::-1]
        return Beyond(rho, depth, tail, Path("passive", walls), Path("passive", axis))
    return f"passivity is not proved between the counted rectangle and the frequency X: {reason}"


Least = Callable[[Any], Any]
"""In floats: for points q the least eigenvalue of V + V*, relative to the size of V."""


def first_passive(least: Least, X: float, ratio: float, room: float) -> float:
    """In floats: the frequency from which on V is passive up to X, well enough that pieces are not short."""
    q = np.geomspace(X / 200, X, 160)
    open_ = np.flatnonzero(~(least(q + 0j) > ratio))
    return float(q[min(open_[-1] + 2, len(q) - 1)]) * room if len(open_) else float(q[0])


def depth_of(least: Least, rho: float, ratio: float, factors: Sequence[float]) -> float:
    """In floats: how deep the rectangle must be, in half-widths, for its walls to be passive."""
    for factor in factors:
        depth = rho * factor
        points = np.concatenate([rho - 1j * np.linspace(0, depth, 24), np.linspace(0, rho, 24) - 1j * depth])
        if (least(points) > ratio).all():
            return short(depth)
    return short(rho)


def _least(arrays: Arrays, up: int, q: Any) -> Reals:
    """Least eigenvalue of V + V* over the largest, in floats; −1 where G is not known."""
    with np.errstate(all="ignore"):
        _, G, good = arrays.evaluate(1j * q, np.zeros(len(q)), up)
    V = (1j * q)[:, None, None] * G.a
    H = (V + np.swapaxes(V.conj(), 1, 2)) / 2
    values = np.linalg.eigvalsh(np.where(good[:, None, None], H, -np.eye(H.shape[1])))
    largest = np.abs(values).max(1)
    return np.where(good & (largest > 0), values[:, 0] / np.where(largest > 0, largest, 1.0), -1.0)


def _axis(rho: float, X: float) -> Any:
    if rho >= X:
        return np.array([rho + 0j])
    count = max(2, int(4 * np.log2(X / rho)) + 2)
    return (
        distinct(np.concatenate([[rho, X], np.geomspace(rho, X, count)[1:-1].astype(np.float32).astype(float)])) + 0j
    )


def _line(a: complex, b: complex, pieces: int = 6) -> Any:
    points = a + (b - a) * np.linspace(0, 1, pieces + 1)
    points[0], points[-1] = a, b
    return points
