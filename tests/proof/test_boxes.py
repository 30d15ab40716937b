"""Boxes cover all of what was given; what cannot pass is named with its place."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from mpsolve.errors import EffortError
from mpsolve.proof.boxes import OpenBoxError, cover_boxes
from mpsolve.proof.effort import Effort


class Recorder:
    """Passes boxes whose longest side is short enough at their distance from a point."""

    def __init__(self, point: tuple[float, float]) -> None:
        self.point, self.passed = np.array(point), []

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        near = np.abs(np.clip(self.point, low, high) - self.point).max(1)
        fine = (high - low).max(1) < near
        self.passed.append(np.concatenate([low[fine], high[fine]], 1))
        return fine, (high - low).argmax(1)


def test_the_boxes_that_passed_are_the_whole_region_without_overlap() -> None:
    test = Recorder((1.3, 0.5))
    count = cover_boxes([[0, 0], [0.5, 0]], [[0.5, 1], [1, 1]], test, Effort(evaluations=10_000))
    boxes = np.concatenate(test.passed)
    assert count == len(boxes)
    assert abs(((boxes[:, 2] - boxes[:, 0]) * (boxes[:, 3] - boxes[:, 1])).sum() - 1) < 1e-12
    points = np.random.default_rng(1).uniform(size=(400, 2))
    inside = (points[:, None] >= boxes[None, :, :2]) & (points[:, None] <= boxes[None, :, 2:])
    assert inside.all(2).any(1).all()


def test_a_place_where_no_box_passes_is_named() -> None:
    with pytest.raises(OpenBoxError, match="do not pass near") as caught:
        cover_boxes([[0, 0]], [[1, 1]], Recorder((0.3, 0.7)), Effort(evaluations=10**6))
    assert np.allclose(caught.value.place, (0.3, 0.7), atol=1e-5)


def test_the_effort_ends_the_work() -> None:
    with pytest.raises(EffortError):
        cover_boxes([[0, 0]], [[1, 1]], Recorder((0.3, 0.7)), Effort(evaluations=20))
