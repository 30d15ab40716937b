"""The path closes, keeps the region to its left, and goes in and out along cuts."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest

from mpsolve.errors import InputError
from mpsolve.zeros.path import legs_round
from mpsolve.zeros.regions import Cut, Polygon, Rectangle

BOX = Rectangle(-2, 2, -1, 1).polygon


def test_without_cuts_it_is_the_polygon() -> None:
    legs = legs_round(BOX, [])
    assert [leg.a for leg in legs] == list(BOX)


def test_a_cut_from_outside_is_gone_in_and_out() -> None:
    legs = legs_round(BOX, [Cut.ray(0, 1j), Cut.ray(1, 1)])
    assert len(legs) == 4 + 3 + 3
    assert all(one.b == two.a for one, two in pairwise(legs))
    assert legs[-1].b == legs[0].a
    assert sum((leg.a == (0, 0)) + (leg.b == (0, 0)) for leg in legs) == 2


def test_a_cut_inside_is_gone_round_by_itself() -> None:
    legs = legs_round(BOX, [Cut.segment(-1, 1)])
    assert [(leg.a, leg.b) for leg in legs[4:]] == [((-1, 0), (1, 0)), ((1, 0), (-1, 0))]


def test_cuts_outside_or_along_an_edge_are_left_out() -> None:
    assert len(legs_round(BOX, [Cut.ray(5j, 1j), Cut.ray(-2 - 9j, 1j), Cut.segment(5, 6)])) == 4


def test_a_cut_on_the_line_of_an_edge_may_go_on_inside_where_the_region_is_not_convex() -> None:
    ell = Polygon([0, 4, 4 + 1j, 1 + 1j, 1 + 4j, 4j]).polygon
    with pytest.raises(InputError, match="not convex"):
        legs_round(ell, [Cut.ray((Fraction(1, 2), Fraction(1)), -1)])


@pytest.mark.parametrize(
    "pair",
    [
        (Cut.ray(0, -1), Cut.ray(0, -1)),
        (Cut.ray(0, -1), Cut.ray(-1, -1)),
        (Cut.ray(0, -1), Cut.ray(-1, 1)),
        (Cut.ray(0, -1), Cut.ray(0, 1j)),
        (Cut.ray(0.5, -1), Cut.segment(-0.5j, 0.5j)),
        (Cut.segment(-0.5j, 0.5j), Cut.segment(-1, 1)),
    ],
)
def test_cuts_that_meet_are_refused(pair: tuple[Cut, Cut]) -> None:
    for cuts in (pair, pair[::-1]):
        with pytest.raises(InputError, match="meet"):
            legs_round(BOX, cuts)
    assert len(legs_round(BOX, [Cut.ray(0.5, 1), Cut.ray(-0.5, -1)])) == 10


@pytest.mark.parametrize(
    "cut",
    [Cut.ray(-5, 1), Cut.segment(-5, 5), Cut.ray(2, 1), Cut.ray(1j, -1j), Cut.ray((Fraction(2), Fraction(-3)), 1)],
)
def test_cuts_that_divide_end_on_the_boundary_or_meet_a_corner_are_refused(cut: Cut) -> None:
    if cut.origin == (2, -3):  # passes outside
        assert len(legs_round(BOX, [cut])) == 4
        return
    with pytest.raises(InputError):
        legs_round(BOX, [cut])
