"""Whether any motion of an endless row grows, at one velocity: a proof, for all Bloch numbers at once.

Beyond a rectangle it cannot have a growing motion, for any z of the circle. Proved for V(z, σ) = σĜ(z, σ), the
mobility of the row (docs/theory/infinite-train.md has the proof):
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
from flint import arb

from mpsolve.characteristic.discs import split
from mpsolve.characteristic.origin import waves_meet_at_zero
from mpsolve.characteristic.paths import Paths
from mpsolve.characteristic.start import start
from mpsolve.endless.boxes import Boxes, LatticeArrays, covered
from mpsolve.endless.row import Row
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.float64 import short
from mpsolve.passivity.beyond import depth_of, first_passive
from mpsolve.passivity.decay import overtakes, vanishes
from mpsolve.passivity.far import prove_tail
from mpsolve.proof.effort import Effort
from mpsolve.proof.winding import number_of_zeros
from mpsolve.spectrum.closing import closing_argument
from mpsolve.spectrum.premises import open_at_rest, require_premises
from mpsolve.spectrum.reasons import WavesMeetError
from mpsolve.spectrum.regions import HalfPlane


@dataclass(frozen=True)
class Count:
    """The proved number of growing motions for every real κ alike.

    closed: the rectangle that holds them; None where nothing moves. boxes: how many boxes (q, κ) hold no root on the
    real axis.
    """

    growing: int
    closed: Closed | None
    boxes: int


def count_growing(row: Row, effort: Effort) -> Count:
    """The number of roots with Im q < 0 for each real κ, the same for all of them, counted with multiplicity.

    PrecisionError where that is not so, or not proved: with a root on the real axis for some κ the number changes.
    InputError where a premise fails, as for `certify`.
    """
    reduced = row.reduced
    require_premises(reduced, HalfPlane())
    if waves_meet_at_zero(reduced.guide):
        raise WavesMeetError
    if len(reduced.places) < reduced.contacts:
        raise PrecisionError("two contacts of a vehicle are at one place, which the theorem about rows leaves out")
    at_rest = open_at_rest(reduced, certified=False)
    if at_rest:
        raise PrecisionError(at_rest)
    if not reduced.guide.v:
        return Count(0, None, 0)
    first = start(reduced.guide)
    arrays = LatticeArrays.of(row)
    boxes = Boxes(arrays, first.up)
    closed = close(boxes, row, effort)
    count = covered(boxes.regular(0j, complex(closed.rho)), effort)
    return Count(_in_step(Paths(arrays, first), closed.rho, effort), closed, count)


def _in_step(paths: Paths, rho: float, effort: Effort) -> int:
    """The number for z = 1, where all vehicles move alike: by the turn of Δ̂(1, ·) from 0 to ρ (SPEC, half-plane)."""
    reduced = paths.arrays.reduced
    down = -1j * paths.start.depth * np.array([1, 0.75, 0.5, 0.3, 0.2, 0.1, 0.05, 0.02, 0.0])
    along = np.linspace(0, rho, 25) + 0j
    chain = (paths.plan("link", down, effort), paths.plan("turn", along, effort))
    proved = paths.prove(chain, effort)
    with precision(64):
        turn = sum((arb(value, error) for value, error in proved.turns), arb(0))
        order = reduced.bodies - reduced.contacts - reduced.neutral
        total = (closing_argument(reduced, rho, *proved.corners[1]) + order * arb.pi() / 2 - turn) / arb.pi()
        return number_of_zeros(total, "the characteristic function")


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
    for here, there in ((complex(rho), complex(tail.X)), (complex(rho), corner), (corner, complex(0, -depth))):
        if here != there:
            count += covered(boxes.passive(here, there), effort)
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
