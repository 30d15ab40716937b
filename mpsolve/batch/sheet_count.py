"""How many roots a beam with masses has on the whole sheet, in float64: the phase of R·Δ along the edge of its cut.

Half of the boundary is enough, by symmetry, and principal values close it far out:

    n = 2 + (A₋ − [arg G₋] + A₊ − [arg G₊])/π,    G∓ = R·Δ on the lower and on the upper side.

No proof: a count is given only where every step of the phase is small after refinement, and the sum is an integer up
to rounding; else it is −1. So it is where the phase would take too many pieces of the edge.

R, the product of all differences of an upper and a lower p-root, takes away the pole of Δ at the branch point. D is
real in p; the largest real root of its resolvent pairs the p-roots by their order, and the right one of two real
roots is an upper root, seen from below the cut, exactly where vp > z.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.batch.halves import Halves, largest_real_root
from mpsolve.batch.kernel import at_roots, chunks, log_det, matrices
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


def edge_roots(halves: Halves, rows: Integers, z: Any) -> Complexes:
    """The roots P = ip seen from below the cut, upper ones first: shape (points, 4)."""
    EI, c2, k, m, v = (part[rows] for part in halves.beam)
    c2, c1, c0 = c2 / EI, 2 * m * v * z / EI, (k - m * z * z) / EI
    y = np.maximum(largest_real_root(2 * c2, c2 * c2 - 4 * c0, -c1 * c1), 0)
    s = np.sqrt(y)
    wide = np.sqrt(np.maximum((y + c2) ** 2 - 4 * c0, 0))
    beyond = wide > s  # s and h share the product c1: the larger one is the better known
    h = np.where(beyond, wide, c1 / np.where(s > 0, s, 1))
    s = np.where(beyond, c1 / np.where(wide > 0, wide, 1), s)
    a, c = _split(v, z, s / 2, -s * s / 4 - (c2 + h) / 2)
    b, e = _split(v, z, -s / 2, -s * s / 4 - (c2 - h) / 2)
    return 1j * np.stack([a, b, c, e], 1)


def _split(v: Reals, z: Any, centre: Reals, delta2: Reals) -> tuple[Any, Any]:
    """The upper and the lower one of the roots centre ± √δ²."""
    size = np.sqrt(np.abs(delta2))
    offset = np.where(delta2 < 0, 1j * size, np.where(v * (centre + size) > z, size, -size))
    return centre + offset, centre - offset


def edge_logs(halves: Halves, rows: Integers, z: Any) -> Complexes:
    """log R·Δ for the lower half and the upper one, mirrored; shape (2, points)."""
    out = np.empty((2, len(rows)), complex)
    for part in chunks(halves.group, len(rows)):
        log_R, both = _parts(halves, rows[part], z[part])
        for side, A in enumerate(both):
            out[side, part] = log_R + log_det(A)
    return out


def far_arguments(halves: Halves, rows: Integers, z: Any) -> Reals:
    """arg R·Δ at a far z, both halves together, of det B = 1 and no mass at z = 0; nan where it is not told.

    R/z² is near a negative number, Δ of each mass alone is near what a rigid end makes of it, and so is the rest.
    """
    total = np.zeros(len(rows))
    log_R, both = _parts(halves, rows, z)
    for A in both:
        total = total + _principal(-np.exp(1j * log_R.imag))
        rest = log_det(A)
        for body, contact in halves.group.direct:
            own = A[:, body, contact]
            total = total + _principal(own / -halves.group.B[rows, body, contact])
            rest = rest - np.log(own)
        total = total + _principal(np.exp(rest) * _sign(halves))
    return total


def _sign(halves: Halves) -> float:
    """Of the permutation that brings each body to its contact."""
    bodies = np.argsort([contact for _, contact in halves.group.direct])
    order = np.array([body for body, _ in halves.group.direct])[bodies]
    return float(np.linalg.det(np.eye(len(order))[order]))


def _parts(halves: Halves, rows: Integers, z: Any) -> tuple[Complexes, list[Complexes]]:
    """log R, and the characteristic matrices of both halves."""
    group, sigma = halves.group, 1j * z
    with np.errstate(all="ignore"):
        P = edge_roots(halves, rows, z)
        values = at_roots(group, rows, sigma, P)
        a, b, c, e = P.T
        log_R = np.log((a - c) * (a - e) * (b - c) * (b - e))
    return log_R, [matrices(group, rows + side * len(halves), sigma, values)[0] for side in (0, 1)]


def _principal(value: Any) -> Reals:
    with np.errstate(all="ignore"):
        return np.where(value.real > 0, np.angle(value), np.nan)
