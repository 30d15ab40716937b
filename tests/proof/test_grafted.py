"""Trees made apart and joined tile the whole, as one tree does."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve.proof.effort import Effort
from mpsolve.proof.grafted import grafted, halved
from mpsolve.proof.subdivide import subdivide

LOW, HIGH = np.array([0.0, -1.0]), np.array([2.0, 3.0])


def by_circle(low: Any, high: Any) -> tuple[Any, Any]:
    """Boxes off the unit circle."""
    near = np.maximum(np.maximum(low, -high), 0)
    far = np.maximum(np.abs(low), np.abs(high))
    off = ((near**2).sum(0) > 1) | ((far**2).sum(0) < 1)
    return np.where(off, 1, 0), (high - low).argmax(0)


@pytest.mark.parametrize("times", [5, 6, 7])
def test_halved(times: int) -> None:
    tree = halved(LOW, HIGH, times)
    low, high = tree.boxes(tree.open)
    assert low.shape == (2, 2**times)
    assert np.prod(high - low, axis=0) == pytest.approx(8 / 2**times)


@pytest.mark.parametrize("again", [False, True])
def test_joined_trees_tile_the_whole(again: bool) -> None:
    tree = halved(LOW, HIGH, 4)
    leaves = tree.open
    low, high = tree.boxes(leaves)
    most = Effort(evaluations=60 if again else None)
    parts = [subdivide(a, b, by_circle, most.anew(), 2.0**-6) for a, b in zip(low.T, high.T, strict=True)]
    whole = grafted(tree, leaves, [part.tree for part in parts])
    leaf = whole.axis < 0
    assert np.prod(whole.high - whole.low, axis=0)[leaf].sum() == pytest.approx(8)
    inner = np.flatnonzero(~leaf)
    for n in inner:
        k, first = whole.axis[n], whole.child[n]
        assert whole.high[k, first] == whole.low[k, first + 1]
        for own, other in ((whole.low[:, n], whole.low[:, first]), (whole.high[:, n], whole.high[:, first + 1])):
            assert (own == other).all()
    assert sorted(np.concatenate([whole.child[inner], whole.child[inner] + 1])) == list(range(1, whole.nodes))
    a, b = whole.boxes(np.flatnonzero(whole.kind == 1))
    assert (by_circle(a, b)[0] == 1).all()
