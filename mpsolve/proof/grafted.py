"""Trees of boxes that are made apart: the first halvings, and trees of open leaves put in their places."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import OPEN, Tree, subdivide


def halved(low: Any, high: Any, times: int) -> Tree:
    """2^times open boxes, 32 at least, each halved along its longest sides, relative to the whole."""
    whole = np.asarray(high, float) - np.asarray(low, float)

    def judge(a: Any, b: Any) -> tuple[Any, Any]:
        share = (b - a) / np.where(whole > 0, whole, np.inf)[:, None]
        done = np.log2(share, where=share > 0, out=np.zeros_like(share)).sum(0) <= 0.5 - times
        return np.where(done, 1, OPEN), share.argmax(0)

    tree = subdivide(low, high, judge, Effort()).tree
    return Tree(tree.low, tree.high, np.zeros_like(tree.kind), tree.axis, tree.child)


def grafted(tree: Tree, leaves: Sequence[int], trees: Sequence[Tree]) -> Tree:
    """`tree` with other trees in the places of some of its open leaves, whose boxes are theirs."""
    parts = [tree]
    kind, axis, child = (part.copy() for part in (tree.kind, tree.axis, tree.child))
    size = tree.nodes
    for leaf, one in zip(leaves, trees, strict=True):
        shift = size - 1  # the root of the new one is the leaf; its other nodes follow
        kind[leaf], axis[leaf] = one.kind[0], one.axis[0]
        child[leaf] = one.child[0] + shift if one.axis[0] >= 0 else -1
        moved = np.where(one.axis >= 0, one.child + shift, -1)
        parts.append(Tree(one.low[:, 1:], one.high[:, 1:], one.kind[1:], one.axis[1:], moved[1:]))
        size += one.nodes - 1
    new = parts[1:]
    return Tree(
        np.concatenate([part.low for part in parts], 1),
        np.concatenate([part.high for part in parts], 1),
        np.concatenate([kind, *(part.kind for part in new)]),
        np.concatenate([axis, *(part.axis for part in new)]),
        np.concatenate([child, *(part.child for part in new)]),
    )
