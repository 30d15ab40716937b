"""Tables: what is printed and written of them, in the paper's ratios and in units, and exit statuses."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from mpsolve.cli import cli
from mpsolve.errors import CertificateError

ONE = "[dimensionless]\nalpha = 1.0749\neta_b = 0.05\neta_m = [35]\npositions = [0]\n"
TABLE = """
title = "One mass"
problem = "one.toml"
over = "v=1.05..1.1"
digits = 15
[rows]
parameter = "eta_b"
values = [0.05]
[columns]
parameter = "eta_m"
values = [70, 80]
"""
Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """The command in a working directory that holds the inputs above."""
    monkeypatch.chdir(tmp_path)
    for name, text in {"one": ONE, "table": TABLE}.items():
        Path(f"{name}.toml").write_text(text, encoding="utf-8")
    return lambda *arguments: CliRunner().invoke(cli, [str(x) for x in arguments], catch_exceptions=False)


def test_table(run: Run) -> None:
    result = run("table", "table.toml", "--workers", 1)
    assert (result.exit_code, result.stderr) == (0, "")
    assert result.stdout.splitlines()[1].startswith("0.05,1.07490045713867,")
    saved = run("table", "table.toml", "--workers", 1, "-o", "a.tex")
    assert saved.exit_code == 0
    assert saved.stdout.startswith("2 entries: 2 proved.")
    text = Path("a.tex").read_text("utf-8")
    assert "$1.07490045713867$" in text
    assert "$\\eta_M$" in text


def test_a_table_with_open_entries(run: Run) -> None:
    Path("open.toml").write_text("seconds = 1e-6\n" + TABLE, encoding="utf-8")
    result = run("table", "open.toml", "--workers", 1, "-o", "a.json")
    assert result.exit_code == 1
    assert result.stdout.startswith("2 entries: 2 undecided.")
    assert json.loads(Path("a.json").read_text("utf-8"))["entries"][0][0]["reason"] is not None


def test_a_table_that_cannot_be_written_is_printed(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(path: Path, _text: str) -> Path:
        raise CertificateError(f"{path} cannot be written: No space left on device")

    monkeypatch.setattr("mpsolve.files.write_whole", fail)
    result = run("table", "table.toml", "--workers", 1, "-o", "a.csv")
    assert result.exit_code == 1
    assert result.stdout.splitlines()[1].startswith("0.05,1.07490045713867,")
    assert result.stderr == "mpsolve: a.csv cannot be written: No space left on device\n"


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        (["table", "one.toml"], "one.toml"),
        (["table", "none.toml", "-o", "one.csv"], "none.toml"),
        (["table", "table.toml", "-o", "a.txt"], "--output"),
        (["table", "table.toml", "--workers", "0"], "--workers"),
    ],
)
def test_bad_input_names_its_key_in_one_sentence(run: Run, arguments: list[object], key: str) -> None:
    Path("one.csv").write_text("", encoding="utf-8")
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.startswith(f"mpsolve: {key}: ")
    assert result.stderr.count("\n") == 1
