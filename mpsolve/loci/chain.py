"""Roots followed along a parameter: chains of tubes, each of which begins where the one before it ends.

Two tubes that follow each other hold the same root: a disc that holds the root of the first at the common x̂ lies in
the disc of the second there, which holds one root only.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.loci.room import BELOW, Room
from mpsolve.loci.tube import Tubes, tubes
from mpsolve.numbers.arrays import Complexes, Integers, Reals
from mpsolve.proof.effort import Effort

_LENGTHS = (4.0, 2.0, 1.0, 0.5)  # of the last step: what is tried side by side
_SIZES = (1.0, 0.25, 2.0**-4, 2.0**-7)  # of the radius that is tried first
_FIRST = 2.0**-6  # of the range: the first step
_SHORTEST = 2.0**-26  # of the range
_LEAN = 2.0  # how much wider than the way of the root a box is, at least


@dataclass
class Chain:
    """A root that is followed in the direction `way` (±1): it lies within `radius` of q; `tubes` in their order.

    That holds at x̂ = x, or before the first tube at some x̂ between x and `ahead`. on_axis: it is imaginary, and no
    tube is taken in which it could leave the axis. kind: of its last tube, or of its beginning (see `Room`). end: why
    it ended ("range", "stuck", or what the caller said), None while it goes on.
    """

    x: float
    q: complex
    radius: float
    way: int
    ahead: float | None = None
    on_axis: bool = False
    kind: int = BELOW
    tubes: list[Tubes] = field(default_factory=list)
    end: Any = None
    step: float = 0.0
    size: float = 0.25
    speed: complex = 0j


Stop = Callable[[Chain], Any]
"""What is asked after each new tube: a reason to end the chain, or None."""


def follow(
    matrix: FreeMatrix, chains: list[Chain], room: Room, effort: Effort, stop: Stop, tell: Callable[[float], None]
) -> None:
    """Let each chain grow until it ends. `EffortError` where the effort is spent: the chains are kept as they are."""
    for chain in chains:
        chain.step = chain.step or _FIRST * room.width
    while active := [chain for chain in chains if chain.end is None]:
        effort.spend(len(active) * len(_LENGTHS) * len(_SIZES))
        tell(sum(chain.x * chain.way for chain in active) / len(active))
        _advance(matrix, active, room, stop)


def _advance(matrix: FreeMatrix, active: list[Chain], room: Room, stop: Stop) -> None:
    """One tube for each chain: the longest of those that are tried side by side and proved."""
    tried, each, kinds = _candidates(active, room)
    if not len(each):
        for chain in active:
            _shorter(chain, room)
        return
    found = tubes(matrix, *tried)
    linked = _linked(found, active, each)
    with np.errstate(all="ignore"):
        share = 1 - 2.0**-8 * found.inner / found.outer  # of two of one length the sharper one
    length = np.where(linked, (found.high - found.low) * share, 0.0)
    taken = []
    for k, chain in enumerate(active):
        rows = np.flatnonzero((each == k) & (length > 0))
        if len(rows):
            best = rows[length[rows].argmax()]
            chain.kind = int(kinds[best])
            tube = replace(found.take(slice(best, best + 1)), kind=kinds[best : best + 1])
            taken.append((chain, tube, tried[3][best]))
        else:
            _shorter(chain, room)
    if taken:
        _taken(matrix, taken, room, stop)


def _shorter(chain: Chain, room: Room) -> None:
    chain.step, chain.size = chain.step * 0.125, chain.size * 0.25
    if chain.step < _SHORTEST * room.width:
        chain.end = "stuck"


def _linked(found: Tubes, active: list[Chain], each: Integers) -> Any:
    """Which tubes hold the root of their chain."""
    q, radius = (np.array([getattr(chain, name) for chain in active])[each] for name in ("q", "radius"))
    x: Any = np.array([chain.x for chain in active])[each]
    ahead = np.array([chain.x if chain.ahead is None else chain.ahead for chain in active])[each]
    on_axis = np.array([chain.on_axis for chain in active])[each]
    known = (ahead >= found.low) & (ahead <= found.high)
    return found.holds(q, radius, x) & found.holds(q, radius, ahead) & known & (found.mirrored | ~on_axis)


def _candidates(active: list[Chain], room: Room) -> tuple[tuple[Reals, Reals, Complexes, Reals], Integers, Integers]:
    """((low, high, middle, ρ) of the boxes, the number of the chain of each, their kinds)."""
    rows, each, kinds = [], [], []
    for k, chain in enumerate(active):
        reached = (chain.x + chain.way * chain.step * share for share in _LENGTHS)
        for x in dict.fromkeys(min(max(x, room.low), room.high) for x in reached):
            half, ends = (x - chain.x) / 2, (min(x, chain.x), max(x, chain.x))
            for share in _SIZES:
                rho = _LEAN * abs(chain.speed * half) + chain.size * share * max(abs(chain.q), 0.01)
                placed = room.placed(chain.q + chain.speed * half, rho, ends, chain.kind, not chain.tubes)
                if placed is not None:
                    rows.append((*ends, placed[0], rho))
                    each.append(k)
                    kinds.append(placed[1])
    columns = [np.array(column) for column in zip(*rows, strict=True)] if rows else [np.zeros(0)] * 4
    return (columns[0], columns[1], columns[2].astype(complex), columns[3]), np.array(each), np.array(kinds)


def _taken(matrix: FreeMatrix, taken: list[tuple[Chain, Tubes, float]], room: Room, stop: Stop) -> None:
    """Moves the chains to the ends of their new tubes, where the roots are enclosed more sharply."""
    ahead = [int(chain.way > 0) for chain, _, _ in taken]
    x = np.array([(tube.high if up else tube.low)[0] for up, (_, tube, _) in zip(ahead, taken, strict=True)])
    near = np.array([tube.near[up][0] for up, (_, tube, _) in zip(ahead, taken, strict=True)])
    centre = np.array([tube.centre(at)[0] for at, (_, tube, _) in zip(x, taken, strict=True)])
    radius = np.array([tube.inner[0] for _, tube, _ in taken])
    near = np.array(
        [room.kept(q, chain.kind, (y, y)) for q, y, (chain, *_) in zip(near.tolist(), x.tolist(), taken, strict=True)]
    )
    whole = (np.abs(near - centre) + radius) * 1.01
    point = tubes(matrix, x, x, near, whole)
    fits = [
        room.fits(q, rho, (y, y), chain.kind)
        for q, rho, y, (chain, *_) in zip(near.tolist(), whole.tolist(), x.tolist(), taken, strict=True)
    ]
    inside = point.holds(centre, radius, x) & (point.inner < radius) & fits
    for k, (chain, tube, rho) in enumerate(taken):
        chain.step = float(tube.high[0] - tube.low[0])
        chain.size = min(float(rho - _LEAN * abs(chain.speed) * chain.step / 2) / max(abs(chain.q), 0.01) * 4, 1.0)
        chain.x, chain.speed = float(x[k]), complex(tube.speed[ahead[k]][0])
        chain.q, chain.radius = complex(centre[k]), float(radius[k])
        if inside[k]:
            chain.q, chain.radius = complex(point.middle[k]), float(point.inner[k])
        chain.tubes.append(tube)
        chain.ahead = None
        if chain.on_axis:
            chain.q, chain.speed = complex(0, chain.q.imag), complex(0, chain.speed.imag)
        chain.end = stop(chain)
        if chain.end is None and (chain.x >= room.high if chain.way > 0 else chain.x <= room.low):
            chain.end = "range"
