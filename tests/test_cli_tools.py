"""What the commands share: one sentence and a status for each end, paths that cannot be, times with units."""

from __future__ import annotations

from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from mpsolve.cli import cli
from mpsolve.cli_tools import certificate_path, checked_output, command, effort_of, progress, seconds_of, show
from mpsolve.errors import InputError, StudyError
from mpsolve.report.blocks import Document


def _failing(error: BaseException) -> click.Command:
    def fail() -> None:
        raise error

    return command()(fail)


@pytest.mark.parametrize(
    ("error", "status", "said"),
    [
        (InputError("v", "is -1: give another"), 2, "mpsolve: v: is -1: give another\n"),
        (StudyError("s.sqlite is damaged"), 1, "mpsolve: s.sqlite is damaged\n"),
        (KeyboardInterrupt(), 130, "mpsolve: interrupted\n"),
    ],
)
def test_an_error_is_a_sentence_and_a_status(
    error: BaseException, status: int, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        _failing(error).main([])
    assert (ended.value.code, capsys.readouterr().err) == (status, said)


def test_a_fault_of_ours_is_not_hidden() -> None:
    with pytest.raises(ZeroDivisionError):
        _failing(ZeroDivisionError()).main([])


def test_certificates_have_a_name_by_default(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert certificate_path(Path("a/mine.toml"), None) == Path("mine.certificate.json")
    assert certificate_path(Path("-"), None, "onset") == Path("stdin.onset.certificate.json")
    assert certificate_path(Path("mine.toml"), Path("x.json")) == Path("x.json")


def test_outputs_that_cannot_be(tmp_path: Path) -> None:
    source = tmp_path / "mine.toml"
    source.touch()
    (tmp_path / "link").symlink_to(source)
    for path, said in (
        (tmp_path, "is a directory"),
        (tmp_path / "none" / "x.json", "is no directory: make it"),
        (tmp_path / "link", "is the input file"),
        (tmp_path / ("x" * 300), "cannot be used (File name too long)"),
    ):
        with pytest.raises(InputError) as error:
            checked_output(path, source, "the table", "pdf")
        assert (error.value.key, said in str(error.value)) == ("pdf", True)
    assert checked_output(tmp_path / "new", source, "the table") == tmp_path / "new"


def test_times() -> None:
    assert [seconds_of(x, "to") for x in ("5", "2 min", "1/2 s")] == [5, 120, 0.5]
    effort = effort_of("2 min")
    assert effort is not None
    assert effort.seconds == 120
    assert effort_of(None) is None
    for given in ("0", "-1 s", "fast", "5 kg"):
        with pytest.raises(InputError):
            seconds_of(given, "to")


def test_what_is_no_terminal_gets_plain_text_and_no_bar(capsys: pytest.CaptureFixture[str]) -> None:
    show(Document(()))
    with progress() as tell:
        assert tell is None
    out, err = capsys.readouterr()
    assert ("\x1b" in out, err) == (False, "")


def test_no_sentence_of_a_list_of_commands_is_cut() -> None:
    """`mpsolve work-out --help` ended in "at one..."."""
    said = CliRunner().invoke(cli, ["work-out", "--help"]).output
    assert " ".join(said.split()).count("loss factor, at one frequency.") == 1
    assert "..." not in said.partition("Commands:")[2]
