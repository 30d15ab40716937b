"""What README shows runs as it stands: the library example, and every `mpsolve` command."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")
BLOCK = README.split("## The command line")[1].split("## The library")[0]
COMMANDS = [line.split("#")[0].strip() for line in BLOCK.splitlines() if line.startswith("    mpsolve ")]


def test_the_library_example(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (code,) = re.findall(r"```python\n(.*?)```", README, flags=re.DOTALL)
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    exec(code, names)
    assert (tmp_path / "case.json").exists()
    assert len(code.strip().splitlines()) <= 12


def test_the_commands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In README's order, in a folder with links to examples and certs: each exits with 0."""
    monkeypatch.chdir(tmp_path)
    for folder in ("examples", "certs"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    assert len(COMMANDS) >= 6
    for command in COMMANDS:
        words = shlex.split(command)[1:]
        paths = [str(p) for w in words for p in (sorted(tmp_path.glob(w)) if "*" in w else [w])]
        result = CliRunner().invoke(cli, paths)
        assert result.exit_code == 0, f"{command}: {result.output[-500:]}"
