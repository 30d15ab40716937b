"""Subdivision covers the whole, keeps its tree, and ends."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve.proof.effort import Effort
from mpsolve.proof.subdivide import OPEN, grafted, halved, subdivide


def off_circle(low: Any, high: Any) -> tuple[Any, Any]:
    """Boxes that lie inside or outside of the unit circle."""
    near = np.hypot(*np.clip(0.0, low, high))
    far = np.hypot(*np.maximum(np.abs(low), np.abs(high)))
    kind = np.where(far < 1, 1, np.where(near > 1, 2, OPEN)).astype(np.int8)
    return kind, (high - low).argmax(0).astype(np.int8)


def whole(smallest: float = 2.0**-6, effort: Effort | None = None) -> Any:
    return subdivide(np.array([-2.0, -1.5]), np.array([2.0, 3.0]), off_circle, effort or Effort(), smallest)


def test_leaves_cover_the_box_once() -> None:
    tree = whole().tree
    leaves = np.flatnonzero(tree.axis < 0)
    low, high = tree.boxes(leaves)
    assert np.isclose((high - low).prod(0).sum(), 4 * 4.5)
    for n in np.flatnonzero(tree.axis >= 0)[:50]:
        first, second = tree.child[n], tree.child[n] + 1
        k = tree.axis[n]
        assert tree.high[k, first] == tree.low[k, second]
        assert (tree.low[:, first] == tree.low[:, n]).all()
        assert (tree.high[:, second] == tree.high[:, n]).all()


def test_what_stays_open_lies_on_the_circle_and_is_told() -> None:
    covered = whole()
    low, high = covered.tree.boxes(covered.tree.open)
    assert covered.reason is not None
    assert covered.reason.code == "boxes"
    assert (np.abs(np.hypot(*((low + high) / 2)) - 1) < 0.2).all()
    assert low.shape[1] > 20


def test_spent_effort_comes_back_with_what_there_is() -> None:
    covered = whole(2.0**-20, Effort(evaluations=200))
    assert covered.reason is not None
    assert covered.reason.code == "effort"
    assert (covered.tree.kind > 0).any()
    assert len(covered.tree.open)


def test_nothing_stays_open_where_all_is_decided() -> None:
    covered = subdivide(np.array([2.0, 0.0]), np.array([3.0, 1.0]), off_circle, Effort())
    assert covered.reason is None
    assert covered.tree.nodes < 64  # few boxes are halved at once


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


def test_fewer_boxes_at_once_make_a_smaller_tree() -> None:
    """A disc in the middle of a square: boxes that hold none of its rim are closed."""

    def judge(low: Any, high: Any) -> tuple[Any, Any]:
        near, far = np.maximum(np.maximum(low, -high), 0), np.maximum(np.abs(low), np.abs(high))
        away = ((near**2).sum(0) > 0.25) | ((far**2).sum(0) < 0.25)
        return np.where(away, 1, 0), (high - low).argmax(0)

    many, some = (subdivide(-np.ones(2), np.ones(2), judge, Effort(), 2.0**-6, few=few).tree for few in (96, 2))
    assert some.nodes < many.nodes
    assert (some.kind == 1).any()
