"""What floats see of a range, a first crossing, roots that grow or lie lowest: proofs start there, none rests on it.

A first crossing: from points of a grid of (q̂, x̂) Newton's method is tried, all points side by side; what stays near
its point is kept. A second parameter may have given values. An onset asks for a range up to itself only: as far as
floats see the first crossing, and a little beyond.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
from flint import arb

from mpsolve.characteristic.boxes import Boxes
from mpsolve.characteristic.floats import Floats
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.arrays import Complexes, Reals
from mpsolve.numbers.balls import precision
from mpsolve.numbers.float64 import refined
from mpsolve.numbers.realroots import short_between
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.family import Family, family_of
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced
from mpsolve.proof.vanishing import guess, in_plane, scalar
from mpsolve.ranges.answer import Interval
from mpsolve.ranges.scope import from_above_rest, one_path
from mpsolve.spectrum.candidates import Area, search
from mpsolve.spectrum.closing import closing_argument

_Q = 2.0**-6, 2.0**3  # between them lie cells of q̂
_CELLS, _X = 18, 12  # of q̂ and of x̂
_WIDE = 4  # ends of a range further apart than by this factor are parted by equal factors
_SMALL = 2.0**-8  # of a cell: the boxes in which slopes are taken
_ROUNDS, _NEAR, _DONE = 4, 4.0, 2.0**-6  # steps; of a cell: as far as they may lead, and the last
_SAMPLES = 6  # values of the second parameter at which the whole grid is tried


def first_seen(family: Family) -> tuple[float, float] | None:
    """(q̂, x̂) of the crossing with the least x̂ that is met, for a family of one parameter; None where none is."""
    matrix = FreeMatrix(family)
    for finer in (1, 2):  # contacts far apart have crossings so close together that a coarse grid meets none
        least = _least(met(matrix, *_grid(family, finer)), family)
        if least is not None:
            return least
    return None


def each_seen(family: Family, values: Any) -> Reals:
    """The same for given values of a second parameter, ascending: q̂ and x̂ of each, nan where none is met."""
    matrix, out = FreeMatrix(family), np.full((2, len(values)), np.nan)
    sampled = np.unique(np.linspace(0, len(values) - 1, _SAMPLES).astype(int))
    m, half = _grid(family)
    every = [np.repeat(a, len(sampled), 1) for a in (m, half)]
    at = np.tile(values[sampled], m.shape[1])
    found = met(matrix, np.vstack([every[0], at]), np.vstack([every[1], 0 * at]))
    for n in sampled:
        least = _least(found[:2, found[2] == values[n]], family)
        if least is not None:
            out[:, n] = least
    known = np.flatnonzero(np.isfinite(out[0]))
    rest = np.setdiff1d(np.arange(len(values)), sampled)
    if not len(known) or not len(rest):
        return out
    # between samples from both of them, as the branch that is first may change
    sides = [np.clip(np.searchsorted(known, rest) + k, 0, len(known) - 1) for k in (-1, 0)]
    line = np.array([np.interp(values[rest], values[known], row[known]) for row in out])
    starts = [line, *(out[:, known[side]] for side in sides)]
    start = np.hstack([np.vstack([at, values[rest]]) for at in starts])
    found = met(matrix, start, np.vstack([np.abs(start[:2]) / 4, 0 * start[2:]]))
    for n in rest:
        least = _least(found[:2, found[2] == values[n]], family)
        if least is not None:
            out[:, n] = least
    return out


def met(matrix: FreeMatrix, start: Any, half: Reals) -> Any:
    """Points at which roots are real, met from some of these, shape (variables, points)."""
    m, step = start, 0 * start[:2]
    with np.errstate(all="ignore"):
        for _ in range(_ROUNDS):
            if not m.size:
                return m
            r = half * _SMALL
            A, G = matrix(Boxes(m, r))
            s = scalar(A, G.good)
            step = np.vstack([r[:2] * guess(in_plane(s.s)), 0 * r[2:]])
            kept = s.good & (np.abs(m + step - start)[:2] < _NEAR * half[:2]).all(0)
            start, half, m, step = (a[:, kept] for a in (start, half, m + step, step))
    return m[:, (np.abs(step)[:2] < _DONE * half[:2]).all(0)]


def _least(found: Reals, family: Family) -> tuple[float, float] | None:
    low, high = (float(x) for x in family.box[0])
    inside = (found[0] > 0) & (found[1] > low) & (found[1] < high)
    return min(((float(q), float(x)) for q, x in found[:2, inside].T), key=lambda one: one[1], default=None)


def _grid(family: Family, finer: int = 1) -> tuple[Reals, Reals]:
    """Middles and halves of cells of (q̂, x̂), so many times as many each way."""
    low, high = (float(x) for x in family.box[0])
    q, cells = np.geomspace(*_Q, _CELLS * finer + 1), _X * finer
    x = np.geomspace(low, high, cells + 1) if 0 < low * _WIDE < high else np.linspace(low, high, cells + 1)
    middles = np.meshgrid((q[1:] + q[:-1]) / 2, (x[1:] + x[:-1]) / 2)
    halves = np.meshgrid((q[1:] - q[:-1]) / 2, (x[1:] - x[:-1]) / 2)
    return np.stack([a.ravel() for a in middles]), np.stack([a.ravel() for a in halves])


BEYOND = "nothing is said of larger values"
_MORE = 32
"""A part of what lies between the start of the range and the crossing: so much more is proved."""


@dataclass(frozen=True)
class Shorter:
    """A part of a range, and the point (q, value) of the crossing seen in it, floats; in the problem's units."""

    over: dict[str, Interval]
    near: tuple[float, float]


