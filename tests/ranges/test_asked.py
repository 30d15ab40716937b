"""What is asked of boxes, on slices chosen by hand; what is not asked is not judged."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.ranges.asked import Asked, AskedJudge
from mpsolve.ranges.judge import NOT_ASKED

ASKED = Asked(
    low=np.array([1.0, 2.0]),
    high=np.array([1.0, 2.0]),
    ends=np.array([5.0, 3.0]),
    room_low=np.array([[0.4, 0.4], [4.5, 2.5]]),
    room_high=np.array([[0.6, 0.6], [5.5, 3.5]]),
)


def box(*sides: tuple[float, float]) -> tuple[Any, Any]:
    low, high = zip(*sides, strict=True)
    return np.array(low)[:, None], np.array(high)[:, None]


def test_slices_that_a_box_meets_below_their_ends() -> None:
    assert ASKED.needed(*box((0, 1), (0, 1), (0, 3))).tolist() == [[True, True]]
    assert ASKED.needed(*box((0, 1), (3.1, 4), (0, 3))).tolist() == [[True, False]]
    assert ASKED.needed(*box((0, 1), (5.1, 6), (0, 3))).tolist() == [[False, False]]
    assert ASKED.needed(*box((0, 1), (0, 1), (1.1, 1.9))).tolist() == [[False, False]]
    assert ASKED.needed(*box((0, 1), (5, 6), (1, 1.5))).tolist() == [[True, False]]  # ends belong to it


def test_a_room_holds_a_box_as_a_whole() -> None:
    assert ASKED.needed(*box((0.45, 0.55), (4.6, 5), (0, 3))).tolist() == [[False, False]]
    assert ASKED.needed(*box((0.45, 0.65), (4.6, 5), (0, 3))).tolist() == [[True, False]]
    assert ASKED.needed(*box((0.45, 0.55), (2.6, 3.4), (0, 3))).tolist() == [[True, False]]


@dataclass
class Seen:
    """A judge that decides nothing and remembers."""

    boxes: Any = None

    def __call__(self, low: Any, high: Any) -> tuple[Any, Any]:
        self.boxes = (low, high)
        return np.zeros(low.shape[1], np.int8), np.ones(low.shape[1], np.int8)


def test_boxes_are_judged_over_what_is_asked() -> None:
    inner = Seen()
    one, other = box((0, 1), (0, 4), (0.5, 1.5)), box((0, 1), (6, 7), (0, 3))
    low, high = np.hstack([one[0], other[0]]), np.hstack([one[1], other[1]])
    kind, axis = AskedJudge(inner, ASKED)(low, high)  # type: ignore[arg-type]
    assert kind.tolist() == [0, NOT_ASKED]
    assert axis[0] == 1
    assert inner.boxes[0].T.tolist() == [[0, 0, 1]]
    assert inner.boxes[1].T.tolist() == [[1, 4, 1]]
    AskedJudge(inner, ASKED)(*box((0, 1), (0, 9), (1.5, 3)))  # type: ignore[arg-type]
    assert inner.boxes[1].T.tolist() == [[1, 3, 2]]
