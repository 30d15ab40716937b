"""The command: its report, its certificate, its exit status, and silence where silence is due."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import click
import pytest
from click.testing import CliRunner, Result

import mpsolve
from mpsolve.cli import EXAMPLES as _EXAMPLES
from mpsolve.cli import cli

EXAMPLES = Path(__file__).parents[1] / "examples"
CERTS = EXAMPLES.parent / "certs"
RAIL, PLAIN = EXAMPLES / "rail_60e1.toml", EXAMPLES / "dimensionless.toml"
TOUCHING = "[dimensionless]\nalpha = 1\neta_b = 0\neta_m = [20]\npositions = [0]\n"

Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """The command in an empty working directory."""
    monkeypatch.chdir(tmp_path)
    return lambda *arguments: CliRunner().invoke(cli, [str(x) for x in arguments], catch_exceptions=False)


def test_verify_says_a_line_for_each_file(run: Run) -> None:
    run("certify", PLAIN, "-o", "good.json")
    Path("broken.json").write_text('{"format": "mpsolve certificate"', encoding="utf-8")
    result = run("verify", "good.json")
    first, *rest = result.stdout.splitlines()
    assert result.exit_code == 0
    assert first.startswith("valid: good.json: exactly 4 induced frequencies q ")
    assert "2 of them with Im q < 0" in first
    assert all(line.startswith("  ") for line in rest)
    result = run("verify", "broken.json", "good.json", "missing.json")
    assert result.exit_code == 1
    lines = [line for line in result.stdout.splitlines() if not line.startswith("  ")]
    assert [line.split(":")[0] for line in lines] == ["invalid", "valid", "invalid"]


def test_verify_shows_the_equations_of_version_2(run: Run) -> None:
    result = run("verify", CERTS / "contact_wire.json", CERTS / "single_mass.json")
    assert result.exit_code == 0
    lines = result.stdout.splitlines()
    heads = [line for line in lines if not line.startswith("  ")]
    assert heads[0].startswith(f"valid: {CERTS / 'contact_wire.json'}: exactly 2 induced frequencies")
    assert heads[1].startswith(f"valid: {CERTS / 'single_mass.json'}: ")
    assert len(heads) == 2
    assert "(-27000 P^2 + 107/100 s^2 + 2 s + 500) u1 = load" in " ".join(line.strip() for line in lines)


def test_derive(run: Run, tmp_path: Path) -> None:
    assert "Equations of motion" in run("derive", "--masses", 1).stdout
    paper = (
        "from mpsolve.claims import Paper\nfrom mpsolve.derivation.step import Step\nfrom sympy import Eq, symbols\n"
    )
    (tmp_path / "paper.py").write_text(f'{paper}PAPER = Paper("A", "A", [])\n', "utf-8")
    assert run("derive", tmp_path).stderr == "mpsolve: paper: 'A' derives nothing: let its PAPER say derivation=…\n"
    step = 'lambda n: (Step("(1)", "Motion", Eq(*symbols("a b")), f"{n} masses"),)'
    (tmp_path / "two").mkdir()
    (tmp_path / "two" / "paper.py").write_text(f'{paper}PAPER = Paper("A", "A", [], derivation={step})\n', "utf-8")
    assert "3 masses" in run("derive", tmp_path / "two", "--masses", 3).stdout
    assert run("derive", tmp_path / "two", "--latex").stdout.startswith("\\documentclass")


def test_derive_refuses_a_number_of_masses(run: Run) -> None:
    result = run("derive", "--masses", 0)
    assert result.exit_code == 2
    assert result.stderr.startswith("mpsolve: --masses: ")


def test_version(run: Run) -> None:
    assert run("--version").stdout == f"mpsolve {mpsolve.__version__}\n"


def test_as_a_process_in_a_pipe(tmp_path: Path) -> None:
    """UTF-8 in any locale, no control codes, no progress, the same text as in the library."""
    environment = {**os.environ, "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    environment["PYTHONPATH"] = str(Path(mpsolve.__file__).parents[1])
    command = [sys.executable, "-m", "mpsolve", "certify", str(RAIL)]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    assert "√(k/m)" in done.stdout.decode("utf-8")
    assert b"\x1b" not in done.stdout
    assert (tmp_path / "rail_60e1.certificate.json").is_file()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full on this system")
def test_standard_output_on_a_full_disk(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "mpsolve", "certify", str(RAIL)]
    environment = {**os.environ, "PYTHONPATH": str(Path(mpsolve.__file__).parents[1])}
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            command, cwd=tmp_path, env=environment, stdout=full, stderr=subprocess.PIPE, check=False
        )
    told = done.stderr.decode("utf-8")
    assert (done.returncode, told.count("\n")) == (1, 1)
    assert told.startswith("mpsolve: standard output cannot be written (No space left on device): make room")
    assert (tmp_path / "rail_60e1.certificate.json").is_file()


def test_importing_the_command_is_light() -> None:
    """Beside what `import mpsolve` loads, the module needs click alone."""
    code = "import sys, mpsolve; before = {*sys.modules}; import mpsolve.cli; print(*{*sys.modules} - before)"
    environment = {**os.environ, "PYTHONPATH": str(Path(mpsolve.__file__).parents[1])}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    loaded = {name.partition(".")[0] for name in done.stdout.split()}
    assert not loaded & {"rich", "sympy", "matplotlib"}
    assert not [name for name in done.stdout.split() if name.startswith("mpsolve.report")]


ALL = {name: cli.get_command(click.Context(cli), name) for name in cli.list_commands(click.Context(cli))}


def test_the_list_of_commands_has_whole_sentences() -> None:
    listed = CliRunner().invoke(cli, ["--help"]).stdout.split("Commands:")[1]
    assert "..." not in listed
    said = " ".join(listed.split())
    assert all(f"{name} {one.get_short_help_str(200)}" in said for name, one in ALL.items() if one is not None)


@pytest.mark.parametrize("name", sorted(ALL))
def test_each_help_ends_with_an_example_that_can_be_typed(name: str) -> None:
    """The words of the example are those that the command takes."""
    example = _EXAMPLES[name]
    shown = CliRunner().invoke(cli, [name, "--help"]).stdout.split()
    assert " ".join(shown).endswith(f"Example: {example}")
    words = shlex.split(example.partition(" > ")[0])
    assert words[:2] == ["mpsolve", name]
    command, rest = ALL[name], words[2:]
    if isinstance(command, click.Group):
        command, rest = command.commands[rest[0]], rest[1:]
    command.make_context(name, rest)


@pytest.mark.skipif(os.name == "nt", reason="a shell that closes streams is asked for")
@pytest.mark.parametrize(
    ("words", "closed", "said"),
    [
        ("certify -", "<&-", "mpsolve: standard input: holds no problem"),
        ("verify -", "<&-", ""),
        ("models string", ">&-", ""),
        ("certify nope.toml", "2>&-", ""),
        ("certify {root}/examples/rail_60e1.toml", ">&- 2>&-", ""),
    ],
)
def test_a_closed_stream_is_no_traceback(tmp_path: Path, words: str, closed: str, said: str) -> None:
    """Whoever starts a program may close its streams: Python then has None in their places."""
    root = Path(__file__).parents[1]
    command = f"{shlex.quote(sys.executable)} -m mpsolve {words.format(root=root)} {closed}"
    environment = os.environ | {"PYTHONPATH": str(root)}
    done = subprocess.run(
        ["sh", "-c", command], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert "Traceback" not in done.stderr
    assert done.stderr.startswith(said)
    assert done.returncode == {"models": 0, "verify": 1}.get(words.split()[0], 0 if "rail" in words else 2)
