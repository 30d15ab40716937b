"""Tables in the paper's ratios: their reports, certificates, files and exit statuses."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from mpsolve.cli import cli
from mpsolve.errors import CertificateError

EXAMPLES = Path(__file__).parents[1] / "examples"
RAIL, PLAIN = EXAMPLES / "rail_60e1.toml", EXAMPLES / "dimensionless.toml"
ONE = "[dimensionless]\nalpha = 1.0749\neta_b = 0.05\neta_m = [35]\npositions = [0]\n"
RAIL_ONE = """
[physical]
EI = 6.4e6
m = 60
k = 1e6
c = 770
v = 313
[[mass]]
M = 10000
position = 0
"""
TABLE = """
quantity = "onset velocity"
[fixed]
masses = 1
alpha = [1.05, 1.1]
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
    undamped = ONE.replace("eta_b = 0.05", "eta_b = 0")
    texts = {"one": ONE, "rail": RAIL_ONE, "table": TABLE, "undamped": undamped}
    for name, text in texts.items():
        Path(f"{name}.toml").write_text(text, encoding="utf-8")
    return lambda *arguments: CliRunner().invoke(cli, [str(x) for x in arguments], catch_exceptions=False)


def flat(text: str) -> str:
    return " ".join(text.split())


def test_table(run: Run) -> None:
    result = run("table", "table.toml", "--workers", 1, "--certificates", "folder")
    assert (result.exit_code, result.stderr) == (0, "")
    assert result.stdout.splitlines()[1].startswith("0.05,1.07490045713867,")
    assert len(list(Path("folder").iterdir())) == 2
    saved = run("table", "table.toml", "--workers", 1, "-o", "a.tex")
    assert (saved.exit_code, saved.stdout) == (0, "2 entries: 2 proved.\na.tex\n")
    assert "$1.07490045713867$" in Path("a.tex").read_text("utf-8")


def test_a_table_with_open_entries(run: Run) -> None:
    Path("open.toml").write_text(TABLE.replace("[0.05]", "[0]").replace("1.05", "0.99"), encoding="utf-8")
    result = run("table", "open.toml", "--workers", 1, "-o", "a.json")
    assert (result.exit_code, result.stdout) == (1, "2 entries: 2 undecided.\na.json\n")


def test_a_table_that_cannot_be_written_is_printed(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(path: Path, _text: str) -> Path:
        raise CertificateError(f"{path} cannot be written: No space left on device")

    monkeypatch.setattr("mpsolve.stability.table.write_whole", fail)
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
        (["table", "table.toml", "--certificates", "one.toml"], "--certificates"),
    ],
)
def test_bad_input_names_its_key_in_one_sentence(run: Run, arguments: list[object], key: str) -> None:
    Path("one.csv").write_text("", encoding="utf-8")
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.startswith(f"mpsolve: {key}: ")
    assert result.stderr.count("\n") == 1