def up_to_first(problem: Problem, over: Mapping[str, Interval]) -> Shorter | None:
    """The range up to a little beyond the first crossing; None where none is seen, or the range has no upper end."""
    path = one_path(over)
    if over[path][1] is None:
        return None
    over = from_above_rest(problem, over)
    low, high = over[path]
    try:
        with one_thread():
            family = family_of(problem, over)
            seen = first_seen(family)
    except (InputError, PrecisionError):
        return None
    if seen is None:
        return None
    at = Fraction(seen[1]) * family.units[0]
    far = min(high, at + (at - low) / _MORE)
    if not low < at < far:
        return None
    q = seen[0] * float(family.frequency_unit)
    return Shorter({path: (low, short_between(at + (far - at) / 2, far))}, (q, float(at)))


_STEP, _HALVINGS = 0.7, 16  # radians that the argument may turn between neighbours; and how often these are halved


def count_seen(reduced: Reduced, X: float) -> int | None:
    """The count that passivity beyond X̂ closes; None where floats do not tell."""
    function = Floats(reduced)
    q = np.unique(np.concatenate([np.linspace(0, X, 97), np.geomspace(1e-4, 1, 33) * X]))
    q[0] = 1e-9 * X
    with np.errstate(all="ignore"):
        values, settled = refined(lambda q: _dets(function, q), q, lambda f: ~(np.abs(_turns(f)) < _STEP), _HALVINGS)[
            1:
        ]
    if not settled:
        return None
    middle = function.receptance.between(np.array([1j * X]), reduced.places)[0]
    try:
        with precision(64):
            closing = float(closing_argument(reduced, X, middle, np.zeros(middle.shape)))
    except PrecisionError:
        return None
    order = reduced.bodies - reduced.contacts - reduced.neutral
    total = (closing + order * float(arb.pi()) / 2 - float(_turns(values).sum())) / np.pi
    return round(total) if abs(total - round(total)) < 0.05 else None


def _turns(values: Any) -> Any:
    return np.angle(values[1:] / values[:-1])


def _dets(function: Floats, q: Any) -> Any:
    A = function.matrices(1j * q)[0]
    sizes = np.abs(A).max(2, keepdims=True)
    return np.linalg.det(A / np.where(sizes > 0, sizes, 1))


def corners_and_more(box: tuple[Reals, Reals], seed: int = 1, more: int = 12) -> list[Reals]:
    """Points of a box (low, high): its corners, as long as they are few, and others; a fixed choice."""
    low, high = box
    ends = list(product(*zip(low, high, strict=True)))[:64]
    inner = np.random.default_rng(seed).uniform(size=(more, len(low)))
    return [np.array(end) for end in ends] + [low + t * (high - low) for t in inner]


_POINTS = 17
_SEARCHED = 8  # of as many points one is searched without hints


@dataclass(frozen=True)
class Seen:
    """A root q̂ at x̂, and the distance of the points that were looked at."""

    x: float
    q: complex
    step: float


def least_seen(family: Family, low: float, high: float, area: Area) -> Seen | None:
    """The lowest root that is met at points of [low, high] (of x̂), Re q̂ ≥ 0; None where none is met."""
    x = np.linspace(low, high, _POINTS)
    ends = family.box[0]
    roots: list[Any] = [np.zeros(0, complex)] * len(x)
    for k in range(0, len(x), _SEARCHED):
        roots[k] = _roots(family, x[k], ends, area, roots[k], 1)
    for k in range(1, len(x)):  # followed from point to point, and back where one point has more than the next
        if len(roots[k]) < len(roots[k - 1]):
            roots[k] = _roots(family, x[k], ends, area, np.concatenate([roots[k], roots[k - 1]]), 0)
    for k in range(len(x) - 2, -1, -1):
        if len(roots[k]) < len(roots[k + 1]):
            roots[k] = _roots(family, x[k], ends, area, np.concatenate([roots[k], roots[k + 1]]), 0)
    best = [(float(q.imag), float(x[k]), complex(q)) for k, row in enumerate(roots) for q in row]
    if not best:
        return None
    _, at, q = min(best)
    return Seen(at, q, float(x[1] - x[0]))


def _roots(
    family: Family, x: float, ends: tuple[Fraction, Fraction], area: Area, hints: Complexes, levels: int
) -> Any:
    if not len(hints) and not levels:
        return hints
    at = min(max(Fraction(x), ends[0]), ends[1])
    try:
        return search(family.reduced([at]), area, hints, levels)
    except (InputError, PrecisionError):
        return hints[:0]
