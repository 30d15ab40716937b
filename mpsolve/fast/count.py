"""How many induced frequencies each of many cases has: float64 winding numbers of R·Δ along the edge of the cut.

As in sheet/winding.py, half of the sheet's boundary is enough, and the far arc is closed by principal values:

    n = 2 + (A₊ − [arg G₊] + A₋ − [arg G₋])/π.

Float64, hence no proof: a count is given only where every step of the phase is small after refinement, and the sum
is an integer up to rounding; else it is −1. So it is where the phase would take too many pieces of the edge, as
for 10⁴ half waves between the masses, or a parameter far out of any use.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from mpsolve.fast.cases import Cases
from mpsolve.fast.edge import edge_roots, edge_values

MAX_STEP = 0.6  # rad, of the phase between neighbouring nodes
MAX_GROWTH = 1.0  # of log |G|, beside (1 + r)³
NODES = 48
_SCALE = 0.1  # of √(r − q_lm) to its far end: nodes are uniform below it and geometric above
_START = 1e-6  # of √(r − q_lm)
_FINEST = 1e-7  # piece, the least of all
_LEVELS = 40  # of halving
_PIECES = 4096  # of a case, made by halving
_MANY = 1 << 17  # pieces at a time, which bounds the memory
_BLOCK = 256  # cases at a time: their arrays stay in the processor's cache
_PART = 8192  # cases that are refined together: enough to make few calls, few enough for memory


@dataclass(frozen=True)
class Edge:
    """G± on the nodes t, each of shape (cases, nodes), and the counts: −1 where the phase is not resolved."""

    t: Any
    plus: Any
    minus: Any
    count: Any

    def __getitem__(self, index: Any) -> Edge:
        return Edge(self.t[index], self.plus[index], self.minus[index], self.count[index])


@dataclass(frozen=True)
class _Pieces:
    """Pieces of edges: the case each belongs to, its ends t, and G± there, shape (2, pieces)."""

    which: Any
    start: Any
    stop: Any
    first: Any
    last: Any

    def __getitem__(self, keep: Any) -> _Pieces:
        return _Pieces(self.which[keep], self.start[keep], self.stop[keep], self.first[:, keep], self.last[:, keep])


def count_roots(cases: Cases, nodes: int = NODES) -> Edge:
    """Counts the roots of Δ on the whole sheet, first on so many nodes; `cases` is one-dimensional."""
    size = max(1, _PART * NODES // nodes)
    parts = [_counted(cases[k : k + size], nodes) for k in range(0, max(len(cases), 1), size)]
    return Edge(*(np.concatenate([getattr(part, f.name) for part in parts]) for f in fields(Edge)))


def _counted(cases: Cases, nodes: int) -> Edge:
    blocks = [cases[k : k + _BLOCK] for k in range(0, max(len(cases), 1), _BLOCK)]
    t = _nodes(cases, nodes)
    r = _place(cases.limit[:, None], t)
    values = [edge_values(block[:, None], r[k * _BLOCK : (k + 1) * _BLOCK]) for k, block in enumerate(blocks)]
    G = np.stack([np.concatenate(side) for side in zip(*values, strict=True)])
    turn = _turning(cases, t, G)
    # the two sides meet at the branch point, or r = 0 lies inside the cut and each closes in itself
    closing = np.where(cases.limit > 0, np.angle(G[1, :, 0].conj() / G[0, :, 0]), 0.0)
    total = 2 + (_far_arguments(cases, r[:, -1], G[:, :, -1]) - turn + closing) / np.pi
    total = total - (cases.limit == 0) * (
        cases.eta_b == 0
    )  # the cuts touch: G± ~ ir, a quarter of a turn on each side
    total = np.where(np.abs(closing) < MAX_STEP, total, np.nan)
    count = np.rint(np.nan_to_num(total, nan=-1.0))
    sound = np.abs(total - count) < 1e-3
    return Edge(t, G[0], G[1], np.where(sound, count, -1).astype(int))


def far_end(cases: Cases) -> Any:
    """An r from where on the far field rules: 3 for slow loads far apart, more as 1/d² or α²."""
    w = np.maximum(2.5 / cases.d, 4.0 * np.sqrt(np.maximum(1.0, np.abs(cases.axial) + cases.alpha**2)))
    return w * w / 2


def _nodes(cases: Cases, nodes: int) -> Any:
    """t with r = |q_lm| + t|t|, smooth about the branch point: from r = max(q_lm, 0) to the far end."""
    branch = np.abs(cases.limit)
    reach = np.sqrt(far_end(cases) - branch)
    scale = _SCALE * reach
    low = np.where(cases.limit >= 0, _START, -np.sqrt(branch))
    u = np.linspace(np.arcsinh(low / scale), np.arcsinh(reach / scale), nodes, axis=1)
    t = scale[:, None] * np.sinh(u)
    t[:, 0] = low
    return t


def _place(limit: Any, t: Any) -> Any:
    return np.maximum(np.abs(limit) + t * np.abs(t), 0)


def _turning(cases: Cases, t: Any, G: Any) -> Any:
    """[arg G₊] + [arg G₋] along the nodes, pieces halved until every step is small; nan where that fails.

    Depth first, so that the pieces in hand stay few however many are made.
    """
    shape = (len(t), t.shape[1] - 1)
    which = np.broadcast_to(np.arange(len(t))[:, None], shape).ravel()
    first, last = (part.reshape(2, -1) for part in (G[:, :, :-1], G[:, :, 1:]))
    waiting = [(0, _Pieces(which, t[:, :-1].ravel(), t[:, 1:].ravel(), first, last))]
    turn, made = np.zeros(len(t)), np.zeros(len(t), int)
    while waiting:
        level, pieces = waiting.pop()
        limit = cases.limit[pieces.which]
        steps = np.angle(pieces.last / pieces.first)
        growth = 3 * np.log((1 + _place(limit, pieces.stop)) / (1 + _place(limit, pieces.start)))
        leap = np.log(np.abs(pieces.last / pieces.first)) - growth
        done = ((np.abs(steps) < MAX_STEP) & (np.abs(leap) < MAX_GROWTH)).all(axis=0)
        turn += np.bincount(pieces.which[done], steps.sum(axis=0)[done], len(turn))
        pieces = pieces[~done]
        made += np.bincount(pieces.which, minlength=len(made))
        turn[made > _PIECES] = np.nan
        turn[pieces.which[(pieces.stop - pieces.start < _FINEST) | (level == _LEVELS)]] = np.nan
        pieces = pieces[np.isfinite(turn[pieces.which])]
        for k in range(0, len(pieces.which), _MANY):
            waiting.append((level + 1, _halved(cases, pieces[k : k + _MANY])))
    return turn


def _halved(cases: Cases, pieces: _Pieces) -> _Pieces:
    middle = (pieces.start + pieces.stop) / 2
    some = cases[pieces.which]
    value = np.stack(edge_values(some, _place(some.limit, middle)))
    return _Pieces(
        np.concatenate([pieces.which, pieces.which]),
        np.concatenate([pieces.start, middle]),
        np.concatenate([middle, pieces.stop]),
        np.concatenate([pieces.first, value], axis=1),
        np.concatenate([value, pieces.last], axis=1),
    )


def _far_arguments(cases: Cases, r: Any, G: Any) -> Any:
    """A₊ + A₋ (sheet/winding.py); nan where a factor leaves its half-plane, so that no principal value holds."""
    roots = edge_roots(cases, r)
    R = roots.R
    contact = -4j * np.pi * (roots.a + roots.b) / R
    total = np.zeros(len(r))
    for sign, value in zip((1, -1), G, strict=True):
        kappa = 2 * (r + sign * 1j * cases.eta_b) ** 2 / np.pi
        first, second = 1 - kappa * cases.eta_1 * contact, 1 - kappa * cases.eta_2 * contact
        for factor in (-R / r**2, first, second, value / R / (first * second)):
            total = np.where(factor.real > 0, total + np.angle(factor), np.nan)
    return total
