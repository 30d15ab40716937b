"""Charts in which curves touch each other or themselves. Truths: points at which they do, found by Newton's method on
the conditions of touching in floats, and counts in floats on all sides.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from chart_counts import floats_agree
from chart_meetings import MEETINGS, beam

from mpsolve import Problem, vehicles
from mpsolve.ranges.chart import Chart, stability_chart

EQUAL = Problem(beam("0.2"), [vehicles.Mass(20).at(x) for x in (0, "1.54", "3.2")], v=1)
PAIRS = MEETINGS["two pairs"][0]
TOUCH = Fraction("1.69194804729308"), Fraction("1.07379757630732"), Fraction("4.9107658734938")
"""The mass in the middle with which two curves touch, v and the factor of masses there: q = 0.2155 and 0.1228."""
SADDLE = Fraction("1.1236935897490636"), Fraction("3.157858495524392"), Fraction("2.27029228981327")
"""v and the distances at which the part of a root below the axis hangs together with another one."""
LEAST = Fraction("1.0880289335323778"), Fraction("2.383246381561712"), Fraction("2.383246381561712")
"""v and the distances at which a root touches the axis from above."""


def near(problem: Problem, paths: tuple[str, str], at: tuple[Fraction, Fraction], half: tuple[str, str]) -> Chart:
    """The chart round a point, which is not in its middle."""
    ends = zip(paths, at, map(Fraction, half), strict=True)
    over: dict[str, Any] = {path: (x - h, x + Fraction(107, 100) * h) for path, x, h in ends}
    return stability_chart(problem, over=over, depth=3, check=False)


def gaps(v: Fraction, at: tuple[Fraction, Fraction]) -> Chart:
    return near(EQUAL.changed("v", v), ("gap[0]", "gap[1]"), at, ("0.05", "0.05"))


def numbers(found: Chart) -> list[int]:
    """Of roots in the parts of some size."""
    return sorted(part.roots for part in found.parts if part.cells > 20 and part.roots is not None)


def agree(found: Chart, number: int = 300) -> None:
    """Every decided cell that is looked at has the number that floats count in it; little stays open."""
    floats_agree(found, number, 0.95)
    assert found.share > 0.85


@pytest.mark.parametrize(
    ("more", "half", "meet", "regions"),
    [
        (0, ("0.01", "0.3"), 0, [0, 4]),
        (Fraction(1, 10**6), ("0.01", "0.3"), 2, [0, 4]),  # a sickle with 2 between them, thinner than a cell
        (Fraction(-1, 100), ("0.001", "0.03"), 0, [0, 2, 2, 4]),  # apart: 2 all the way between them
    ],
)
def test_two_curves_that_touch(more: Any, half: tuple[str, str], meet: int, regions: list[int]) -> None:
    mass, *at = TOUCH
    found = near(PAIRS.changed("vehicles[1].M", mass + more), ("v", "scale.mass"), (at[0], at[1]), half)
    assert found.traced
    assert len(found.boundaries) == 2
    assert len(found.meetings) == meet
    assert numbers(found) == regions
    agree(found)


@pytest.mark.parametrize(
    ("more", "regions", "whole"),
    [(0, [0, 0, 2, 2], False), (Fraction(1, 10**4), [0, 0, 2], True), (Fraction(-1, 10**4), [0, 2, 2], True)],
)
def test_a_curve_that_meets_itself(more: Any, regions: list[int], whole: bool) -> None:
    """Its four branches are two curves on either side, and end before the point itself."""
    v, *at = SADDLE
    found = gaps(v + more, (at[0], at[1]))
    assert numbers(found) == regions
    assert found.traced == whole
    assert len(found.boundaries) == (2 if whole else 4)
    agree(found)


@pytest.mark.parametrize(("more", "inside"), [(0, 0), (Fraction(-1, 10**6), 0), (Fraction(3, 10**5), 2)])
def test_a_root_that_touches_the_axis_at_one_point(more: Any, inside: int) -> None:
    """Beyond it there is a closed curve; where it is a point, its cell stays open."""
    v, *at = LEAST
    found = gaps(v + more, (at[0], at[1]))
    assert numbers(found) == [0, 2][: 1 + inside // 2]
    assert found.at(*at) in {None, inside}
    assert found.traced == (more != 0)
    assert len(found.boundaries) == inside // 2
    assert more <= 0 or found.at(*at) == 2
    assert found.share > (0.92 if inside else 0.98)
    agree(found)
