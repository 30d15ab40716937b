"""Strips hold the true crossing, and are thin; the curve next to it is proved, and passes it."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mpsolve import Problem, crossings, tracks, vehicles
from mpsolve.ranges.scope import Scope, scope_of
from mpsolve.ranges.strips import strips_of

PAIR = Problem(
    tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.4"), vehicles.train(vehicles.Mass(40), 2, "1.5"), v="0.7"
)
OVER = {"v": (Fraction(3, 5), Fraction(9, 10)), "scale.mass": (Fraction(1, 2), Fraction(2))}


@pytest.fixture(scope="module")
def scope() -> Scope:
    return scope_of(PAIR, OVER)


@pytest.fixture(scope="module")
def true(scope: Scope) -> Any:
    """(q̂, x̂, ŷ) of crossings over the velocity at a fixed mass, by the search in one parameter."""
    answer = crossings(PAIR, over={"v": OVER["v"]}, check=False)
    family = scope.family
    units = np.array([float(family.frequency_unit), *map(float, family.units)])
    return np.array([[float(c.q.mid()), float(c.value.mid()), 1.0] for c in answer.crossings]).T / units[:, None]


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
