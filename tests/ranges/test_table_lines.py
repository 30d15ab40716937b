"""Entries are asked together where a line of the table may be; each stands in its place."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Case, InputError, stability_table
from mpsolve.problem.cases import as_problem
from mpsolve.problem.over import Over
from mpsolve.problem.problem import Problem
from mpsolve.ranges import entry
from mpsolve.ranges.entry import Job, lines_of

TWO = as_problem(Case(alpha="0.5", eta_b="0.05", eta_m=(70, 70), positions=(0, 2)))
OVER = Over("v", Fraction(0), Fraction(2), "", "")
MASSES = ("eta_m", tuple(Fraction(n) for n in range(1, 51)))
GAPS = ("d", (Fraction(1), Fraction(2)))
FIRST = ("vehicles[0].M", (Fraction(40), Fraction(50)))
FACTORS = ("scale.mass", (Fraction(2), Fraction(3)))


Axis = tuple[str, tuple[Fraction, ...]]


def jobs(rows: Axis, columns: Axis, quantity: str = "onset", over: Over = OVER) -> list[Job]:
    """As a table makes them."""

    def at(x: Fraction, y: Fraction) -> Problem:
        problem = TWO
        for path, value in sorted([(rows[0], x), (columns[0], y)], key=lambda one: one[0].startswith("scale.")):
            problem = problem.changed(path, value)
        return problem

    return [Job(at(x, y), quantity, over, 10, None) for x in rows[1] for y in columns[1]]


@pytest.mark.parametrize(("rows", "columns"), [(MASSES, GAPS), (GAPS, MASSES)])
def test_every_place_is_in_one_line(rows: Any, columns: Any) -> None:
    lines = lines_of(TWO, jobs(rows, columns), rows, columns)
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
    [
        (MASSES, FACTORS, "onset"),
        (MASSES, GAPS, "unstable ranges"),
        (MASSES, FIRST, "onset"),
        (FIRST, MASSES, "onset"),
    ],
    ids=["a factor is applied last", "no onsets", "a mass after all masses", "all masses after one"],
)
def test_where_each_is_asked_by_itself(rows: Any, columns: Any, quantity: str) -> None:
    lines = lines_of(TWO, jobs(rows, columns, quantity), rows, columns)
    assert all(line.problem is None for line in lines) == ((rows, columns) != (FIRST, MASSES))


def test_a_value_that_cannot_be() -> None:
    lines = lines_of(TWO, jobs(MASSES, GAPS), MASSES, ("gap[0]", (Fraction(-1), Fraction(2))))
    assert [line.problem is None for line in lines] == [True, True, False, False]


def test_paths_that_move_the_same_masses_are_asked_in_the_order_of_the_table() -> None:
    """Against single questions: the mass of one of them is set after those of both; before, it would be undone."""
    both, one = {"vehicles.M": ["60", "67"]}, {"vehicles[0].M": ["40"]}
    found = stability_table(TWO, over={"v": (0, 2)}, rows=both, columns=one, workers=1)
    assert [entry.text for (entry,) in found.entries] == ["1.061080479", "1.060222658"]
    for over, rows, columns in (("v", one, both), ("vehicles.M", one, {"track.c": ["0.1"]})):
        rows = {path: [*values, "50"] for path, values in rows.items()}
        with pytest.raises(InputError, match=r"rows: has vehicles\[0\].M, which moves nothing"):
            stability_table(TWO, over={over: (1, 2)}, rows=rows, columns=columns, workers=1)


@pytest.mark.parametrize(("over", "together"), [("v", True), ("track.c", True), ("eta_m", False), ("gap[0]", True)])
def test_a_factor_along_a_line(over: str, together: bool) -> None:
    """It is not applied after what it is to scale is set anew, which each entry does not do."""
    dampings = ("eta_b", (Fraction("0.05"), Fraction("0.1")))
    asked = jobs(FACTORS, dampings, over=Over(over, Fraction(0), Fraction(2), "", ""))
    lines = lines_of(TWO, asked, FACTORS, dampings)
    assert all((line.problem is not None) is together for line in lines)


def test_what_a_line_does_not_tell_is_asked_by_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: dict[str, Any] = {"rows": {"eta_m": [5, 60]}, "columns": {"d": [2]}, "digits": 12, "workers": 1}
    together = stability_table(TWO, over={"v": (0, 2)}, **asked)
    monkeypatch.setattr(entry, "onsets_along", lambda _, __, ___, values, *____: [None] * len(values))
    alone = stability_table(TWO, over={"v": (0, 2)}, **asked)
    assert [one.text for (one,) in together.entries] == [one.text for (one,) in alone.entries]
    assert together.entries[0][0].over == alone.entries[0][0].over
    assert together.entries[1][0].text.startswith("1.04745908")
