"""The commands that make a page: report and explore."""

from __future__ import annotations

import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

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


BOGIE = "examples/two_layer_bogie.toml"


def test_the_file_is_read_and_served(monkeypatch: pytest.MonkeyPatch) -> None:
    served: list[Any] = []
    page = SimpleNamespace(serve=lambda *given: served.append(given))
    monkeypatch.setitem(sys.modules, "mpsolve.explorer.page", page)
    done = CliRunner().invoke(cli, ["explore", BOGIE, "--port", "8123", "--no-browser"])
    assert (done.exit_code, done.stdout) == (0, "http://127.0.0.1:8123  (Ctrl-C ends it)\n")
    ((problem, title, port, browser),) = served
    assert (problem.v, port, browser) == (100, 8123, False)
    assert title.startswith("A bogie")


def test_a_missing_extra_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(sys.modules, "mpsolve.explorer.page", raising=False)
    monkeypatch.setitem(sys.modules, "nicegui", None)
    done = CliRunner().invoke(cli, ["explore", BOGIE])
    assert done.exit_code == 2
    assert done.stderr == (
        "mpsolve: explore: needs NiceGUI, which is not installed: pip install 'mpsolve[explore]'\n"
    )


def test_a_port_that_is_none() -> None:
    done = CliRunner().invoke(cli, ["explore", BOGIE, "--port", "70000"])
    assert done.exit_code == 2
    assert done.stderr == "mpsolve: --port: is 70000: give a whole number from 1 to 65535\n"
