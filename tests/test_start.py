"""What a start loads: nothing that the answer does not need. The times are in tests/bench/bench_start.py."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PAIR = str(ROOT / "examples" / "rail_60e1.toml")
HEAVY = {"numpy", "sympy", "mpmath", "matplotlib", "scipy", "rich", "jinja2", "flint", "threadpoolctl", "msgspec"}
SCRIPT = "import sys; {statement}; print(*sorted(name for name in {heavy!r} if name in sys.modules))"
RUN = (
    "import sys\nsys.argv[1:] = {arguments!r}\nimport contextlib, io\nfrom mpsolve.cli import cli\n"
    "try:\n    with contextlib.redirect_stdout(io.StringIO()):\n        cli(prog_name='mpsolve')\n"
    "except SystemExit as end:\n    assert not end.code, end.code\n"
    "print(*sorted(name for name in {heavy!r} if name in sys.modules))"
)


def loaded(script: str) -> set[str]:
    done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True)
    return set(done.stdout.split())


@pytest.mark.parametrize(
    ("statement", "allowed"),
    [
        ("import mpsolve", set()),
        ("from mpsolve import InputError, Status", set()),
        ("from mpsolve import certify", {"flint", "msgspec"}),
        ("from mpsolve import verify", {"flint"}),
        ("from mpsolve import read_problem", {"flint", "msgspec"}),
    ],
)
def test_imports(statement: str, allowed: set[str]) -> None:
    assert loaded(SCRIPT.format(statement=statement, heavy=HEAVY)) <= allowed


@pytest.mark.parametrize(
    ("arguments", "allowed"),
    [
        (["--version"], set()),
        (["--help"], set()),
        (["verify", str(ROOT / "certs" / "timoshenko_stable.json")], {"flint"}),
        (["verify", str(ROOT / "certs" / "single_mass.json")], {"flint"}),
        (["new", "ballasted"], {"flint", "msgspec"}),
        (["certify", PAIR, "--region", "unstable", "--digits", "15"], {"flint", "msgspec", "numpy", "threadpoolctl"}),
    ],
)
def test_commands(tmp_path: Path, arguments: list[str], allowed: set[str]) -> None:
    more = ["-o", str(tmp_path / "x.json")] if arguments[0] == "certify" else []
    assert loaded(RUN.format(arguments=arguments + more, heavy=HEAVY)) <= allowed
