"""How many roots the entries of a group have below a height: winding along half of a contour, closed by passivity.

    n = (A(ρ) + (n_b − n_c − n_z) π/2 − T)/π,

as in spectrum/count.py: T is the turn of Δ̂ from q = ih to ρ, A(ρ) a sum of arguments of pivots. No proof: a count is
given where every step of log Δ̂ is small, no piece is much longer than its neighbours (so that a cluster of roots
beside the line is not stepped over), the waves are resolved between the contacts, and the sum is an integer.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.batch.groups import Group
from mpsolve.batch.kernel import log_delta
from mpsolve.batch.passive import closing_argument
from mpsolve.batch.wave_sums import felt, moved_between, passes_branch
from mpsolve.numbers.arrays import Complexes, Integers, Reals, Truths

MAX_STEP = 0.5  # rad, of the argument between neighbouring points
MAX_GROWTH = 1.2  # of log |Δ̂|
MAX_BEND = 0.6  # between the steps of neighbouring pieces: two roots beside the line may cancel a step
MAX_WAVE = 2.0  # of the phase of a wave over all contacts
_BALANCE = 4.1  # of the lengths of neighbouring pieces
_FINEST = 1e-9  # piece, of ρ̂
_MOST = 20_000  # points of an entry
_FIRST = 16  # pieces
_BEND = 3.0  # of the first points: they lie denser near 0
_INTEGER = 1e-3
_BESIDE = 1e-6  # of ρ̂: where the line begins if waves meet at q = 0
_LIMIT = 0.05  # of log Δ̂ there


@dataclass(frozen=True)
class Line:
    """Points along the half contour of the entries: sorted by entry, then by t in 0 … 1.

    row: the entry of the group; q: the point, log: log Δ̂ there, z: the p-roots.
    """

    row: Any
    t: Reals
    q: Any
    log: Complexes
    z: Any

    def of(self, row: int) -> Any:
        """The points of one entry."""
        first, last = np.searchsorted(self.row, [row, row + 1])
        return slice(int(first), int(last))


@dataclass(frozen=True)
class Counted:
    """count: −1 where it is not told; then `why`, by entry of the group, says the reason."""

    count: Any
    why: dict[int, str]
    line: Line


def count_group(group: Group, rho: Reals, height: Reals) -> Counted:
    """The counts for ρ̂ and ĥ of each entry; ρ̂ must be known."""
    corners = Corners(rho, height, _BESIDE if waves_meet(group) else 0.0)
    line, lost = _refined(group, corners)
    why = dict.fromkeys(np.flatnonzero(lost).tolist(), "a root lies on the line of the count, or next to it")
    begun, wild = _beginnings(group, corners, line)
    ends = np.flatnonzero(np.diff(line.row, append=-1))
    steps = np.angle(np.exp(1j * np.diff(line.log.imag)))
    inner = line.row[1:] == line.row[:-1]
    turn = begun + np.bincount(line.row[1:][inner], steps[inner], len(group))
    order = group.bodies - group.contacts - int(group.neutral.sum())
    total = (closing_argument(group, rho) + order * np.pi / 2 - turn) / np.pi
    count = np.rint(np.nan_to_num(total, nan=-1.0)).astype(int)
    off = wild | ~(np.abs(total - count) < _INTEGER) | (count < 0) | ~np.isfinite(line.log[ends])
    why = (
        dict.fromkeys(np.flatnonzero(off).tolist(), "the turn of the characteristic function is no number of roots")
        | why
    )
    return Counted(np.where(off | lost, -1, count), why, line)


@dataclass(frozen=True)
class Corners:
    """The line from ih to ρ + ih and down to ρ, as a function of t; where waves meet at q = 0 it begins beside it."""

    rho: Reals
    height: Reals
    start: float

    def at(self, row: Any, t: Reals) -> Any:
        rho, h = self.rho[row], self.height[row]
        whole = rho + h
        along = np.minimum(np.maximum(t, np.where(h > 0, 0, self.start)) * whole, rho)
        return along + 1j * (h - np.maximum(t * whole - rho, 0))

    def bend(self, row: Any) -> Any:
        """t of the corner."""
        return self.rho[row] / (self.rho[row] + self.height[row])


def waves_meet(group: Group) -> bool:
    """Whether two waves come to p = 0 as q → 0: D has no terms of first order."""
    D = group.D
    return not (D[:, 0, : min(2, D.shape[2])].any() or (D.shape[1] > 1 and D[:, 1, 0].any()))


def _beginnings(group: Group, corners: Corners, line: Line) -> tuple[Reals, Truths]:
    """The turn from q = 0 to the first point, and where it is not told: Δ̂ must have a limit there, which is real."""
    first = np.searchsorted(line.row, np.arange(len(group)))
    angle = line.log[first].imag
    turn = angle - np.pi * np.rint(angle / np.pi)
    if not corners.start:
        return np.zeros(len(group)), np.zeros(len(group), bool)
    rows = np.arange(len(group))
    beside = log_delta(group, rows, 1j * corners.at(rows, np.full(len(group), _BESIDE * 30)))[0]
    moved = beside - line.log[first]
    wild = ~(np.abs(moved.real) < _LIMIT) | ~(np.abs(np.angle(np.exp(1j * moved.imag))) < _LIMIT)
    wild = (wild | ~(np.abs(turn) < _LIMIT)) & (corners.height == 0)
    return np.where(corners.height == 0, turn, 0.0), wild


def _first(group: Group, corners: Corners) -> Line:
    rows = np.arange(len(group))
    u = np.sinh(_BEND * np.linspace(0, 1, _FIRST + 1)) / np.sinh(_BEND)
    t = u[None, :] * corners.bend(rows)[:, None]
    if (corners.height > 0).any():
        down = np.linspace(0, 1, 5)[None, 1:]
        t = np.concatenate([t, t[:, -1:] + (1 - t[:, -1:]) * down], 1)
    q = corners.at(np.repeat(rows, t.shape[1]), t.ravel()).reshape(t.shape)
    log, z = np.empty(t.shape, complex), np.empty((*t.shape, group.D.shape[1] - 1), complex)
    for columns, before in _nested(t.shape[1]):
        each = np.repeat(rows, len(columns))
        near = None if before is None else z[:, before].reshape(len(each), -1)
        values = log_delta(group, each, 1j * q[:, columns].ravel(), near)
        log[:, columns], z[:, columns] = (
            values[0].reshape(-1, len(columns)),
            values[1].reshape(len(rows), len(columns), -1),
        )
    return Line(np.repeat(rows, t.shape[1]), t.ravel(), q.ravel(), log.ravel(), z.reshape(t.size, -1))


def _nested(size: int) -> Iterator[tuple[list[int], list[int] | None]]:
    """Columns 0 … size − 1 level by level, with those that are known and nearest before them."""
    yield [0], None
    stride = 1 << (size - 1).bit_length()
    while stride > 1:
        stride //= 2
        columns = list(range(stride, size, 2 * stride))
        if columns:
            yield columns, [column - stride for column in columns]


def _refined(group: Group, corners: Corners) -> tuple[Line, Any]:
    line = _first(group, corners)
    lost = np.zeros(len(group), bool)
    span = group.x[:, -1] - group.x[:, 0]
    nearest = np.diff(group.x).min(1, initial=np.inf)
    while True:
        coarse = _coarse(line, span, nearest, group.up)
        row = line.row[:-1]
        tiny = coarse & (np.diff(line.t) < _FINEST)
        lost[row[tiny]] = True
        lost |= np.bincount(line.row, minlength=len(group)) > _MOST
        place = np.flatnonzero(coarse & ~lost[row])
        if not len(place):
            return line, lost
        line = _halved(group, corners, line, place)


def _coarse(line: Line, span: Reals, nearest: Reals, up: int) -> Any:
    """Which pieces, from a point to the next, are too long."""
    same = line.row[1:] == line.row[:-1]
    length = np.where(same, np.diff(line.t), np.inf)
    with np.errstate(all="ignore"):
        step = np.diff(line.log)
        step = step.real + 1j * np.angle(np.exp(1j * step.imag))
        out = ~(np.abs(step.imag) < MAX_STEP) | ~(np.abs(step.real) < MAX_GROWTH)
        row = line.row[1:]
        weight = felt(line.z[1:], nearest[row], span[row])
        out |= ~(moved_between(line.z, weight) < MAX_WAVE) | passes_branch(line.z, up)
        slope = step / length
        bend = np.abs(np.diff(slope)) * (length[1:] + length[:-1]) / 2
        pairs = same[1:] & same[:-1]
        bent = pairs & ~(bend < MAX_BEND)
        out[1:] |= bent | (pairs & (length[1:] > _BALANCE * length[:-1]))
        out[:-1] |= bent | (pairs & (length[:-1] > _BALANCE * length[1:]))
    return out & same


def _halved(group: Group, corners: Corners, line: Line, place: Integers) -> Line:
    row = line.row[place]
    t = (line.t[place] + line.t[place + 1]) / 2
    q = corners.at(row, t)
    log, z = log_delta(group, row, 1j * q, line.z[place])
    at = place + 1
    return Line(
        np.insert(line.row, at, row),
        np.insert(line.t, at, t),
        np.insert(line.q, at, q),
        np.insert(line.log, at, log),
        np.insert(line.z, at, z, axis=0),
    )
