"""Root loci in words and as a table: units, ends and crossings are those of the answer."""

import csv
import io
from dataclasses import replace

import pytest
from free_cases import BEAM, PAIR

from mpsolve import Case, Problem
from mpsolve.loci.lines import frequency_lines
from mpsolve.problem.cases import as_problem
from mpsolve.proof.effort import Effort
from mpsolve.report.lines_words import lines_csv, said_of_lines
from mpsolve.report.ranges_asked import asked


def test_ends_and_crossings_are_said() -> None:
    case = Case(alpha="0.9", eta_b="0.05", eta_m=(40, 40), positions=(0, "1.5"))
    question = asked(case, "", ["v=0.9..1"])
    found = frequency_lines(as_problem(case), over=question.over, points=3, check=False)
    text = said_of_lines(found, question).text
    assert "Every root with Im q < 0.046875" in text
    assert "to the border of the region at v = 0.96458664" in text
    assert "real at v = 0.99364593" in text
    assert "lines on which a vibration grows somewhere: 1" in text
    crossed = [line for line in found.lines if line.crossings]
    (line,) = crossed
    said = text.split("real at")[1].splitlines()[0]
    assert said.endswith("; grows beyond it" if (line.crossings[0].direction or 0) > 0 else "; decays beyond it")
    touching = replace(line, crossings=(replace(line.crossings[0], direction=None),))
    text = said_of_lines(replace(found, lines=(touching,)), question).text
    assert "beyond it" not in text  # which way is not proved


def test_an_end_at_a_cut_is_said_and_stands_in_the_table() -> None:
    case = Case(alpha="0.9", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    question = asked(case, "", ["v=0.95..0.99"])
    found = frequency_lines(case, over=question.over, points=2, check=False)
    text = said_of_lines(found, question).text
    assert "Every root of the whole physical sheet lies on one of 2 lines" in text
    assert "to the branch cut, which it meets from below, at v = 0.97909502330" in text
    assert "Proved, without certificate" in text
    rows = list(csv.reader(io.StringIO(lines_csv(found, question))))
    assert [row[-1] for row in rows] == ["end", "", "cut below", "", ""]


def test_the_table_is_in_the_user_s_units() -> None:
    problem = Problem(BEAM, PAIR, v="0.7")
    question = asked(problem, "", ["v=2.16..2.52 km/h"])
    found = frequency_lines(problem, over=question.over, points=3, check=False)
    heading, *rows = csv.reader(io.StringIO(lines_csv(found, question)))
    assert heading == ["line", "v [km/h]", "Re q [rad/s]", "Im q [rad/s]", "frequency [Hz]", "end"]
    assert [row[1] for row in rows[:3]] == ["2.16", "2.34", "2.52"]
    assert len(rows) == 6
    assert float(rows[0][4]) == pytest.approx(float(found.lines[0].q[0].real) / 6.283185307179586)


def test_what_is_open_is_said() -> None:
    problem = Problem(BEAM, PAIR, v="0.7")
    question = asked(problem, "", ["v=0.6..0.7"])
    found = frequency_lines(problem, over=question.over, effort=Effort(evaluations=10), check=False)
    assert said_of_lines(found, question).verdict.startswith("UNDECIDED")
