"""Where an endless row cannot have a growing motion: beyond a rectangle, for every z of the circle at once.

Proved for V(z, σ) = σĜ(z, σ), the mobility of the row (docs/theory/infinite-train.md has the proof):
* −Im Ĝ > 0 for real q ≥ X: the tail theorem holds for any number of contacts at this gap, so for the row;
* Re V > 0 for real q from ρ to X, and on the walls of |Re q| ≤ ρ, −depth ≤ Im q ≤ 0, for all |z| = 1, by boxes;
* every finite piece of the row is a compression of it, and its receptance vanishes at infinity: by Phragmén–Lindelöf
  it is passive outside the rectangle, and so is the row, as the limit of its pieces.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from mpsolve.characteristic.discs import split
from mpsolve.endless.boxes import Boxes, covered
from mpsolve.endless.row import Row
from mpsolve.errors import PrecisionError
from mpsolve.numbers.float64 import short
from mpsolve.passivity.beyond import depth_of, first_passive
from mpsolve.passivity.decay import vanishes
from mpsolve.passivity.far import prove_tail
from mpsolve.passivity.short_waves import overtakes
from mpsolve.proof.effort import Effort

_RATIO = 0.02  # least eigenvalue of Re V over |V| in floats, where boxes are not too small
_GRID = 64  # of z, in floats


@dataclass(frozen=True)
class Closed:
    """The rectangle (ρ, depth), the frequency X of the tail (all scaled), and how many boxes proved it."""

    rho: float
    depth: float
    X: float
    boxes: int


def close(boxes: Boxes, row: Row, effort: Effort) -> Closed:
    """The theorem for a row that moves; PrecisionError with the reason where there is none."""
    guide = row.reduced.guide
    if not vanishes(guide.D, guide.N, guide.v):
        raise PrecisionError("the receptance is not proved to vanish at infinity")
    tail = prove_tail(guide, row.gap, effort)
    if tail is None:
        fast = overtakes(guide, guide.v)
        why = "the contacts run faster than short waves of the track" if fast else "the track is damped too little"
        raise PrecisionError(f"no passivity beyond a frequency is found: {why}")
    least = partial(_least, boxes)
    rho = short(min(first_passive(least, tail.X, _RATIO, 1.05), tail.X))
    depth = depth_of(least, rho, _RATIO / 2, (0.25, 0.5, 1.0, 2.0, 4.0))
    corner = complex(rho, -depth)
    count = 0
    for start, end in ((complex(rho), complex(tail.X)), (complex(rho), corner), (corner, complex(0, -depth))):
        if start != end:
            count += covered(boxes.passive(start, end), effort)
    return Closed(rho, depth, tail.X, count)


def _least(boxes: Boxes, q: Any) -> Any:
    """In floats: for each q the least over z of the smallest eigenvalue of Re V, against the size of V."""
    z = np.exp(2j * np.pi * np.arange(_GRID) / _GRID)
    points, around = np.repeat(np.asarray(q, complex), _GRID), np.tile(z, len(q))
    zero = np.zeros(len(points))
    G, good, _ = boxes.arrays.on_arcs(split(boxes.arrays.D, 1j * points, zero, boxes.up), around, zero)
    V = (1j * points)[:, None, None] * np.where(good[:, None, None], G.a, 0)
    H = (V + np.swapaxes(V.conj(), 1, 2)) / 2
    values = np.linalg.eigvalsh(H)[:, 0] / np.maximum(np.abs(V).sum((1, 2)), 1e-300)
    return np.where(good, values, -1.0).reshape(len(q), _GRID).min(1)
