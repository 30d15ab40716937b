"""Where the counted roots are, in float64: heuristic, nothing is proved here.

A grid over the counted rectangle is searched for places from which Newton's step is short; Newton's method by the
trace formula Δ̂′/Δ̂ = tr(A⁻¹A′), with found roots divided out, then runs from them. The grid grows finer until as
many roots are found as were counted.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from typing import Any

import numpy as np

from mpsolve.characteristic.floats import Floats
from mpsolve.frozen import frozen
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.on_frozen_track import on_frozen_track

_STEPS = 40
_FEW, _SHORT = 8, (14, 20, 40)  # roots; steps to so few from the best hints, from more, and from all without crowds
_AROUND, _ON_LINE = 0.3, 1e-9  # of an area's size: how far outside points may wander, and roots may be
_SPREAD = 1e-3  # relative: hints that are closer give one start
_CROWD, _ROUND = 1e-5, 12  # relative radius, and points of a circle round roots that floats may take for one
_NEXT = 0.03  # relative: the first starts are so far from each other
_ARRIVED = 1e-9  # a step relative to |q|: the next one is of the size of its square
_MOST = 2**29  # entries of the matrices at all points together; a search ends there with what it has
_SAME = 1e-7  # relative: closer roots are taken for one


@frozen
class Area:
    """The right half of a symmetric region in scaled q̂: 0 ≤ Re q ≤ re_max, im_min ≤ Im q ≤ im_max.

    line: the Im q next to which most roots are.
    """

    re_min: float
    re_max: float
    im_min: float
    im_max: float
    line: float = 0.0

    def holds(self, q: Any, slack: float) -> Any:
        return (
            (q.real > self.re_min - slack)
            & (q.real < self.re_max + slack)
            & (q.imag > self.im_min - slack)
            & (q.imag < self.im_max + slack)
        )

    def counts(self, q: complex) -> bool:
        """Whether a root found here is one of those that were counted: one beyond the line, next to it, is not."""
        return self.im_min <= q.imag <= self.im_max

    @property
    def size(self) -> float:
        return max(self.re_max - self.re_min, self.im_max - self.im_min)


Weight = Callable[[complex], int]
"""How many roots of a region one with Re q ≥ 0 and its mirror −q̄ stand for."""


def both(q: complex) -> int:
    """Of a symmetric region: 2, but 1 for a root on the imaginary axis."""
    return 1 if abs(q.real) < 1e-9 * abs(q) else 2


def find_roots(
    reduced: Reduced,
    areas: tuple[Area, ...],
    count: int,
    hints: Any,
    weight: Weight = both,
    on_the_way: Callable[[], None] | None = None,
    known: Any = (),
    later: Callable[[], Any] | None = None,
) -> Any:
    """Approximate roots q̂ in the areas beside those `known`, up to `count` with their mirrors; all that were found.

    on_the_way: called before every step; it may raise what ends the search.
    hints: points that are dense where Δ̂ turns fast, as those of a contour: tried before any grid. later: more of
    them, that are asked for where those do not lead to all.
    """
    function, work = Floats(reduced), 0
    found, before = np.array(known, complex), len(known)

    def all_found(roots: Any, points: int = 0) -> bool:
        nonlocal work
        if on_the_way is not None:
            on_the_way()
        work += points * (reduced.bodies + reduced.contacts) ** 2
        return work > _MOST or stood_for(roots, [1.0] * len(roots)) >= count

    def stood_for(roots: Any, times: list[float]) -> float:
        new = zip(roots[before:].tolist(), times[before:], strict=True)
        return sum(weight(q) * n for q, n in new if any(area.counts(q) for area in areas))

    def with_crowds(roots: Any) -> bool:
        return all_found(roots) or stood_for(roots, _crowds(function, roots).tolist()) > count - 0.5

    few = count <= _FEW
    sprung = on_frozen_track(function, max(area.size for area in areas))
    ways: list[tuple[Callable[[Area], Any], int]] = [(lambda _: sprung, _STEPS)]
    for level, steps in enumerate(_SHORT if few else (_STEPS,) * len(_SHORT)):
        ways.append((_from_hints(function, hints, level, count), steps))
    more: Callable[[], Any] = cache(later) if later is not None else lambda: hints[:0]
    last: list[Callable[[Area], Any]] = [lambda _: more(), *(partial(_starts, function, n) for n in range(5))]
    last.append(lambda _: hints)  # rare: many roots, some far from the others
    for k, (starts_in, steps) in enumerate([*ways, *((one, _STEPS) for one in last)]):
        if with_crowds(found):
            break
        for area in areas if k != 1 or few else areas[:1]:
            if not all_found(found):
                found = _newton(function, area, starts_in(area), found, all_found, steps)
    return found[before:][np.argsort(-_crowds(function, found[before:]), kind="stable")]


def _from_hints(function: Floats, hints: Any, level: int, count: int) -> Callable[[Area], Any]:
    """Where Newton's step leads from hints; at the first level few, that are apart."""
    best = cache(lambda: _best(function, hints if level < 2 else _spread(hints), np.inf, len(hints)))

    def starts_in(area: Area) -> Any:
        starts = best()[area.holds(best(), (_AROUND if level else _ON_LINE) * area.size)]
        return starts[: 8 * count + 20] if level else _apart(starts)[: 4 * count + 8]

    return starts_in


