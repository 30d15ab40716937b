"""What p-roots tell of the way from one point to the next: whether they change sides, and how far waves turn."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.arrays import Complexes, Reals, Truths

_SIDES = 0.4


def passes_branch(z: Any, up: int) -> Truths:
    """Whether G may have a branch point between a point and the next: an upper and a lower p-root come together.

    That is so where a root moves by more than a part of its distance to the other side.
    """
    before, after = z[:-1], z[1:]
    out = np.zeros(len(after), bool)
    for one, other in ((before, after), (after, before)):
        for k in range(z.shape[1]):
            rest = range(up, z.shape[1]) if k < up else range(up)
            room = np.full(len(after), np.inf)
            for j in rest:
                room = np.minimum(room, np.abs(one[:, k] - one[:, j]))
            out |= ~(_nearest(one[:, k], other) < _SIDES * room)
    return out


def moved_between(z: Any, weight: Reals) -> Reals:
    """The largest move of a p-root from each point to the next; weight: of each root at the later points."""
    before, after = z[:-1], z[1:]
    out = np.zeros(len(after))
    for k in range(z.shape[1]):
        out = np.maximum(out, _nearest(after[:, k], before) * weight[:, k])
    return out


def felt(z: Any, shortest: Reals, longest: Reals) -> Any:
    """The largest ξ |e^{zξ}| over the distances between these: how much a move of a root turns what it adds to G."""
    decay = np.abs(z.real)
    with np.errstate(all="ignore"):
        xi = np.clip(1 / decay, np.minimum(shortest, longest)[:, None], longest[:, None])
        return xi * np.exp(-decay * xi)


def _nearest(one: Any, other: Complexes) -> Any:
    out = np.abs(one - other[:, 0])
    for j in range(1, other.shape[1]):
        out = np.minimum(out, np.abs(one - other[:, j]))
    return out
