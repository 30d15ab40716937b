"""Where the counted roots of a group are: Newton's method from neighbours, from the line of the count, from a grid.

Newton's step is −1/tr(A⁻¹A′), found roots and their mirrors −q̄ divided out. Nothing is proved: an entry is solved
when as many roots are found as were counted.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from mpsolve.batch.count import Counted
from mpsolve.batch.groups import Group
from mpsolve.batch.kernel import log_slope
from mpsolve.numbers.arrays import Complexes, Integers, Reals

SAME = 1e-7  # relative distance of two approximations to one root
_STEPS = 40
_SETTLED = 1e-11
_AXIS = 1e-9  # relative: a root this near the imaginary axis is on it
_LEVEL = 1e-13  # of ρ̂: a root nearer to the edge of the region is not told to be in it or out
_WORK = 1 << 15  # starts at a time: it bounds the memory
_MORE = (2, 6)  # points than roots: some go to roots that are not counted
_EFFORT = 300_000  # starts, times the square of the size of the matrix: beyond it a search is not tried
_GRID = (12, 10)
_TRIALS = (
    ("from_line", 1),
    ("from_axis", 1),
    ("from_line", 3),
    ("from_grid", 1),
    ("from_line", 10),
    ("from_grid", 3),
)
"""Where starts come from, and how many of them."""


@dataclass
class Search:
    """q: the distinct roots with Re q ≥ 0 found so far, shape (entries, columns), nan beyond them (scaled)."""

    group: Group
    counted: Counted
    rho: Reals
    height: Reals
    q: Any = field(init=False)

    def __post_init__(self) -> None:
        width = max(1, int(self.counted.count.max(initial=0)))
        self.q = np.full((len(self.group), width), np.nan, complex)

    @property
    def _size(self) -> int:
        return len(self.group.border[0].kept) + self.group.contacts

    def solve(self) -> Any:
        """Whether each entry has as many roots as were counted; neighbours among the entries should be alike."""
        n = len(self.group)
        rows = np.arange(n)
        stride = 1 << max(n - 1, 0).bit_length()
        self._alone(rows[::stride])
        while stride > 1:
            stride //= 2
            places = rows[stride :: 2 * stride]
            for there in (places - stride, places + stride):
                some = self._open(places)
                known = there[some] < n
                self._try(places[some][known], self.q[there[some][known]], apart=False)
            self._alone(places)
        self._alone(rows)
        return weight(self.q) == self.counted.count

    def _alone(self, places: Integers) -> None:
        """Without neighbours: all roots at once, then those that are missing from the line, the axis and grids."""
        for more in _MORE:
            places = places[self._open(places)]
            if not len(places):
                return
            self._together(places, more)
        for guesses, fine in _TRIALS:
            places = places[self._open(places)]
            if not len(places):
                return
            starts = getattr(self, guesses)(places, fine)
            if starts.shape[1] * self._size**2 <= _EFFORT:
                self._try(places, starts, apart=True)

    def _together(self, places: Integers, more: int) -> None:
        """Aberth's method for as many points as roots are missing, and some more: all move, and keep apart."""
        lack = -(-(self.counted.count[places] - weight(self.q[places])) // 2) + more
        size = max(1, _WORK // (8 * int(lack.max())))
        for k in range(0, len(places), size):
            rows, number = places[k : k + size], lack[k : k + size]
            width = int(number.max())
            starts = np.concatenate([self.from_line(rows, 1), self.from_axis(rows, 1)], 1)
            order = np.argsort(~np.isfinite(starts), 1, kind="stable")
            q = np.take_along_axis(starts, order, 1)[:, :width]
            spread = 0.02 * self.rho[rows, None] * np.exp(2j * np.pi * np.arange(width) / width)[None, :]
            q = np.where(np.arange(width)[None, :] < number[:, None], q + spread, np.nan)
            self._add(rows, self._aberth(rows, q))

    def _aberth(self, rows: Integers, q: Any) -> Any:
        result, z = np.full(q.shape, np.nan, complex), None
        live = np.isfinite(q)
        for _ in range(_STEPS):
            each, column = np.nonzero(live)
            if not len(each):
                break
            at = q[each, column]
            slope, z = log_slope(self.group, rows[each], at, z)
            with np.errstate(all="ignore"):
                others = 1 / (at[:, None] - q[each]) + 1 / (at[:, None] + q[each].conj())
                others[np.arange(len(at)), column] = 0
                step = -1 / (slope - np.nansum(others, 1) - poles(at, self.q[rows[each]]))
                size, limit = np.abs(step), 0.2 * self.rho[rows[each]]
                step = np.where(size > limit, step * (limit / size), step)
            at = at + step
            at = np.where(at.real < 0, -at.conj(), at)
            settled = size < _SETTLED * np.abs(at)
            inside = np.isfinite(at) & self._inside(rows[each], at, 0.3)
            q[each, column] = np.where(inside, at, np.nan)
            good = settled & self._inside(rows[each], at, 0.0)
            result[each[good], column[good]] = at[good]
            keep = ~settled & inside
            live[each, column], z = keep, z[keep]
        return self._folded(result)

    def _open(self, places: Integers) -> Any:
        return weight(self.q[places]) < self.counted.count[places]

    def from_line(self, places: Integers, fine: int) -> Complexes:
        """One Newton step from between the points of the line, with difference quotients."""
        most = 6 * fine + 2 * fine * int(self.counted.count[places].max(initial=0))
        out = np.full((len(places), most), np.nan, complex)
        line = self.counted.line
        for k, row in enumerate(places.tolist()):
            part = line.of(row)
            q, log = line.q[part], line.log[part]
            step = np.diff(log)
            step = step.real + 1j * np.angle(np.exp(1j * step.imag))
            with np.errstate(all="ignore"):
                move = -np.diff(q) / step
            guess = (q[1:] + q[:-1]) / 2 + move
            best = np.argsort(np.where(np.isfinite(move), np.abs(move), np.inf))[: most * 4]
            best = best[self._inside(np.full(len(best), row), guess[best], 0.2)][:most]
            out[k, : len(best)] = guess[best]
        return out

    def from_axis(self, places: Integers, fine: int) -> Any:
        """The imaginary axis below 0, where a root may stand alone."""
        return -1j * self.rho[places, None] * np.geomspace(1e-4, 1, 9 * fine)[None, :]

    def from_grid(self, places: Integers, fine: int) -> Complexes:
        x = (np.linspace(0, 1, _GRID[0] * fine + 1)[1:] ** 1.5)[:, None]
        grid = x - 1j * np.geomspace(1e-3, 1, _GRID[1] * fine)[None, :]
        return self.rho[places, None] * grid.ravel()[None, :] + 1j * self.height[places, None] * 0.5

    def _inside(self, rows: Integers, q: Any, slack: float) -> Any:
        """Whether the points lie in the counted region, or next to it."""
        room = slack * self.rho[rows]
        low = q.imag < -_LEVEL * self.rho[rows] + room
        strip = (q.imag < self.height[rows] + room) & (np.abs(q.real) < self.rho[rows] + room)
        return low | (strip & (self.height[rows] > 0))

    def _try(self, places: Integers, guesses: Complexes, apart: bool) -> None:
        if not guesses.size:
            return
        size = max(1, _WORK // guesses.shape[1])
        for k in range(0, len(places), size):
            rows = places[k : k + size]
            each = np.repeat(rows, guesses.shape[1])
            new = self._newton(each, guesses[k : k + size].ravel(), apart)
            self._add(rows, new.reshape(len(rows), -1))

    def _add(self, rows: Integers, new: Complexes) -> None:
        q = np.concatenate([self.q[rows], new], 1)
        found = np.full((len(rows), self.q.shape[1]), np.nan, complex)
        index = np.arange(len(rows))
        for k in range(found.shape[1]):
            first = np.isfinite(q).argmax(1)
            root = found[:, k] = q[index, first]
            with np.errstate(invalid="ignore"):
                q[np.abs(q - root[:, None]) < SAME * np.abs(root[:, None])] = np.nan
            if not np.isfinite(q).any():
                break
        self.q[rows] = found

    def _newton(self, rows: Integers, q: Any, apart: bool) -> Any:
        """The roots in the region that the starts lead to, folded into Re q ≥ 0; nan where they lead nowhere."""
        result = np.full(q.shape, np.nan, complex)
        place = np.flatnonzero(np.isfinite(q))
        rows, q = rows[place], q[place]
        z = None
        for _ in range(_STEPS if apart else _STEPS // 3):
            if not len(place):
                break
            step, z = self._step(rows, q, z, apart)
            size = np.abs(step)
            limit = 0.2 * self.rho[rows]
            with np.errstate(all="ignore"):
                step = np.where(size > limit, step * (limit / size), step)
            q = q + step
            settled = size < _SETTLED * np.abs(q)
            arrived = settled & self._inside(rows, q, 0.0)
            result[place[arrived]] = q[arrived]
            keep = ~settled & np.isfinite(q) & self._inside(rows, q, 0.3)
            place, rows, q, z = place[keep], rows[keep], q[keep], z[keep]
        return self._folded(result)

    def _folded(self, q: Any) -> Any:
        with np.errstate(invalid="ignore"):
            q = np.where(q.real < 0, -q.conj(), q)
            return np.where(np.abs(q.real) < _AXIS * np.abs(q), 1j * q.imag, q)

    def _step(self, rows: Integers, q: Any, near: Complexes | None, apart: bool) -> tuple[Complexes, Complexes]:
        slope, z = log_slope(self.group, rows, q, near)
        if apart:
            slope = slope - poles(q, self.q[rows])
        with np.errstate(all="ignore"):
            return -1 / slope, z


def poles(q: Any, known: Any) -> Any:
    """Σ 1/(q − k) over the known roots k and their mirrors."""
    with np.errstate(all="ignore"):
        terms = 1 / (q[:, None] - known) + np.where(known.real == 0, 0, 1 / (q[:, None] + known.conj()))
    return np.nansum(terms, 1)


def weight(q: Any) -> Any:
    """How many roots each row stands for: a root off the imaginary axis has its mirror."""
    return (np.isfinite(q) * np.where(q.real == 0, 1, 2)).sum(-1)


def whole(q: Any) -> Complexes:
    """With the mirrors, each row sorted by (Re q, Im q), nan last."""
    with np.errstate(invalid="ignore"):
        both = np.concatenate([q, np.where(q.real > 0, -q.conj(), np.nan)], 1)
    key = np.where(np.isfinite(both), both.real, np.inf)
    order = np.lexsort((np.where(np.isfinite(both), both.imag, np.inf), key), axis=1)
    return np.take_along_axis(both, order, 1)
