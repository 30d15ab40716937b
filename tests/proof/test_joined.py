"""Joined pieces still pass, the path stays where it was, and it has not many more of them than it needs."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.proof.effort import Effort
from mpsolve.proof.joined import joined


def shorter_than(length: float) -> Any:
    return lambda a, b: np.abs(b - a) <= length


@given(st.lists(st.integers(1, 64), min_size=1, max_size=40), st.integers(64, 320))
def test_pieces_on_a_line_are_joined_and_still_pass(steps: list[int], length: int) -> None:
    points = np.concatenate([[0], np.cumsum(steps)]) + 2j
    found = joined(points, shorter_than(length), Effort(), rounds=40)
    assert (np.diff(found.real) > 0).all()
    assert (found[0], found[-1]) == (points[0], points[-1])
    assert set(found.tolist()) <= set(points.tolist())
    if len(found) > 1:
        assert np.diff(found.real).max() <= length
        together = found.real[2:] - found.real[:-2]
        assert (together > length).all()  # no two neighbours could be one


def test_corners_and_slanting_lines_are_kept() -> None:
    points = np.array([0, 1, 2, 2 + 1j, 2 + 2j, 3 + 3j, 4 + 4j, 3 + 4j])
    found = joined(points, shorter_than(100.0), Effort())
    assert found.tolist() == [0, 2, 2 + 2j, 3 + 3j, 4 + 4j, 3 + 4j]


def test_a_path_that_turns_back_keeps_the_point_where_it_turns() -> None:
    assert joined(np.array([0, 2, 1]), shorter_than(9.0), Effort()).tolist() == [0, 2, 1]


def test_a_path_that_may_run_anywhere_keeps_its_ends_only() -> None:
    assert joined(np.array([0, 1j, 1 + 1j, 5]), shorter_than(9.0), Effort(), anywhere=True).tolist() == [0, 5]


def test_what_is_tried_is_spent() -> None:
    effort = Effort(evaluations=100)
    joined(np.arange(9) + 0j, shorter_than(1.0), effort)
    assert effort.spent == 7  # each point between the ends once


def test_a_point_alone_and_a_piece_alone_stay() -> None:
    for points in ([1 + 0j], [0, 1 + 0j]):
        assert joined(np.array(points), shorter_than(9.0), Effort()).tolist() == points
