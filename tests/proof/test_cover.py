"""Coverings run through all given points in order, stop where halving does not help, and are not too fine."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve.errors import EffortError
from mpsolve.proof.cover import OpenPieceError, cover, covered, evened, joined
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


@given(st.lists(POINTS, max_size=4), st.floats(0.5, 30))
def test_several_paths_are_refined_as_each_by_itself(parts: list[list[complex]], length: float) -> None:
    """Whatever lies between them; what is too short is so of all of them."""
    test = shorter_than(lambda _: length)
    found = covered(parts, test, Effort())
    assert len(found) == len(parts)
    for one, points in zip(found, parts, strict=True):
        np.testing.assert_array_equal(one, cover(points, test, Effort()))


def test_several_paths_come_back_to_their_pieces() -> None:
    found = covered([[0, 1, 0], [1, 0, 1], [2, 2.5]], shorter_than(lambda _: 0.5), Effort())
    assert [one.tolist() for one in found] == [[0, 0.5, 1, 0.5, 0], [1, 0.5, 0, 0.5, 1], [2, 2.5]]
    assert covered([], shorter_than(lambda _: 0.5), Effort()) == []


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


def at_most(length: float) -> Any:
    return shorter_than(lambda _: length)


@given(st.lists(st.integers(1, 64), min_size=1, max_size=40), st.integers(64, 320))
def test_pieces_on_a_line_are_joined_and_still_pass(steps: list[int], length: int) -> None:
    points = np.concatenate([[0], np.cumsum(steps)]) + 2j
    found = joined(points, at_most(length), Effort(), rounds=40)
    assert (np.diff(found.real) > 0).all()
    assert (found[0], found[-1]) == (points[0], points[-1])
    assert set(found.tolist()) <= set(points.tolist())
    if len(found) > 1:
        assert np.diff(found.real).max() <= length
        together = found.real[2:] - found.real[:-2]
        assert (together > length).all()  # no two neighbours could be one


def test_corners_and_slanting_lines_are_kept() -> None:
    points = np.array([0, 1, 2, 2 + 1j, 2 + 2j, 3 + 3j, 4 + 4j, 3 + 4j])
    found = joined(points, at_most(100.0), Effort())
    assert found.tolist() == [0, 2, 2 + 2j, 3 + 3j, 4 + 4j, 3 + 4j]


def test_a_path_that_turns_back_keeps_the_point_where_it_turns() -> None:
    assert joined(np.array([0, 2, 1]), at_most(9.0), Effort()).tolist() == [0, 2, 1]


def test_a_path_that_may_run_anywhere_keeps_its_ends_only() -> None:
    assert joined(np.array([0, 1j, 1 + 1j, 5]), at_most(9.0), Effort(), anywhere=True).tolist() == [0, 5]


def test_what_is_tried_is_spent() -> None:
    effort = Effort(evaluations=100)
    joined(np.arange(9) + 0j, at_most(1.0), effort)
    assert effort.spent == 7  # each point between the ends once


def test_a_point_alone_and_a_piece_alone_stay() -> None:
    for points in ([1 + 0j], [0, 1 + 0j]):
        assert joined(np.array(points), at_most(9.0), Effort()).tolist() == points


def test_pieces_become_equally_hard() -> None:
    points = np.concatenate([np.linspace(0, 1, 65), np.linspace(1, 2, 9)[1:]]) + 0j
    hardness = np.abs(np.diff(points)) * 20  # the same everywhere, per length
    found = evened(points, hardness)
    assert (found[0], found[-1]) == (0, 2)
    assert len(found) < len(points) - 20
    lengths = np.abs(np.diff(found))
    assert np.allclose(lengths * 20, 1, rtol=0.06)


def test_harder_parts_get_shorter_pieces() -> None:
    points = np.linspace(0, 1, 101) + 0j
    hardness = np.where(points.real[:-1] < 0.5, 0.4, 0.1)
    found = evened(points, hardness)
    lengths = np.abs(np.diff(found))
    assert np.isclose(lengths[-3] / lengths[2], 4, rtol=1e-6)


def test_corners_stay_and_so_does_what_is_oblique() -> None:
    h = 0.04j
    points = np.concatenate(
        [np.linspace(h, 1 + h, 41), np.linspace(1 + h, 1, 11)[1:], np.linspace(1, 2 - 1j, 21)[1:]]
    )
    found = evened(points, np.full(len(points) - 1, 0.3))
    assert {h, 1 + h, 1 + 0j, 2 - 1j} <= set(found)
    assert len(found) < len(points)
    assert ((found.imag == h.imag) | (found.real == 1) | np.isin(found, points)).all()
    assert (found[-20:] == points[-20:]).all()


def test_pieces_that_are_too_hard_are_cut_up() -> None:
    points = np.array([0, 1, 2, 2 - 1j])
    found = evened(points, np.array([0.3, 3.5, 0.4]))
    assert {0, 2, 2 - 1j} <= set(found)
    assert len(found) == 6
    assert np.abs(np.diff(found[1:4])).max() < 1 / 3.5
