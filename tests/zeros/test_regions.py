"""Regions are exact: corners, discs inside their polygons, boxes inside or outside, and what is no region refused."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve.errors import InputError
from mpsolve.zeros.geometry import distance_squared, edges, is_simple, place_of_box
from mpsolve.zeros.regions import Cut, Disc, HalfPlane, Polygon, Rectangle, place_in

F = Fraction
SQUARE = ((F(0), F(0)), (F(2), F(0)), (F(2), F(2)), (F(0), F(2)))
ELL = ((F(0), F(0)), (F(4), F(0)), (F(4), F(1)), (F(1), F(1)), (F(1), F(4)), (F(0), F(4)))


def test_a_disc_lies_inside_its_polygon_and_close_to_it() -> None:
    disc = Disc(1 - 2j, "0.1")
    for a, b in edges(disc.polygon):
        assert disc.radius**2 < distance_squared(disc.centre, a, b) < disc.radius**2 * F(102, 100)


def test_a_polygon_is_turned_left_and_must_be_simple() -> None:
    assert Polygon([0, 2j, 2 + 2j, 2]).vertices[0] == (F(2), F(0))
    assert is_simple(ELL)
    for bad in ([0, 1], [0, 1, 2], [0, 2 + 2j, 2, 2j], [0, 1, 1, 1j], [0, 2, 1, 1j]):
        with pytest.raises(InputError):
            Polygon(bad)


def test_boxes_in_a_rectangle_and_a_disc() -> None:
    assert place_of_box(SQUARE, (F(1), F(1)), (F(3, 2), F(3, 2))) is True
    assert place_of_box(SQUARE, (F(1), F(1)), (F(2), F(2))) is None
    assert place_of_box(SQUARE, (F(3), F(1)), (F(4), F(2))) is False
    disc = Disc(0, 1)
    assert place_in(disc, (F(0), F(0)), (F(1, 2), F(1, 2))) is True
    assert place_in(disc, (F(0), F(0)), (F(3, 5), F(4, 5))) is None
    assert place_in(disc, (F(4, 5), F(4, 5)), (F(1), F(1))) is False


@pytest.mark.parametrize(
    ("make", "key"),
    [
        (lambda: Rectangle(1, 0, 0, 1), "region.re_max"),
        (lambda: Disc(0, 0), "region.radius"),
        (lambda: HalfPlane("above", 3), "region.side"),
        (lambda: HalfPlane("upper", 3, at=4), "region.bound"),
        (lambda: Cut.ray(0, 0), "cuts"),
        (lambda: Cut.segment(1, 1), "cuts"),
        (lambda: Cut(0, 1), "cuts"),
    ],
)
def test_what_is_no_region_is_refused(make: object, key: str) -> None:
    with pytest.raises(InputError) as found:
        make()  # type: ignore[operator]
    assert found.value.key == key


def test_a_cut_knows_its_points() -> None:
    ray, segment = Cut.ray(1j, 1j), Cut.segment(-1, 2)
    assert ray.holds((F(0), F(2)), (F(0), F(9)))
    assert not ray.holds((F(0), F(0)), (F(0), F(2)))
    assert segment.tips == ((F(-1), F(0)), (F(2), F(0)))
    assert not segment.holds((F(0), F(0)), (F(3), F(0)))