def _crowds(function: Floats, roots: Any) -> Any:
    """How many zeros of Δ̂ each stands for: those in a circle by the mean of Δ̂′/Δ̂ on it, shared by all there."""
    circle = _CROWD * np.abs(roots)[:, None] * np.exp(2j * np.pi * np.arange(_ROUND) / _ROUND)
    there = (np.abs(roots[:, None] - roots) < _CROWD * np.abs(roots)[:, None]).sum(1)
    step = _step(function, (roots[:, None] + circle).ravel(), np.zeros(0, complex))
    number = (-circle.ravel() / step).real.reshape(circle.shape).mean(1)
    return np.maximum(np.where(np.isfinite(number), np.rint(number) / np.maximum(there, 1), 1), 1)


def search(reduced: Reduced, area: Area, hints: Any, levels: int = 2) -> Any:
    """Approximate roots q̂ of an area whose number is not known, from `hints` and from grids: some may be missed."""
    function = Floats(reduced)
    found = np.zeros(0, complex)
    if len(hints):
        found = _newton(function, area, np.asarray(hints, complex), found)
    if levels:
        found = _newton(function, area, on_frozen_track(function, area.size), found)
    for level in range(levels):
        found = _newton(function, area, _starts(function, level, area), found)
    return found


def _spread(points: Any) -> Any:
    """The points without those that all but repeat the one before: where p-roots nearly meet, pieces crowd."""
    kept: list[complex] = []
    for q in np.asarray(points, complex).tolist():
        if not kept or abs(q - kept[-1]) > _SPREAD * abs(q):
            kept.append(q)
    return np.array(kept, complex)


def _apart(points: Any) -> Any:
    """The points without those that all but repeat one before: of steps that lead to one place one is enough."""
    kept = points[:0]
    for q in points:
        if not (np.abs(kept - q) < _NEXT * np.abs(q)).any():
            kept = np.append(kept, q)
    return kept


def nearest_root(reduced: Reduced, q: complex) -> complex | None:
    """Where Newton's method leads from q̂, or None where it does not settle."""
    function, at = Floats(reduced), np.array([q])
    for _ in range(_STEPS):
        step = _step(function, at, np.zeros(0, complex))
        if not np.isfinite(step[0]):
            return None
        at = at + step
        if abs(step[0]) < 1e-9 * abs(at[0]):  # at a root itself the next step is not finite
            return complex(at[0])
    return None


def _starts(function: Floats, level: int, area: Area) -> Any:
    """Grid points whose Newton step is of the size of the grid, shortest first; rows lie denser near the line."""
    n, m = 24 * 2**level, 8 * 2**level
    x = np.linspace(area.re_min, area.re_max, n + 1)
    depth = max(abs(area.im_min - area.line), abs(area.im_max - area.line))
    one_side = np.geomspace(1e-4, 1, m) * depth
    spread = area.line + np.concatenate([-one_side[::-1], [0.0], one_side])
    y = spread[(spread >= area.im_min) & (spread <= area.im_max)]
    q = (x[:, None] + 1j * y[None, :]).ravel()
    return _best(function, q, 3 * (area.re_max - area.re_min) / n + 0.5 * np.abs(q.imag - area.line), 60 * 2**level)


def _best(function: Floats, q: Any, reach: Any, most: int) -> Any:
    """Where Newton's step leads from the points at which it is shortest, below `reach`."""
    step = _step(function, q, np.zeros(0, complex))
    order = np.flatnonzero((np.abs(step) < reach) & np.isfinite(step))
    order = order[np.argsort(np.abs(step[order]))][:most]
    return q[order] + step[order]


def _newton(
    function: Floats,
    area: Area,
    q: Any,
    found: Any,
    enough: Callable[[Any, int], bool] = lambda *_: False,
    steps: int = _STEPS,
) -> Any:
    """Roots in the area, old and new ones, until there are enough."""
    slack = _ON_LINE * area.size
    for _ in range(steps):
        if not len(q) or enough(found, len(q)):
            return found
        step = _step(function, q, found)
        limit = 0.2 * area.size
        size = np.abs(step)
        step = np.where(size > limit, step * (limit / np.where(size > 0, size, 1)), step)
        q = q + step
        q = np.where(q.real < 0, -q.conj(), q)
        alive = np.isfinite(q) & area.holds(q, _AROUND * area.size)
        arrived = alive & (np.abs(step) < _ARRIVED * np.maximum(np.abs(q), 1e-20 * area.size))
        for root in q[arrived]:
            if area.holds(root, slack) and not (np.abs(found - root) < _SAME * np.abs(root)).any():
                found = np.append(found, root)
        q = q[alive & ~arrived]
    return found


def _step(function: Floats, q: Any, found: Any) -> Any:
    """Newton's step in q for Δ̂ with the found roots and their mirrors divided out."""
    zeros = [1j * zero for root in found for zero in (root, -root.conjugate())[: both(root)]]
    return -1j * function.step(1j * q, zeros)
