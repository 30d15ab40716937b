"""Points of known curves, shuffled, come back in their order."""

from __future__ import annotations

from typing import Any

import numpy as np

from mpsolve.ranges.ordered import Path, ordered

CORNERS = np.zeros(3), np.ones(3)


def paths(curve: Any, t: Any) -> list[Path]:
    """Of the points at t in another order; at the edge the curve is met by bisection in t."""
    t = np.random.default_rng(1).permutation(t)
    points, ahead = curve(t), curve(t + 1e-6) - curve(t)

    def corrected(seeds: Any, k: int) -> Any:
        fine = np.linspace(t.min() - 0.05, t.max() + 0.05, 200001)
        near = np.abs(curve(fine) - seeds).sum(0)
        near[np.abs(curve(fine)[k] - seeds[k]) > 1e-4] = np.inf
        return curve(fine[near.argmin() : near.argmin() + 1])

    return ordered(points, ahead / np.linalg.norm(ahead, axis=0), CORNERS, corrected)


def test_a_circle_comes_back() -> None:
    t = np.linspace(0, 2 * np.pi, 900, endpoint=False)
    (path,) = paths(lambda t: np.stack([0.5 + 0.1 * np.cos(t), 0.5 + 0.3 * np.cos(t), 0.5 + 0.3 * np.sin(t)]), t)
    assert path.whole
    assert (path.points[:, 0] == path.points[:, -1]).all()
    angle = np.unwrap(np.arctan2(path.points[2] - 0.5, path.points[1] - 0.5))
    assert abs(abs(angle[-1] - angle[0]) - 2 * np.pi) < 1e-9
    assert (np.diff(angle) > 0).all() or (np.diff(angle) < 0).all()


def test_a_fold_from_edge_to_edge_in_spite_of_a_crossing_curve_at_another_frequency() -> None:
    def fold(t: Any) -> Any:
        return np.stack([0.3 + 0.1 * t, 1 - (t - 0.5) ** 2 * 3, t])

    t = np.linspace(0.001, 0.999, 900)
    (path,) = [one for one in paths(fold, t) if one.points.shape[1] > 100]
    assert path.whole
    assert {round(float(x), 3) for x in path.points[1, [0, -1]]} <= {0.25, 0.251, 0.249, 0.0}
    y = path.points[2]
    assert (np.diff(y) > 0).all() or (np.diff(y) < 0).all()


def test_nothing_of_too_little() -> None:
    assert ordered(np.zeros((3, 1)), np.ones((3, 1)), CORNERS, lambda seeds, _: seeds) == []
