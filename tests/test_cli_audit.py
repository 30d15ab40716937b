"""The command `audit`: a paper by its folder, the report in each form, certificates, bad input."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli

TOY = str(Path(__file__).parent / "claims" / "toy")
PAPER = str(Path(__file__).parents[1] / "examples" / "paper")


def test_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    given = ["audit", PAPER, "--only", "fig-10b", "--only", "3-pairs", "--workers", "1", "--html", "a.html", "--json"]
    result = CliRunner().invoke(cli, [*given, "--certificates", "certs"], catch_exceptions=False)
    assert result.exit_code == 0
    assert json.loads(result.stdout)["summary"]["a slip of the print"] == 1
    assert (tmp_path / "a.html").read_text("utf-8").startswith("<!doctype html>")
    assert [path.name for path in (tmp_path / "certs").iterdir()] == ["3-pairs.json"]


def test_exit_status_1_where_a_check_comes_to_no_end() -> None:
    result = CliRunner().invoke(cli, ["audit", TOY, "--workers", "1"], catch_exceptions=False)
    assert result.exit_code == 1
    assert "iii needs more digits" in " ".join(result.stdout.split())


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "PAPER: is not given: name the folder of its claims, as in mpsolve audit examples/paper"),
        (["nowhere"], "PAPER: nowhere is neither"),
        ([TOY, "--only", "xiii"], "only"),
        ([TOY, "--html", "no/a.html"], "html"),
        ([TOY, "--certificates", "file"], "certificates"),
        ([TOY, "--workers", "0"], "workers"),
    ],
)
def test_bad_input(arguments: list[str], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("", "utf-8")
    result = CliRunner().invoke(cli, ["audit", *arguments])
    assert result.exit_code == 2
    assert said in result.stderr
    assert result.stdout == ""
