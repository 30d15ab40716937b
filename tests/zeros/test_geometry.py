"""Exact geometry: boxes inside, outside or across an edge; points; polygons that are grown."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve.zeros.geometry import grown, is_inside, place_of_box

F = Fraction
SQUARE = ((F(0), F(0)), (F(2), F(0)), (F(2), F(2)), (F(0), F(2)))
ELL = ((F(0), F(0)), (F(4), F(0)), (F(4), F(1)), (F(1), F(1)), (F(1), F(4)), (F(0), F(4)))


@pytest.mark.parametrize(
    ("low", "high", "place"),
    [
        ((F(1, 4), F(1, 4)), (F(1, 2), F(1, 2)), True),
        ((F(2), F(2)), (F(3), F(3)), False),
        ((F(-3), F(-3)), (F(-1), F(-1)), False),
        ((F(1, 2), F(1, 2)), (F(2), F(2)), None),
        ((F(-1), F(-1)), (F(9), F(9)), None),
        ((F(2), F(1, 4)), (F(3), F(1, 2)), True),
        ((F(0), F(1, 4)), (F(1, 2), F(1, 2)), None),
    ],
)
def test_boxes_in_an_ell(low: tuple[F, F], high: tuple[F, F], place: bool | None) -> None:
    assert place_of_box(ELL, low, high) is place


def test_inside_a_polygon() -> None:
    assert is_inside(ELL, (F(1, 2), F(3)))
    assert not is_inside(ELL, (F(2), F(3)))


def test_grown_holds_the_polygon() -> None:
    larger = grown(SQUARE, F(1, 10))
    assert larger is not None
    assert all(is_inside(larger, p) for p in SQUARE)
    assert grown(ELL, F(1, 10)) is None
