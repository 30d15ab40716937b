"""The command `new`: a file that certify takes, or a sentence."""

from __future__ import annotations

from pathlib import Path

from click.testing import CliRunner

from mpsolve.cli import cli
from mpsolve.problem.inputfile import read_problem


def run(*arguments: str) -> tuple[int, str, str]:
    result = CliRunner().invoke(cli, ["new", *arguments])
    return result.exit_code, result.stdout, result.stderr


def test_a_file_is_written_once(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    assert run("ballasted", "--vehicle", "shinkansen", "--v", "300 km/h", "-o", str(file)) == (0, f"{file}\n", "")
    assert read_problem(file).problem.v * 36 == 3000
    status, _, said = run("slab", "-o", str(file))
    assert status == 2
    assert "exists: give the path of a new file" in said


def test_the_terminal_gets_the_text_or_the_list() -> None:
    assert 'model = "string"' in run("contact-wire")[1]
    assert "zhai-2004" in run()[1]


def test_a_name_that_there_is_not() -> None:
    status, out, said = run("balasted")
    assert (status, out) == (2, "")
    assert said == "mpsolve: TRACK: is 'balasted', which is unknown: did you mean ballasted?\n"


def test_several_in_a_row(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    assert run("slab", "--count", "3", "--spacing", "25 m", "-o", str(file))[0] == 0
    assert [one.position for one in read_problem(file).problem.vehicles] == [0, 25, 50]
