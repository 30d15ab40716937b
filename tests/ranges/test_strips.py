"""Strips hold the true crossing, and are thin; the curve next to it is proved, and passes it."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.ranges.scope import Scope
from mpsolve.ranges.strips import strips_of

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
