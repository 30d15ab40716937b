"""Entries are asked together where a line of the table may be; each stands in its place."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Case, stability_table
from mpsolve.problem.cases import as_problem
from mpsolve.problem.over import Over
from mpsolve.ranges import table_lines
from mpsolve.ranges.entry import Job
from mpsolve.ranges.table_lines import lines_of

TWO = as_problem(Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, 2)))
OVER = Over("v", Fraction(0), Fraction(2), "", "")
MASSES = ("eta_m", tuple(Fraction(n) for n in range(1, 51)))
GAPS = ("d", (Fraction(1), Fraction(2)))
FACTORS = ("scale.mass", (Fraction(1), Fraction(2)))


def jobs(number: int, quantity: str = "onset") -> list[Job]:
    return [Job(TWO, quantity, OVER, 10, None)] * number


@pytest.mark.parametrize(("rows", "columns"), [(MASSES, GAPS), (GAPS, MASSES)])
def test_every_place_is_in_one_line(rows: Any, columns: Any) -> None:
    lines = lines_of(TWO, jobs(100), rows, columns)
    assert sorted(k for line in lines for k in line.places) == list(range(100))
    assert len(lines) == 4
    width = len(columns[1])
    for line in lines:
        assert (line.along, line.problem is not None) == ("eta_m", True)
        at = [(rows[1][k // width], columns[1][k % width]) for k in line.places]
        assert tuple(one if rows is MASSES else other for one, other in at) == line.values
        assert len({other if rows is MASSES else one for one, other in at}) == 1


@pytest.mark.parametrize(
    ("rows", "columns", "quantity"),
    [(MASSES, FACTORS, "onset"), (MASSES, GAPS, "unstable ranges"), (MASSES, ("gap[0]", (Fraction(-1),)), "onset")],
    ids=["a factor is applied last", "no onsets", "a value that cannot be"],
)
def test_where_each_is_asked_by_itself(rows: Any, columns: Any, quantity: str) -> None:
    lines = lines_of(TWO, jobs(100, quantity), rows, columns)
    assert all(line.problem is None for line in lines)


@pytest.mark.parametrize(("over", "together"), [("v", True), ("track.c", True), ("eta_m", False), ("gap[0]", False)])
def test_a_factor_along_a_line(over: str, together: bool) -> None:
    """It is not applied after what it is to scale is set anew, which each entry does not do."""
    asked = Job(TWO, "onset", Over(over, Fraction(0), Fraction(2), "", ""), 10, None)
    lines = lines_of(TWO, [asked] * 4, FACTORS, ("eta_b", (Fraction("0.05"), Fraction("0.1"))))
    assert all((line.problem is not None) is together for line in lines)


def test_what_a_line_does_not_tell_is_asked_by_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: dict[str, Any] = {"rows": {"eta_m": [5, 60]}, "columns": {"d": [2]}, "digits": 12, "workers": 1}
    together = stability_table(TWO, over={"v": (0, 2)}, **asked)
    monkeypatch.setattr(table_lines, "onsets_along", lambda _, __, ___, values, *____: [None] * len(values))
    alone = stability_table(TWO, over={"v": (0, 2)}, **asked)
    assert [one.text for (one,) in together.entries] == [one.text for (one,) in alone.entries]
    assert together.entries[0][0].over == alone.entries[0][0].over
    assert together.entries[1][0].text.startswith("1.04745908")
