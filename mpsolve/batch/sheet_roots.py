"""Where the roots on the whole sheet of a beam are: followed from neighbours, sought from the edge and from a grid.

The unknown of Newton's method is t = √(z − |limit|) and the function t Δ: both are smooth at the branch point, where
Δ ~ 1/t. Nothing is proved: an entry is solved when as many roots are found as were counted.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from mpsolve.batch.halves import Halves
from mpsolve.batch.kernel import log_slope
from mpsolve.batch.roots import poles, weight
from mpsolve.batch.sheet_count import NODES, Edge, count_sheet
from mpsolve.numbers.arrays import Complexes, Integers, Reals

SAME = 1e-8  # relative distance of two approximations to one root
MOST = 64  # roots of an entry: one that has more is not followed
_STEPS, _MORE, _MOST_STEPS = 8, 20, 80  # roots close together are approached slowly
_SETTLED = 1e-9  # a relative step after which quadratic convergence leaves nothing but rounding
_SNAP = 1e-7
_ZERO = 1e-10  # scaled: at q = 0 there is no root
_FEW = 256
_ANCHORS = 32  # entries of which the roots are sought without neighbours
_LEAP = 4  # so many times as dense each time
_WORK = 1 << 17  # guesses, times the roots that are divided out of each, at a time: it bounds the memory
_TURNS = np.array([-0.5, -0.35, -0.2, -0.08, -0.02, 0.02, 0.08, 0.2, 0.35, 0.5]) * np.pi
_FAR, _NEAR = np.geomspace(0.02, 1, 8), np.array([0.2, 0.4, 0.6, 0.8, 1.0])
_GRID = (len(_FAR) + len(_NEAR)) * len(_TURNS)
_TRIES = 7  # parts of the grid


@dataclass
class SheetSearch:
    """z: the distinct roots with Re z ≥ 0 found so far, shape (entries, columns), nan beyond them (scaled)."""

    halves: Halves
    edge: Edge
    z: Any = field(init=False)

    def __post_init__(self) -> None:
        self.edge.count[self.edge.count > MOST] = -1
        self.z = np.full((len(self.halves), max(2, int(self.edge.count.max(initial=0)))), np.nan, complex)

    def solve(self) -> Any:
        """Whether each entry has as many roots as were counted; neighbours among the entries should be alike."""
        n = len(self.halves)
        places, stride = np.arange(n), 1
        while n > _ANCHORS * stride:
            stride *= _LEAP
        self._alone(places[::stride])
        while stride > 1:
            known, stride = stride, stride // _LEAP
            new = places[::stride]
            new = new[new % known > 0]
            for there in (new - new % known, new - new % known + known):
                still = self._open(new) & (there < n)
                self._extend(new[still], self.z[there[still]])
            self._alone(new)
        self._alone(places)
        return weight(self.z) == self.edge.count

    def _open(self, places: Integers) -> Any:
        return weight(self.z[places]) < self.edge.count[places]

    def _alone(self, places: Integers) -> None:
        """Roots that no neighbour has: from the edge, from a grid, at last from many more nodes of the edge."""
        for part in range(-1, _TRIES):
            places = places[self._open(places)]
            if not len(places):
                return
            if part < 0:
                guesses = edge_guesses(self.halves, places, self.edge, 4)
            else:
                guesses = grid_guesses(self.halves, places)[:, part::_TRIES]
            self._extend(places, guesses, _MORE)
        places = places[self._open(places)]
        for some in (places[k : k + _FEW] for k in range(0, len(places), _FEW)):
            halves = self.halves[some]
            fine = count_sheet(halves, 8 * NODES)
            self.edge.count[some] = np.where(fine.count == self.edge.count[some], fine.count, -1)
            self._extend(some, edge_guesses(halves, np.arange(len(halves)), fine, 96), _MOST_STEPS)

    def _extend(self, places: Integers, guesses: Complexes, apart: int = 0) -> None:
        """Adds what the guesses lead to, with the known roots divided out if steps `apart` are given."""
        size = max(1, _WORK // (guesses.shape[1] * (1 + self.z.shape[1] * (apart > 0))))
        for k in range(0, len(places), size):
            self._add(places[k : k + size], guesses[k : k + size], apart)

    def _add(self, places: Integers, guesses: Any, apart: int) -> None:
        known = self.z[places]
        rows = np.repeat(places, guesses.shape[1])
        new = guesses.ravel()
        if apart:
            new = polish(self.halves, rows, new, np.repeat(known, guesses.shape[1], 0), apart)
        new = polish(self.halves, rows, new)
        new = snapped(self.halves, rows, new).reshape(guesses.shape)
        self.z[places] = distinct(self.halves, places, np.concatenate([known, new], axis=1), self.z.shape[1])


def edge_guesses(halves: Halves, rows: Integers, edge: Edge, nearest: int) -> Complexes:
    """One Newton step in t, with difference quotients, from between the nodes: shape (rows, nearest).

    A line of roots begins and ends on the cut, so that a root which the neighbours lack is close to it.
    """
    t, log = edge.t[rows], edge.log[:, rows]
    branch = np.abs(halves.limit[rows])[:, None]
    gap, middle = np.diff(t, axis=1), (t[:, :-1] + t[:, 1:]) / 2
    guesses, reach = [], []
    for side, values in ((1, log[0]), (-1, log[1].conj())):
        with np.errstate(all="ignore"):
            ratio = np.exp(np.diff(values, axis=1))
            move = -(1 + ratio) / 2 * gap / (ratio - 1)
            distance = np.abs(move) / gap
        z = branch + np.where(middle < 0, -1, 1) * (middle + move) ** 2
        inside = (side * move.imag < 0) & (distance < 4)
        guesses.append(np.where(inside, z, np.nan))
        reach.append(np.where(inside, distance, np.inf))
    best = np.argsort(np.concatenate(reach, axis=1), axis=1)[:, :nearest]
    return np.take_along_axis(np.concatenate(guesses, axis=1), best, axis=1)


def grid_guesses(halves: Halves, rows: Integers) -> Any:
    """Polar grids in the right half-plane, dense towards both sides of the cut: wide, and within |limit|."""
    far, tip = np.sqrt(halves.far[rows])[:, None], np.abs(halves.limit[rows])[:, None]
    radius = np.concatenate([_FAR * far, _NEAR * tip], axis=1)
    return (radius[:, :, None] * np.exp(1j * _TURNS)).reshape(len(rows), _GRID)


def polish(halves: Halves, rows: Any, z: Any, known: Any = None, steps: int = _STEPS) -> Complexes:
    """The roots that the guesses z lead to, folded into Re z ≥ 0; nan where they lead nowhere.

    known: roots to be divided out, shape (guesses, k), nan for none.
    """
    result = np.full(z.shape, np.nan, complex)
    place = np.flatnonzero(np.isfinite(z))
    rows, z, near = rows[place], z[place], None
    for _ in range(steps):
        if not len(place):
            break
        with np.errstate(all="ignore"):
            size_q = np.abs(z + 1j * halves.height[rows])
            move, size, near = _step(halves, rows, z, 0 if known is None else poles(z, known[place]), near)
            bound = 0.3 * size_q + 0.02  # a step far from a root is no more than a direction
            z = z + move * np.minimum(1, bound / np.where(size > 0, size, 1))
            settled = size < _SETTLED * np.abs(z + 1j * halves.height[rows])
        result[place[settled]] = z[settled]
        keep = ~settled & np.isfinite(z)
        place, rows, z, near = place[keep], rows[keep], z[keep], near[keep]
    return np.where(result.real < 0, -result.conj(), result)


def _step(
    halves: Halves, rows: Integers, z: Any, pole: Any, near: Complexes | None
) -> tuple[Complexes, Reals, Complexes]:
    """The step in z, a bound of its size that no accident makes small (t and −t are one z), and the p-roots."""
    upper = z.imag > 0
    slope, near = log_slope(halves.group, rows + len(halves) * upper, np.where(upper, z.conj(), z), near)
    slope = np.where(upper, slope.conj(), slope)
    t = np.sqrt(z - np.abs(halves.limit)[rows])
    step = -t / (2 * t * t * (slope - pole) + 1)
    return (2 * t + step) * step, (2 * np.abs(t) + np.abs(step)) * np.abs(step), near


def snapped(halves: Halves, rows: Integers, z: Any) -> Any:
    """Roots next to a line of symmetry put on it: the imaginary axis, and the gap of the real one without damping."""
    z = z.copy()
    with np.errstate(invalid="ignore"):
        size = np.abs(z + 1j * halves.height[rows])
        z[size < _ZERO] = np.nan
        close = _SNAP * size
        on_imaginary = (np.abs(z.real) < close) & (z.real != 0)
        gap = (halves.height[rows] == 0) & (z.real < halves.limit[rows])
        on_real = gap & (np.abs(z.imag) < close) & (z.imag != 0)
    for near, line in ((on_imaginary, 1j), (on_real, 1)):
        place = np.flatnonzero(near)
        if len(place):
            start = (z[place] / line).real * line
            moved = (polish(halves, rows[place], start + 0j) / line).real * line
            with np.errstate(invalid="ignore"):
                same = np.abs(moved - z[place]) < SAME * size[place]
            z[place[same]] = moved[same]
    return z


def distinct(halves: Halves, entries: Any, z: Any, width: int) -> Complexes:
    """The first `width` different roots of every row (of these entries), padded with nan.

    Joined cuts part the sheet in two: roots on different sides are different, however close they are.
    """
    z, rows = z.copy(), np.arange(len(z))
    found = np.full((len(z), width), np.nan, complex)
    with np.errstate(invalid="ignore"):
        above = (z.imag > 0) & (halves.limit[entries] <= 0)[:, None]
        for k in range(width):
            first = np.isfinite(z).argmax(axis=1)
            root = found[:, k] = z[rows, first]
            near = np.abs(z - root[:, None]) < SAME * np.abs(root + 1j * halves.height[entries])[:, None]
            z[near & (above == above[rows, first][:, None])] = np.nan
            if not np.isfinite(z).any():
                break
    return found


def whole_sheet(halves: Halves, z: Any) -> Complexes:
    """q, scaled: roots with Re q ≥ 0 and their mirrors −q̄, exactly in pairs q, q̄ without damping; each row sorted."""
    z, undamped = z.copy(), halves.height == 0
    with np.errstate(invalid="ignore"):
        for k in range(z.shape[1]):
            for j in range(z.shape[1]):
                pair = undamped & (z[:, k].imag > 0) & (np.abs(z[:, k] - z[:, j].conj()) < 1e-10 * np.abs(z[:, k]))
                z[pair, k] = z[pair, j].conj()
        q = z + 1j * halves.height[:, None]
        return np.sort(np.concatenate([q, np.where(q.real > 0, -q.conj(), np.nan)], axis=1), axis=1)
