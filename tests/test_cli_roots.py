"""The command `roots`: what it prints, writes and refuses."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from mpsolve.cli import cli


def run(*arguments: str) -> Result:
    return CliRunner().invoke(cli, ["roots", *arguments])


def test_a_rectangle_and_its_certificate(tmp_path: Path) -> None:
    file = tmp_path / "sine.json"
    done = run("sin(z) - z/2", "--rectangle", "-10", "10", "-5", "5", "-o", str(file))
    assert done.exit_code == 0
    assert "7 zeros" in done.output
    verified = CliRunner().invoke(cli, ["verify", str(file)])
    assert verified.exit_code == 0
    assert "exactly 7 zeros" in verified.output


def test_json_and_the_other_regions() -> None:
    done = run("(z - 1)**2", "--disc", "0", "0", "3", "--json")
    assert json.loads(done.output)["zeros"][0]["multiplicity"] == 2
    assert json.loads(run("tan(z)", "--real", "-10", "10", "--json").output)["count"] == 7
    assert "Assumed: no zero" in run("exp(z) - 2", "--half-plane", "right", "3").output
    assert "1 zero" in run("sqrt(z) - 1/2", "--rectangle", "-1", "2", "-1", "1", "--cut", "0", "0", "-1", "0").output


def test_undecided_is_status_1_with_what_helps() -> None:
    done = run("sqrt(z) - 1/2", "--rectangle", "-1", "2", "-1", "1")
    assert done.exit_code == 1
    assert "Undecided" in done.output
    assert "declare the branch cuts, each with --cut RE IM DRE DIM" in done.output


@pytest.mark.parametrize(
    "arguments",
    [
        ("sin(z",),
        ("sin(z)",),
        ("sin(z)", "--disc", "0", "0", "1", "--real", "0", "1"),
        ("conj(z)", "--disc", "0", "0", "1"),
        ("z", "--disc", "0", "0", "-1"),
        ("z", "--real", "1", "0"),
        ("z", "--disc", "0", "0", "1", "--digits", "3"),
    ],
)
def test_bad_input_is_status_2(arguments: tuple[str, ...]) -> None:
    assert run(*arguments).exit_code == 2
