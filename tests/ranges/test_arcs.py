"""Arcs of real roots of a pair of masses: real roots of another count lie in them; pieces that pass hold one."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.numbers.quadratic import Quadratic
from mpsolve.ranges.arcs import ARC, ArcJudge, arcs_over
from mpsolve.ranges.scope import Scope


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
