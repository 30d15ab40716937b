"""Strips hold the true crossing, and are thin; the curve next to it is proved, and passes it."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from mpsolve.ranges.scope import Scope
from mpsolve.ranges.strips import Strips, free_cells, strips_of

HALF = np.array([[2e-4], [1e-3], [1e-3]])


def test_strips_hold_the_true_crossing(scope: Scope, true: Any) -> None:
    strips = strips_of(scope.matrix, true - HALF, true + HALF, scope.corners, 4096)
    place = ((true[1:, 0] - scope.low) / (scope.high - scope.low))[:, None]
    assert ((strips.low <= place) & (strips.high >= place)).all(0).any()
    assert (strips.high - strips.low).max() < 1e-3
    assert (np.abs(strips.near - true) <= HALF).all()


def test_a_leaf_without_a_root_has_no_strip(scope: Scope, true: Any) -> None:
    away = true + 3 * HALF
    assert not strips_of(scope.matrix, away - HALF, away + HALF, scope.corners, 4096).near.size


def test_the_cells_of_a_narrow_range_are_marked_as_far_as_its_ends_are_rounded() -> None:
    """A box of floats that ends a tenth of a cell before the edge of a cell may reach into it."""
    low, cells = np.array([1.0, 1.0]), 64
    high = low + 2.0**-40
    corners = np.append(0.0, low), np.append(1.0, high)
    nothing = np.zeros((3, 0))
    tree: Any = SimpleNamespace(open=(), boxes=lambda _: (nothing, nothing))
    for far, free in ((1e-3, False), (0.4, True)):
        ends = np.array([[30 + far], [7.5]]) / cells, np.array([[31 - far], [7.5]]) / cells
        found = free_cells(corners, tree, Strips(*ends, nothing), cells)
        assert found[29, 7] == found[31, 7] == free
        assert not found[30, 7]
