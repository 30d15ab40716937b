"""The PDF: whole or not at all, and where no browser is found a sentence that says what to do."""

from __future__ import annotations

import shutil
import stat
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve import InputError
from mpsolve.cli import cli
from mpsolve.errors import CertificateError
from mpsolve.report import page_parts, pdf
from mpsolve.report.pdf import VARIABLE, browser, save_pdf

PAGE = "<!DOCTYPE html><html lang='en'><title>A page</title><h1>A page</h1></html>"
CASE = "[dimensionless]\nalpha = 1.1\neta_b = 0.1\neta_m = [20]\npositions = [0]\n"


def program(folder: Path, script: str) -> str:
    """A program that stands in for a browser; its last argument but one is --print-to-pdf=FILE."""
    file = folder / "browser"
    file.write_text(
        f"#!/bin/sh\nfor word; do case $word in --print-to-pdf=*) out=${{word#*=}};; esac; done\n{script}\n"
    )
    file.chmod(file.stat().st_mode | stat.S_IXUSR)
    return str(file)


@pytest.mark.parametrize(
    ("script", "said"),
    [
        ("exit 3", "exit status 3"),
        ("echo nonsense > $out", "exit status 0"),
        ("exec sleep 60", "stopped after 0.2 s"),
    ],
)
def test_a_browser_that_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str, said: str) -> None:
    monkeypatch.setattr(pdf, "SECONDS", 0.2 if "sleep" in script else 60)
    place = tmp_path / "place"
    place.mkdir()
    file = place / "a.pdf"
    file.write_text("what was there")
    with pytest.raises(CertificateError, match=said):
        save_pdf(PAGE, file, program(tmp_path, script))
    assert [one.name for one in place.iterdir()] == ["a.pdf"]
    assert file.read_text() == "what was there"


def test_a_program_that_cannot_be_run(tmp_path: Path) -> None:
    with pytest.raises(CertificateError, match="No such file"):
        save_pdf(PAGE, tmp_path / "a.pdf", str(tmp_path / "none"))


def test_the_variable_names_the_browser(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    named = program(tmp_path, "printf '%%PDF-1.7' > $out")
    monkeypatch.setenv(VARIABLE, named)
    assert browser() == named
    file = save_pdf(PAGE, tmp_path / "a.pdf", browser())
    assert file.read_bytes() == b"%PDF-1.7"
    monkeypatch.setenv(VARIABLE, str(tmp_path / "none"))
    with pytest.raises(InputError, match="is no program"):
        browser()


def test_the_command_without_a_browser_says_so_before_any_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def gather(*_: object) -> None:
        raise AssertionError("no work is done")

    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv(VARIABLE, raising=False)
    monkeypatch.setattr(shutil, "which", lambda _name: None)
    monkeypatch.setattr(page_parts, "gather", gather)
    Path("one.toml").write_text(CASE, "utf-8")
    for words, said in (
        (["--pdf", "one.pdf"], "--pdf: needs Chromium, Chrome or Edge, and none is found: install one"),
        (["-o", "one.pdf"], "output: one.pdf is a page in HTML: give -o NAME.html, and --pdf one.pdf"),
        (["--pdf", "one.html"], "one.html"),
        (["--pdf", "none/one.pdf"], "none is no directory"),
    ):
        done = CliRunner().invoke(cli, ["report", "one.toml", *words])
        assert done.exit_code == 2
        assert said in done.output
        assert len(done.output.splitlines()) == 1
    assert [one.name for one in tmp_path.iterdir()] == ["one.toml"]


def test_a_real_browser_prints_the_page(tmp_path: Path) -> None:
    try:
        program = browser()
    except InputError:
        pytest.skip("no Chromium, Chrome or Edge is installed")
    content = save_pdf(PAGE, tmp_path / "a.pdf", program).read_bytes()
    assert content.startswith(b"%PDF-")
    assert content.rstrip().endswith(b"%%EOF")
    assert b"/Count 1" in content  # pages
    assert [one.name for one in tmp_path.iterdir()] == ["a.pdf"]
