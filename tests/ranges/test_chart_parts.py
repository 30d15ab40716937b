"""Parts of a chart: each has the number of the certified point in it, and what is not counted is open."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from free_cases import BEAM, PAIR

from mpsolve import Effort, Problem, certify
from mpsolve.progress import silent
from mpsolve.ranges import chart_parts
from mpsolve.ranges.cells import OPEN
from mpsolve.ranges.chart_parts import counted, point_in

PROBLEM = Problem(BEAM, PAIR, v="0.9")
OVER = {"v": (Fraction(1, 2), Fraction(1)), "scale.mass": (Fraction(1), Fraction(2))}
EDGES = tuple(tuple(a + (b - a) * Fraction(k, 4) for k in range(5)) for a, b in OVER.values())


def of(fine: Any, spent: int = 0) -> Any:
    detail, effort = np.where(fine > 0, 0, -1), Effort(evaluations=100)
    effort.spend(spent)
    found = counted(PROBLEM, OVER, EDGES, (fine, fine), detail, effort, silent, False)
    return (*found, detail)


def test_parts_are_counted_at_a_point_the_greatest_first(monkeypatch: pytest.MonkeyPatch) -> None:
    fine = np.array([[1, 1, 0, 0], [1, 1, 0, 0], [0, 0, 0, 0], [2, 2, 2, 2]])
    fine[0] = 1
    found, regions, reason, detail = of(fine)
    assert reason is None
    assert [part.cells for part in found] == [6, 4]
    for number, part in enumerate(found):
        where = regions == number
        assert where.sum() == part.cells
        assert (detail[where] == part.roots).all()
        i, j = (int((part.point[path] - a) / (b - a) * 4) for path, (a, b) in OVER.items())
        assert where[i, j]
        point = PROBLEM.changed("v", part.point["v"]).changed("scale.mass", part.point["scale.mass"])
        assert certify(point, region="unstable", check=False).unstable == part.roots
    assert (detail[regions < 0] == -1).all()
    monkeypatch.setattr(chart_parts, "_MOST_PARTS", 1)
    found, regions, reason, detail = of(fine)
    assert (len(found), reason.code) == (1, "parts")
    assert (detail[fine == 2] == OPEN).all()
    assert (regions[fine == 2] == -1).all()


def test_what_effort_does_not_reach_is_open() -> None:
    found, regions, reason, detail = of(np.ones((4, 4), int), 100)
    assert reason is not None
    assert (found[0].roots, found[0].spectrum) == (None, None)
    assert (detail == OPEN).all()
    assert (regions == -1).all()


def test_a_point_is_the_middle_of_an_inner_cell() -> None:
    where = np.zeros((4, 4), bool)
    where[2, 3] = True
    assert point_in(OVER, EDGES, where) == {"v": Fraction(13, 16), "scale.mass": Fraction(15, 8)}
