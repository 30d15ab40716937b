"""The commands about studies: what they print and write, and their exit statuses."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from mpsolve.cli import cli
from mpsolve.cli_study import _progress

SPEC = """
title = "Two velocities"
[study]
kind = "certified"
[dimensionless]
alpha = 0.4
eta_b = 0.05
eta_m = [40]
positions = [0]
[parameters]
v = [0.4, 0.5]
"""
Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """The command in a working directory that holds two specs."""
    monkeypatch.chdir(tmp_path)
    Path("spec.toml").write_text(SPEC, encoding="utf-8")
    Path("buckles.toml").write_text(
        SPEC.replace("eta_b", "eta_n = 0.9\neta_b").replace("v =", '"track.N" = 1\nv ='), encoding="utf-8"
    )
    return lambda *arguments: CliRunner().invoke(cli, [str(x) for x in arguments], catch_exceptions=False)


def test_study_status_and_export(run: Run) -> None:
    made = run("study", "spec.toml", "-o", "s.sqlite", "--workers", 1)
    assert (made.exit_code, made.stderr) == (0, "")
    assert made.stdout == "2 of 2 entries finished: 2 proved.\ns.sqlite\n"
    assert run("study", "spec.toml", "-o", "s.sqlite", "--workers", 1).stdout == made.stdout

    told = run("status", "s.sqlite")
    assert told.exit_code == 0
    assert told.stdout.startswith('Two velocities\ndimensionless.alpha = "2/5"\n')
    assert told.stdout.endswith('parameters.v = ["2/5", "1/2"]\n' + made.stdout)
    data = json.loads(run("status", "s.sqlite", "--json").stdout)
    assert (data["total"], data["finished"], data["tally"]) == (2, 2, {"proved": 2})

    for kind in ("csv", "json", "npz"):
        written = run("export", "s.sqlite", "--to", kind)
        assert (written.exit_code, written.stdout, written.stderr) == (0, f"s.{kind}\n", "")
        assert Path(f"s.{kind}").stat().st_size
    named = run("export", "s.sqlite", "--to", "csv", "-o", "table.txt")
    assert named.stdout == "table.txt.csv\n"
    assert Path("table.txt.csv").read_bytes() == Path("s.csv").read_bytes()


def test_refused_cases_are_told_by_the_exit_status(run: Run) -> None:
    made = run("study", "buckles.toml", "-o", "s.sqlite", "--workers", 1)
    assert (made.exit_code, made.stdout) == (1, "2 of 2 entries finished: 2 refused.\ns.sqlite\n")
    assert run("status", "s.sqlite").exit_code == 0


def test_a_study_that_is_not_complete(run: Run) -> None:
    from mpsolve.studies.blocks import work
    from mpsolve.studies.spec import read_spec
    from mpsolve.studies.store import Store

    spec = read_spec("spec.toml")
    with Store.create(Path("s.sqlite"), spec) as store:
        store.put(work(spec.text, 1))
    assert run("status", "s.sqlite").exit_code == 1
    written = run("export", "s.sqlite", "--to", "csv")
    assert (written.exit_code, written.stdout) == (1, "s.csv\n")
    assert written.stderr == "mpsolve: 1 of 2 entries are finished; the others are missing\n"
    assert Path("s.csv").read_text("utf-8").splitlines()[1].startswith("1,0.5,proved,")


@pytest.mark.parametrize(
    ("arguments", "status", "said"),
    [
        (("study", "none.toml", "-o", "s.sqlite"), 2, "none.toml: does not exist"),
        (("study", "spec.toml", "-o", "spec.toml"), 2, "is the input file"),
        (("study", "spec.toml", "-o", "none/s.sqlite"), 2, "none is no directory"),
        (("study", "spec.toml", "-o", "s.sqlite", "--workers", "0"), 2, "workers: is 0"),
        (("study", "spec.toml", "-o", "s.sqlite", "--workers", "2", "--dask", "tcp://x:1"), 2, "one of the two"),
        (("study", "spec.toml", "-o", "buckles.toml", "--workers", "1"), 1, "it is no study"),
        (("export", "none.sqlite", "--to", "csv"), 2, "STORE: none.sqlite does not exist"),
        (("export", "spec.toml", "--to", "csv"), 1, "it is no study"),
        (("status", "none.sqlite"), 2, "does not exist"),
        (
            ("status", "x" * 300),
            2,
            "cannot be used (File name too long): give the path of a file that `mpsolve study`",
        ),
        (("export", "x" * 300, "--to", "csv"), 2, "cannot be used (File name too long)"),
    ],
)
def test_errors_are_one_sentence(run: Run, arguments: tuple[str, ...], status: int, said: str) -> None:
    result = run(*arguments)
    assert result.exit_code == status
    assert said in result.stderr
    assert result.stderr.startswith("mpsolve: ")
    assert result.stderr.count("\n") == 1
    assert result.stdout == ""


def test_a_spec_that_differs_is_told_apart(run: Run) -> None:
    run("study", "spec.toml", "-o", "s.sqlite", "--workers", 1)
    other = run("study", "buckles.toml", "-o", "s.sqlite", "--workers", 1)
    assert other.exit_code == 2
    assert 'parameters.track.N is not given there and "1" here' in other.stderr


def test_ctrl_c_says_what_is_kept_and_how_to_go_on(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("mpsolve.studies.run.study", interrupted)
    result = run("study", "spec.toml", "-o", "s.sqlite", "--workers", 1)
    assert (result.exit_code, result.stdout) == (1, "")
    told = "mpsolve: interrupted; what is finished is stored in s.sqlite, and the same command goes on\n"
    assert result.stderr == told


@pytest.mark.parametrize("address", ["127.0.0.1:1", "tcp://127.0.0.1:1"])
def test_a_scheduler_needs_no_scheme(address: str, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    distributed = pytest.importorskip("distributed")

    def absent(given: str, **_: object) -> None:
        raise OSError(f"asked {given}")

    monkeypatch.setattr(distributed, "Client", absent)
    result = run("study", "spec.toml", "-o", "s.sqlite", "--dask", address)
    assert result.exit_code == 1
    assert "no Dask scheduler answers at tcp://127.0.0.1:1 (asked tcp://127.0.0.1:1)" in result.stderr


def test_dask_is_an_extra(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    result = run("study", "spec.toml", "-o", "s.sqlite", "--dask", "tcp://localhost:8786")
    assert (result.exit_code, result.stdout) == (2, "")
    assert "pip install 'mpsolve[dask]'" in result.stderr


def test_progress_tells_the_rate(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    monkeypatch.setenv("COLUMNS", "120")
    monkeypatch.setenv("FORCE_COLOR", "1")
    with _progress() as tell:
        assert tell is not None
        for finished in range(1, 5):
            tell(finished, 8)
    told = capsys.readouterr().err
    assert "4/8" in told
    assert "entries/s" in told
