"""Proof that nothing is passed when the contour is lifted from the lower side of the cut onto the path.

The region between them, 0 ≤ Im v ≤ δ from where the path crosses the cut to where the far field begins, is covered by
strips of cells (rigorous_cells.py). In each strip the p-roots are isolated, named at the real axis as seen from below
the cut (edge.py) and from cell to cell upward, and R·Δ ≠ 0: W̃ continues analytically over the region.
"""

from __future__ import annotations

from typing import Any

import flint
import numpy as np

from mpsolve.discs import Discs
from mpsolve.errors import PrecisionError
from mpsolve.model.branch import Track
from mpsolve.model.edge import edge_roots
from mpsolve.motion.rigorous_cells import NAMES, Cells, cells, scaled_delta
from mpsolve.motion.rigorous_path import Guide, Route

arb = flint.arb

_ROUNDS = 12
_MOST_CELLS = 60_000
_PAD = 1 + 2.0**-20  # of cells, by far above the rounding of their middles


def prove_clear(track: Track, discs: Track, guide: Guide, way: Route, end: float) -> int:
    """Proves that W̃ is analytic for way.start ≤ Re v ≤ end, 0 ≤ Im v ≤ δ; the number of cells used.

    `track` in balls, `discs` the same in discs. Raises PrecisionError where a zero or a branch point may lie there.
    """
    low = np.array(_breaks(way, end))
    low, high = low[:-1], low[1:]
    used = 0
    for _ in range(_ROUNDS):
        layers = np.ceil(way.delta / (high - low)).astype(int)
        used += int(layers.sum())
        if used > _MOST_CELLS:
            break
        strip = np.repeat(np.arange(len(low)), layers)
        level = np.arange(len(strip)) - np.repeat(np.cumsum(layers) - layers, layers)
        height = (way.delta / layers)[strip]
        middle = (low + high)[strip] / 2 + 1j * height * (level + 0.5)
        radius = np.hypot((high - low)[strip], height) / 2 * _PAD
        over = cells(discs, guide, way, Discs(middle, radius))
        good = over.known & scaled_delta(discs, over).nonzero()
        good[1:] &= (level[1:] == 0) | over.alike(slice(1, None), slice(None, -1))
        proved = np.logical_and.reduceat(good, np.cumsum(layers) - layers)
        for k in np.flatnonzero(proved):
            proved[k] = _named_from_below(track, over, int(np.argmax(strip == k)), way, (low[k] + high[k]) / 2)
        if proved.all():
            return used
        low, high, middle = low[~proved], high[~proved], (low + high)[~proved] / 2
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    place = way.centre + float(low.min()) ** 2 / 2
    raise PrecisionError(
        f"zeros of Δ or branch points may lie close above the cut near Re q = {place:.4g}, so that the contour "
        "cannot be turned with proof: change a parameter slightly, or ask for float64 values"
    )


def _breaks(way: Route, end: float) -> list[float]:
    """Strips as wide as the strip is high, or its distance from the branch point, at first."""
    breaks = [way.start]
    while breaks[-1] < end:
        breaks.append(breaks[-1] + min(way.delta, 0.25 * breaks[-1]))
    return breaks


def _named_from_below(track: Track, over: Cells, cell: int, way: Route, u: Any) -> bool:
    """Whether a, b are the upper p-roots at v = u on the real axis, in the cell, as seen from below the cut."""
    try:
        seen = edge_roots(track, arb(way.centre) + arb(u) ** 2 / 2)
    except PrecisionError:
        return False
    upper, lower = (seen.a, seen.b), (seen.c, seen.e)
    balls = [over.ball(name, cell) for name in NAMES]
    return not any(
        p.overlaps(ball) for side, others in ((upper, balls[2:]), (lower, balls[:2])) for p in side for ball in others
    )
