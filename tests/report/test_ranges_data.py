"""Answers about ranges for machines and as tables: values with their units, in the order in which they are asked."""

from __future__ import annotations

import csv
import io
from fractions import Fraction

import numpy as np
from flint import acb, arb

from mpsolve import Problem, tracks, vehicles
from mpsolve.outcome import Status
from mpsolve.ranges.cells import BOUNDARY
from mpsolve.ranges.chart import Chart
from mpsolve.ranges.worst import Worst
from mpsolve.report.ranges_asked import asked
from mpsolve.report.ranges_data import cells_csv, parts_data, ranges_data, rows_csv
from mpsolve.report.worst_words import said_of_worst

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PROBLEM = Problem(TRACK, [vehicles.Mass(9000).at(0), vehicles.Mass(9000).at("3.4")], v=20)
QUESTION = asked(PROBLEM, "Pair", ["gap[0]=1m..5m"])
FOUND = Worst(PROBLEM, {"gap[0]": (Fraction(1), Fraction(5))}, Status.UNVERIFIED, value=arb(2.5), q=acb(12, 0.25),
              where="inside")  # fmt: skip


def test_data_has_the_ranges_the_own_value_and_the_answer() -> None:
    data = ranges_data("worst", "A verdict.", FOUND, QUESTION)
    assert (data["question"], data["title"], data["verdict"]) == ("worst", "Pair", "A verdict.")
    ends = {name: one and one["exact"] for name, one in data["ranges"]["gap[0]"].items() if name != "unit"}
    assert ends == {"low": "1", "high": "5", "own": "17/5"}
    assert data["ranges"]["gap[0]"]["unit"] == "m"
    assert data["answer"]["growth"]["lower"] == -0.25
    assert data["certificate"] is None
    assert parts_data([data, data])["parts"] == [data, data]


def test_rows_carry_their_units() -> None:
    heading, row = csv.reader(io.StringIO(rows_csv([said_of_worst(FOUND, QUESTION)])))
    assert heading == ["gap[0] [m]", "re q [rad/s]", "im q [rad/s]", "where"]
    assert row == ["2.5", "12.0", "0.25", "inside"]


def test_each_cell_of_a_chart_is_a_row() -> None:
    question = asked(PROBLEM, "", ["v=0..20", "gap[0]=1..2"])
    x, y = (Fraction(0), Fraction(10), Fraction(20)), (Fraction(1), Fraction(2))
    chart = Chart(PROBLEM, {}, Status.UNVERIFIED, x=x, y=y, counts=np.array([[2], [BOUNDARY]]))
    heading, first, second = csv.reader(io.StringIO(cells_csv(chart, question)))
    assert heading == ["v low [m/s]", "v high [m/s]", "gap[0] low [m]", "gap[0] high [m]", "roots"]
    assert first == ["0", "10", "1", "2", "2"]
    assert second == ["10", "20", "1", "2", "boundary"]
