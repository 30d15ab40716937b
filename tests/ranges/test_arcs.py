"""Arcs of real roots of a pair of masses: real roots of another count lie in them; pieces that pass hold one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from chart_meetings import MEETINGS

from mpsolve.numbers.quadratic import Quadratic
from mpsolve.proof.subdivide import OPEN
from mpsolve.ranges.arcs import ArcJudge, arcs, arcs_over
from mpsolve.ranges.judge import ABSORBING, ARC, KNOWN, NONZERO, OUTSIDE, PASSIVE
from mpsolve.ranges.scope import Scope, checked_over, scope_of


def test_the_arc_passes_the_true_crossing(scope: Scope, true: Any) -> None:
    assert true.shape[1] == 1
    r = np.array([[1e-3], [2e-3], [2e-3]])
    found = arcs_over(scope.matrix, true, r)
    assert found.regular.all()
    piece = found.pieces(0.0, 0.1)
    assert piece.passes.all()
    away = found.place(np.abs(piece.centre) - piece.around, np.zeros(1)) * found.r
    assert (away < 1e-9).all()


def test_a_box_beside_it_has_no_arc(scope: Scope, true: Any) -> None:
    r = np.array([[1e-3], [2e-3], [2e-3]])
    found = arcs_over(scope.matrix, true + 3 * r, r)
    assert not found.pieces(0.0, 0.1).passes.any()


def test_a_model_with_a_known_arc() -> None:
    """s = u₀ − t² + i (u₁ − t/2): the zeros are (t², t/2)."""
    k = np.zeros((10, 1), complex)
    k[1], k[9], k[2], k[3] = 1, -1, 1j, -0.5j
    from mpsolve.ranges.arcs import _pieces

    sharp, wide = (_pieces(Quadratic(k, np.array([e]), 3), 0.4, 0.05) for e in (0.0, 1.0))
    assert sharp.passes.all()
    assert not wide.passes.any()
    for tau in np.linspace(-0.05, 0.05, 9):
        zero = np.array([[(0.4 + tau) ** 2], [(0.4 + tau) / 2]])
        assert (np.abs(zero - sharp.centre - sharp.lean * tau) <= sharp.around).all()
    assert (sharp.around < 3e-3).all()


def test_a_box_round_it_is_a_leaf(scope: Scope, true: Any) -> None:
    half = np.array([[2e-4], [1e-3], [1e-3]])
    kind, _ = scope.judge(ArcJudge)(true - half, true + half)
    assert kind.tolist() == [ARC]


@pytest.fixture(scope="module")
def corner() -> tuple[Scope, Any]:
    """Where a curve of pairs ends on one of divergences, v = 1.1971153 and c = 0.3151861, and its place, scaled."""
    problem, over = MEETINGS["pair from q = 0"]
    scope = scope_of(problem, checked_over(problem, over))
    units = np.array([1.0, *map(float, scope.family.units)])
    return scope, (np.array([0.0, 1.1971153, 0.3151861]) / units)[:, None]


def test_a_box_at_zero_has_an_arc_of_each_kind(corner: tuple[Scope, Any]) -> None:
    scope, at = corner
    half = np.full((3, 1), 3e-4)
    low = np.where(np.arange(3)[:, None] == 0, 0.0, at - half)
    kind, _ = scope.judge(ArcJudge)(low, at + half)
    assert kind.tolist() == [ARC]
    found, closed = arcs(scope.matrix, low, at + half)
    assert closed.all()
    assert found.at_zero.tolist() == [False, True]
    place = [found.take(np.array([k])) for k in range(2)]
    for one in place:  # both pass the point, to within what is known of it
        t = one.along((at - one.m) / one.r)
        piece = one.pieces(t, 0.0)
        assert piece.passes.all()
        assert (np.abs(one.m + one.place(piece.centre, t) * one.r - at) < 1e-6).all()


def test_a_box_beside_the_curve_of_pairs_has_the_other_alone(corner: tuple[Scope, Any]) -> None:
    """Along the divergence, away from the end of the pairs: roots beside q = 0 are excluded."""
    scope, _ = corner
    units = np.array([1.0, *map(float, scope.family.units)])
    on = (np.array([0.0, 1.17397, 0.29]) / units)[:, None]
    half = np.array([[3e-4], [1e-3], [1e-3]])
    low = np.where(np.arange(3)[:, None] == 0, 0.0, on - half)
    found, closed = arcs(scope.matrix, low, on + half)
    assert closed.all()
    assert found.at_zero.tolist() == [True]
    away = on + np.array([[0.0], [0.0], [2e-2]])
    low = np.where(np.arange(3)[:, None] == 0, 0.0, away - half)
    none, closed = arcs(scope.matrix, low, away + half)
    assert closed.all()
    assert not len(none.pivot)


def test_kinds_of_leaves_are_told_apart() -> None:
    """Trees of charts have both kinds of leaves in one array."""
    kinds = [OPEN, NONZERO, PASSIVE, ABSORBING, KNOWN, OUTSIDE, ARC]
    assert len(set(kinds)) == len(kinds)
