"""A problem that is written and read again is the same problem."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from mpsolve import InputError, Problem, read_problem, tracks, vehicles
from mpsolve.problem.outputfile import number, problem_toml
from tests.oracle_general.package import as_problem, known
from tests.oracle_general.problems import problems

EXAMPLES = sorted(Path("examples").glob("*bogie.toml")) + sorted(Path("examples").glob("train*.toml"))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_survives_the_way_there_and_back(path: Path, tmp_path: Path) -> None:
    problem = read_problem(path).problem
    copy = tmp_path / "copy.toml"
    copy.write_text(problem_toml(problem, 'a "title" with ü'), encoding="utf-8")
    again = read_problem(copy)
    assert again.problem == problem
    assert again.title == 'a "title" with ü'


@given(problems())
def test_any_problem_survives(plain: dict[str, Any]) -> None:
    assume(known(plain))
    problem = as_problem(plain)
    with TemporaryDirectory() as folder:
        copy = Path(folder) / "copy.toml"
        copy.write_text(problem_toml(problem), encoding="utf-8")
        assert read_problem(copy).problem == problem


@given(st.fractions())
def test_numbers_are_exact(x: Fraction) -> None:
    assert Fraction(number(x).strip('"')) == x


def test_bare_equations_are_refused() -> None:
    track = tracks.String(T=1, m=1, k=1, c=1).waveguide
    with pytest.raises(InputError, match="bare equations"):
        problem_toml(Problem(track, vehicles.Mass(1), v=0))
