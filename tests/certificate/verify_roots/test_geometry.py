"""Polygons, cuts and regions of certificates of zeros: where they do not fit the path counts something else."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import pytest
from flint import fmpq

from mpsolve.certificate import verify_roots as vr
from mpsolve.certificate.verify2 import Refused


def exact(x: Any) -> Any:
    return fmpq(Fraction(x).numerator, Fraction(x).denominator)


def polygon(*corners: Sequence[Any]) -> list[Any]:
    return [(exact(x), exact(y)) for x, y in corners]


SQUARE = polygon((0, 0), (4, 0), (4, 4), (0, 4))
ELBOW = polygon((0, 0), (4, 0), (4, 4), (2, 4), (2, 2), (0, 2))


def test_simple_polygons_are_accepted() -> None:
    for fine in (SQUARE, ELBOW, polygon((0, 0), (1, 0), (0, 1)), polygon((0, 0), (2, 0), (4, 0), (0, 4))):
        vr.require_simple(fine)


BENT = {
    "two corners": (polygon((0, 0), (1, 0)), "too few corners"),
    "a corner twice": (polygon((0, 0), (4, 0), (4, 0), (0, 4)), "too few corners"),
    "turned right": (SQUARE[::-1], "does not turn left"),
    "of no area": (polygon((0, 0), (1, 0), (2, 0)), "does not turn left"),
    "back along an edge": (polygon((0, 0), (6, 0), (4, 0), (4, 4), (0, 4)), "overlap"),
    "a crossing": (polygon((0, 0), (8, 0), (8, 8), (4, -1), (0, 8)), "edges of the polygon meet"),
    "a corner on an edge": (polygon((0, 0), (8, 0), (8, 8), (4, 0), (0, 8)), "edges of the polygon meet"),
    "a corner on a corner": (polygon((0, 0), (2, -2), (4, 0), (2, 2), (0, 0), (-2, 2), (-2, -2)), "meet"),
}


@pytest.mark.parametrize("name", BENT)
def test_a_polygon_is_refused(name: str) -> None:
    corners, why = BENT[name]
    with pytest.raises(Refused, match=why):
        vr.require_simple(corners)


def cut(x: Any, y: Any, u: int, v: int, length: Any = None) -> vr.Cut:
    value = {"origin": [str(x), str(y)], "direction": [str(u), str(v)], "length": length and str(length)}
    return vr.read_cut(value)


@pytest.mark.parametrize(
    ("given", "why"),
    [
        ((0, 0, 1, 1), "parallel"),
        ((0, 0, 0, 0), "parallel"),
        ((0, 0, 2, 0), "parallel"),
        ((0, 0, 1, 0, -1), "length"),
    ],
)
def test_a_cut_is_refused(given: Any, why: str) -> None:
    with pytest.raises(Refused, match=why):
        cut(*given)


CUTS = {
    "a cross": ([cut(1, 2, 1, 0, 2), cut(2, 1, 0, 1, 2)], "two cuts meet"),
    "a tip on another": ([cut(1, 2, 1, 0, 2), cut(2, 2, 0, 1, 1)], "two cuts meet"),
    "one within another": ([cut(0, 2, 1, 0, 3), cut(1, 2, 1, 0, 1)], "two cuts meet"),
    "through a corner": ([cut(2, 2, 1, 0), cut(1, 4, 1, 0, "1/2")], "not convex"),
    "a tip on an edge": ([cut(1, 0, 0, 1, 1)], "ends on the boundary"),
    "from edge to edge": ([cut(1, -1, 0, 1, 9)], "divides"),
    "in and out again": ([cut(3, 1, 0, -1, 9), cut(1, 1, -1, 0, 9), cut(1, 3, 1, 0, 9)], "divides"),
}


@pytest.mark.parametrize("name", CUTS)
def test_cuts_that_do_not_fit_are_refused(name: str) -> None:
    cuts, why = CUTS[name]
    with pytest.raises(Refused, match=why):
        vr.legs_round(ELBOW, cuts)


def test_a_cut_through_a_corner_is_refused() -> None:
    kite = polygon((0, 0), (2, -2), (4, 0), (2, 2))
    for fine in ([cut(2, 0, 1, 0, 1)], [cut(2, "1/2", 1, 0)], [cut(9, 0, 1, 0)]):
        vr.legs_round(kite, fine)
    with pytest.raises(Refused, match="through a corner"):
        vr.legs_round(kite, [cut(2, 0, 1, 0)])


def test_a_cut_is_gone_in_and_out_or_round() -> None:
    assert len(vr.legs_round(SQUARE, [cut(2, 2, 1, 0)])) == 7
    assert len(vr.legs_round(SQUARE, [cut(1, 2, 1, 0, 2)])) == 6
    assert len(vr.legs_round(SQUARE, [cut(0, 0, 1, 0, 4)])) == 4
    assert len(vr.legs_round(SQUARE, [cut(9, 9, 1, 0)])) == 4


REGIONS: dict[str, tuple[Any, str]] = {
    "a list": ([], "no object"),
    "nothing known": ({"kind": "strip"}, "not known"),
    "no width": ({"kind": "rectangle", "re": ["1", "1"], "im": ["0", "1"]}, "empty"),
    "no height": ({"kind": "rectangle", "re": ["0", "1"], "im": ["1", "0"]}, "empty"),
    "no side": ({"kind": "half-plane", "side": "north", "at": "0", "bound": "1"}, "not known"),
    "a bound too small": ({"kind": "half-plane", "side": "upper", "at": "-2", "bound": "2"}, "too small"),
    "no disc": ({"kind": "disc", "centre": ["0", "0"], "radius": "0"}, "empty"),
    "crossed": ({"kind": "polygon", "vertices": [["0", "0"], ["1", "1"], ["1", "0"], ["0", "2"]]}, "polygon"),
}


@pytest.mark.parametrize("name", REGIONS)
def test_a_region_is_refused(name: str) -> None:
    value, why = REGIONS[name]
    with pytest.raises(Refused, match=why):
        vr.read_region(value)


def test_what_is_counted_holds_what_is_asked() -> None:
    box = vr.Region(polygon((1, 1), (3, 1), (3, 3), (1, 3)), None, "")
    disc = vr.Region([], ((exact(2), exact(2)), exact(2)), "")
    elbow = vr.Region(ELBOW, None, "")
    for counted, asked in ((SQUARE, box), (SQUARE, disc), (SQUARE, elbow), (ELBOW, elbow)):
        vr.check_holds(counted, asked)
    small = polygon((0, 0), (4, 0), (4, "5/2"), (0, "5/2"))
    outside = polygon((9, 0), (13, 0), (13, 4), (9, 4))
    for counted, asked, why in (
        (ELBOW, box, "nor convex"),
        (small, box, "does not hold the region"),
        (small, disc, "does not hold the disc"),
        (outside, disc, "does not hold the disc"),
    ):
        with pytest.raises(Refused, match=why):
            vr.check_holds(counted, asked)


def test_a_disc_is_inside_outside_or_neither() -> None:
    disc = vr.Region([], ((exact(0), exact(0)), exact(2)), "")
    box = vr.Region(SQUARE, None, "")
    for x, r, inside in ((0, 1, True), (1, 1, None), (3, 1, None), (4, 1, False), (0, 3, None), ("1/2", 1, True)):
        assert disc.place(vr.Root(exact(x), exact(0), exact(r), 1)) is inside
    for x, inside in ((2, True), (4, None), (6, False)):
        assert box.place(vr.Root(exact(x), exact(2), exact(1), 1)) is inside
