"""The command `report`: where the page goes, and what is said when its time is short."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli

PAIR = str(Path("examples/dimensionless.toml").resolve())


def test_a_page_comes_back_however_short_the_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(cli, ["report", PAIR, "--effort", "0.5", "--digits", "15"])
    assert done.exit_code == 0, done.output
    verdict, name = done.stdout.splitlines()
    assert (verdict.startswith("UNSTABLE"), name) == (True, "dimensionless.html")
    assert "UNSTABLE" in Path(name).read_text("utf-8")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("-o page.pdf", "--output: page.pdf is a page in HTML: give -o NAME.html, and --pdf page.pdf for the PDF"),
        ("--pdf page.html", "--pdf: page.html does not end in .pdf"),
        ("--digits 5", "--digits: is 5"),
        ("--effort 0", "--effort: is 0: give a time above 0"),
    ],
)
def test_what_cannot_be(words: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(cli, ["report", PAIR, *words.split()])
    assert (done.exit_code, done.stdout, list(tmp_path.iterdir())) == (2, "", [])
    assert done.stderr.startswith(f"mpsolve: {said}")
