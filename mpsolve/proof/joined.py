"""Fewer pieces than halving leaves: neighbours are joined where both together pass the test as one piece."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.proof.cover import Test
from mpsolve.proof.effort import Effort


def joined(points: Any, test: Test, effort: Effort, anywhere: bool = False, rounds: int = 2) -> Any:
    """The points of a path without those between two pieces that pass as one.

    Only points whose two neighbours lie with them on one line parallel to an axis are left out, so the path stays
    where it is. anywhere: any point but the ends may be left out, so the path may leave its corners.
    A point that stays is not tried again, as the pieces beside it only grow.
    """
    points = np.asarray(points, complex)
    open_ = np.ones(len(points), bool)
    for _ in range(rounds):
        candidates = np.flatnonzero(open_[1:-1] & (_straight(points) | anywhere)) + 1
        if not len(candidates):
            break
        chosen = [candidates[0]]
        for k in candidates[1:]:
            if k > chosen[-1] + 1:
                chosen.append(k)
        at = np.array(chosen)
        effort.spend(len(at))
        passed = np.array(test(points[at - 1], points[at + 1]), bool)
        open_[at[~passed]] = False
        kept = np.ones(len(points), bool)
        kept[at[passed]] = False
        points, open_ = points[kept], open_[kept]
    return points


def _straight(points: Any) -> Any:
    """Which points but the ends lie on one line parallel to an axis with the points beside them, and between them."""
    way = np.diff(points)
    x, y = np.sign(way.real), np.sign(way.imag)
    return ((x[1:] == x[:-1]) & (y[1:] == y[:-1]) & (x[1:] * y[1:] == 0)) if len(points) > 2 else np.zeros(0, bool)
