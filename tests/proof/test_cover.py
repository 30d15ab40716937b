"""Coverings run through all given points in order, and stop where halving does not help."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.errors import EffortError
from mpsolve.proof.cover import OpenPieceError, cover
from mpsolve.proof.effort import Effort

POINTS = st.lists(st.complex_numbers(max_magnitude=100, allow_nan=False), min_size=2, max_size=8)


def shorter_than(length: Any) -> Any:
    return lambda a, b: np.abs(b - a) <= length(a)


@given(POINTS, st.floats(0.5, 30))
def test_pieces_pass_and_the_path_runs_through_all_points_in_order(points: list[complex], length: float) -> None:
    found = cover(points, shorter_than(lambda _: length), Effort())
    assert (np.abs(np.diff(found)) <= length).all()
    at = 0
    for point in points:  # each is found behind the one before, also where points come again
        at += int(np.flatnonzero(found[at:] == point)[0])
    assert found[0] == points[0]
    assert found[-1] == points[-1]
    total = np.abs(np.diff(points)).sum()
    assert np.abs(np.diff(found)).sum() == pytest.approx(total)


def test_a_path_that_comes_back_to_a_point_is_not_cut_short() -> None:
    points = np.array([0, 1, 1, 2j, 0, 1, -3])
    found = cover(points, shorter_than(lambda a: np.where(a.real > 0.4, 0.3, 1.0)), Effort())
    assert np.abs(np.diff(found)).sum() == pytest.approx(np.abs(np.diff(points)).sum())
    assert found[-1] == -3


def test_no_more_pieces_than_twice_what_is_needed() -> None:
    found = cover([0, 8], shorter_than(lambda _: 1.0), Effort())
    assert found.tolist() == list(range(9))


def test_where_halving_does_not_help_the_place_is_named() -> None:
    with pytest.raises(OpenPieceError, match=r"near 0\.3") as caught:
        cover([0, 1], lambda a, b: ~((a.real <= 0.3) & (b.real >= 0.3)), Effort())
    assert abs(caught.value.place - 0.3) < 1e-9


def test_pieces_that_floats_cannot_halve_are_given_up() -> None:
    a = 1e8
    with pytest.raises(OpenPieceError):
        cover([a, np.nextafter(a, 2 * a)], lambda a, _: np.zeros(len(a), bool), Effort(evaluations=100))


def test_effort_ends_it() -> None:
    effort = Effort(evaluations=10)
    with pytest.raises(EffortError):
        cover([0, 1], shorter_than(lambda _: 1e-3), effort)
    assert effort.spent > 10


def test_pieces_may_be_halved_elsewhere() -> None:
    on_circle = cover([1, 1j], shorter_than(lambda _: 0.1), Effort(), middle=lambda a, b: (a + b) / np.abs(a + b))
    assert np.abs(on_circle) == pytest.approx(np.ones(len(on_circle)))
