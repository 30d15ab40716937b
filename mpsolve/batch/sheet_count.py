"""How many roots a beam with masses has on the whole sheet, in float64: the phase of R·Δ along the edge of its cut.

Half of the boundary is enough, by symmetry, and principal values close it far out:

    n = 2 + (A₋ − [arg G₋] + A₊ − [arg G₊])/π,    G∓ = R·Δ on the lower and on the upper side.

No proof: a count is given only where every step of the phase is small after refinement, and the sum is an integer up
to rounding; else it is −1. So it is where the phase would take too many pieces of the edge.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.batch.cut_edge import edge_logs, far_arguments
from mpsolve.batch.halves import Halves
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths

MAX_STEP = 0.6  # rad, of the phase between neighbouring nodes
MAX_GROWTH = 1.0  # of log |G|, beside (1 + z)³
MAX_BEND = 0.3  # rad, between the steps of neighbouring first pieces
NODES = 32
_SCALE = 0.1  # of √(z − limit) to its far end: nodes are uniform below it and geometric above
_START = 1e-6  # of √(z − limit)
_FINEST = 1e-7  # piece, the least of all
_LEVELS = 40  # of halving
_PIECES = 4096  # of an entry, made by halving
_MANY = 1 << 17  # pieces at a time, which bounds the memory
_INTEGER = 1e-3


@dataclass(frozen=True)
class Edge:
    """log G∓ on the nodes t, shape (2, entries, nodes), and the counts: −1 where the phase is not resolved."""

    t: Reals
    log: Complexes
    count: Any


@dataclass(frozen=True)
class _Pieces:
    """Pieces of edges: the entry each belongs to, its ends t, and log G∓ there, shape (2, pieces)."""

    which: Integers
    start: Any
    stop: Reals
    first: Complexes
    last: Complexes

    def __getitem__(self, keep: Any) -> _Pieces:
        return _Pieces(self.which[keep], self.start[keep], self.stop[keep], self.first[:, keep], self.last[:, keep])


def count_sheet(halves: Halves, nodes: int = NODES) -> Edge:
    """The number of roots of Δ on the whole sheet, first on so many nodes."""
    limit, rows = halves.limit, np.arange(len(halves))
    t = _nodes(halves, nodes)
    z = place(limit[:, None], t)
    log = edge_logs(halves, np.repeat(rows, nodes), z.ravel()).reshape(2, *t.shape)
    turn = _turning(halves, t, log)
    # the two sides meet at the branch point, or z = 0 lies inside the cut and each closes in itself
    closing = np.where(limit > 0, turned(-(log[0, :, 0] + log[1, :, 0]).imag), 0.0)
    total = 2 + (far_arguments(halves, rows, z[:, -1]) - turn + closing) / np.pi
    total = total - ((limit == 0) & (halves.height == 0))  # the cuts touch: a quarter of a turn on each side
    total = np.where(np.abs(closing) < MAX_STEP, total, np.nan)
    count = np.rint(np.nan_to_num(total, nan=-1.0))
    sound = (np.abs(total - count) < _INTEGER) & (count >= 0)
    return Edge(t, log, np.where(sound, count, -1).astype(int))


def _nodes(halves: Halves, nodes: int) -> Any:
    """t with z = |limit| + t|t|, smooth about the branch point: from z = max(limit, 0) to the far end."""
    branch = np.abs(halves.limit)
    reach = np.sqrt(halves.far - branch)
    scale = _SCALE * reach
    low = np.where(halves.limit >= 0, _START, -np.sqrt(branch))
    u = np.linspace(np.arcsinh(low / scale), np.arcsinh(reach / scale), nodes, axis=1)
    t = scale[:, None] * np.sinh(u)
    t[:, 0] = low
    return t


def place(limit: Reals, t: Reals) -> Reals:
    """z of the nodes."""
    return np.maximum(np.abs(limit) + t * np.abs(t), 0)


def turned(angle: Reals) -> Any:
    """An angle, or the difference of two, to −π … π."""
    return np.angle(np.exp(1j * angle))


def _turning(halves: Halves, t: Reals, log: Complexes) -> Reals:
    """[arg G₋] + [arg G₊] along the nodes, pieces halved until every step is small; nan where that fails.

    Depth first, so that the pieces in hand stay few however many are made.
    """
    shape = (len(t), t.shape[1] - 1)
    which = np.broadcast_to(np.arange(len(t))[:, None], shape).ravel()
    first, last = (part.reshape(2, -1) for part in (log[:, :, :-1], log[:, :, 1:]))
    waiting = [(0, _Pieces(which, t[:, :-1].ravel(), t[:, 1:].ravel(), first, last))]
    turn, made = np.zeros(len(t)), np.zeros(len(t), int)
    while waiting:
        level, pieces = waiting.pop()
        limit = halves.limit[pieces.which]
        move = pieces.last - pieces.first
        steps = turned(move.imag)
        leap = move.real - 3 * np.log((1 + place(limit, pieces.stop)) / (1 + place(limit, pieces.start)))
        done = ((np.abs(steps) < MAX_STEP) & (np.abs(leap) < MAX_GROWTH)).all(axis=0)
        if not level:
            done &= ~_bent(steps, shape)
        turn += np.bincount(pieces.which[done], steps.sum(axis=0)[done], len(turn))
        pieces = pieces[~done]
        made += np.bincount(pieces.which, minlength=len(made))
        turn[made > _PIECES] = np.nan
        turn[pieces.which[(pieces.stop - pieces.start < _FINEST) | (level == _LEVELS)]] = np.nan
        pieces = pieces[np.isfinite(turn[pieces.which])]
        for k in range(0, len(pieces.which), _MANY):
            waiting.append((level + 1, _halved(halves, pieces[k : k + _MANY])))
    return turn


def _bent(steps: Reals, shape: tuple[int, int]) -> Truths:
    """Pieces next to which a step is quite another: two roots beside the edge may cancel a step."""
    bend = (np.abs(np.diff(steps.reshape(2, *shape), axis=2)) > MAX_BEND).any(0)
    out = np.zeros(shape, bool)
    out[:, 1:] |= bend
    out[:, :-1] |= bend
    return out.ravel()


def _halved(halves: Halves, pieces: _Pieces) -> _Pieces:
    middle = (pieces.start + pieces.stop) / 2
    value = edge_logs(halves, pieces.which, place(halves.limit[pieces.which], middle))
    return _Pieces(
        np.concatenate([pieces.which, pieces.which]),
        np.concatenate([pieces.start, middle]),
        np.concatenate([middle, pieces.stop]),
        np.concatenate([pieces.first, value], axis=1),
        np.concatenate([value, pieces.last], axis=1),
    )
