"""A curve of real roots from chains of boxes passes the true crossing; points that are wrong are not believed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from chart_pair import OVER, PAIR

from mpsolve import crossings
from mpsolve.ranges.boundary import Curves, boundaries, proved_chains
from mpsolve.ranges.ordered import Path
from mpsolve.ranges.scope import Scope


def curves(scope: Scope) -> Curves:
    return Curves(scope.matrix, False, scope.corners[1] - scope.corners[0])


def near(scope: Scope, true: Any, number: int) -> Any:
    """Points on the curve from the true crossing on, by steps and corrections in floats."""
    whole, points = scope.corners[1] - scope.corners[0], [true]
    for _ in range(number - 1):
        _, way, _ = curves(scope).on(points[-1])
        step = way * whole[:, None]
        points.append(curves(scope).on(points[-1] + step / np.abs(step[1:] / whole[1:, None]).max() * 0.003)[0])
    return np.concatenate(points, 1)


def test_points_are_put_on_the_curve(scope: Scope, true: Any) -> None:
    found, ahead, _ = curves(scope).on(true + np.array([[1e-5], [0.0], [0.0]]))
    assert (np.abs(found - true) < 1e-4).all()
    assert np.linalg.norm(ahead) == pytest.approx(1)
    moved, _, _ = curves(scope).on(true + np.array([[1e-5], [1e-5], [0.0]]), 2)
    assert (np.abs(moved - true) < 1e-9).all()


def test_a_chain_is_proved_and_passes_the_true_crossing(scope: Scope, true: Any) -> None:
    points = near(scope, true, 8)
    (curve,) = proved_chains(curves(scope), [Path(points, False)], np.ones(3))
    assert not curve.whole
    assert not curve.divergence
    assert max(curve.radius) < 1e-6
    assert min(np.hypot(curve.x - true[1, 0], curve.y - true[2, 0])) < 1e-9
    found = crossings(
        PAIR.changed("scale.mass", curve.y[-1].item() * float(scope.family.units[1])),
        over={"v": OVER["v"]},
        check=False,
    ).crossings
    unit = float(scope.family.units[0])
    assert min(abs(float(one.value.mid()) / unit - curve.x[-1]) for one in found) < 1e-6


def test_a_path_off_the_curve_is_not_believed(scope: Scope, true: Any) -> None:
    """Points are put between that are right; the wrong ones are left out, and the curve is not whole."""
    points = near(scope, true, 3)
    wrong = points + np.array([[0.0], [1e-3], [0.0]])
    for curve in proved_chains(curves(scope), [Path(wrong, True)], np.ones(3)):
        assert not curve.whole
        assert not set(curve.x) & set(wrong[1])
        on = curves(scope).on(np.stack([curve.q, curve.x, curve.y]))[0]
        assert (np.abs(on[1:] - np.stack([curve.x, curve.y])) < 1e-9).all()


def test_nothing_of_too_few_points(scope: Scope, true: Any) -> None:
    assert boundaries(scope.matrix, true, scope.corners, (1.0, 1.0, 1.0)) == ()
