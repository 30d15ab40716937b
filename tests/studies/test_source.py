"""The problem of a study: the same tables from the study's file and from the one that it names."""

from __future__ import annotations

from pathlib import Path

from mpsolve.problem.inputfile import problem_of, read_problem
from mpsolve.problem.toml import parsed
from mpsolve.studies.source import problem_tables

EXAMPLE = Path(__file__).parents[2] / "examples" / "two_layer_bogie.toml"


def test_tables_are_plain_and_make_the_problem_of_the_file() -> None:
    named = problem_tables({"problem": EXAMPLE.name}, EXAMPLE.parent)
    own = problem_tables(parsed(EXAMPLE.read_text("utf-8"), "here"), Path())
    assert named == own
    assert named["track"]["EI"] == "6380430"
    assert "title" not in named
    assert problem_of(named, Path("x")).given == read_problem(EXAMPLE).given
