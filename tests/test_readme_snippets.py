"""What README and its pages show beside commands and library runs as well: SQL, the standalone verifiers."""

from __future__ import annotations

import os
import re
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest
from click import Context, Group, Option
from click.testing import CliRunner

from mpsolve import certify, open_study
from mpsolve.cli import EXAMPLES, cli

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")
EXAMPLES_PAGE = (ROOT / "docs/reference/by-example.md").read_text("utf-8")
MANY = (ROOT / "docs/how-to/many.md").read_text("utf-8")


def test_the_standalone_verifiers(tmp_path: Path) -> None:
    """Each line `python …` that needs nothing but python-flint and the standard library."""
    lines = re.findall(r"^    python (\S*(?:verify\w*|check)\.py) (\S+)$", README, flags=re.MULTILINE)
    assert len(lines) >= 3
    for script, certificate in lines:
        done = subprocess.run(
            [sys.executable, str(ROOT / script), str(ROOT / certificate)],
            capture_output=True, text=True, cwd=tmp_path, check=False, env={"PATH": os.environ["PATH"]},
        )  # fmt: skip
        assert done.returncode == 0, done.stdout + done.stderr
        assert re.search(r"(^|: )(valid|partly checked)", done.stdout), done.stdout


def test_the_store_answers_the_query_that_is_shown(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (query,) = re.findall(r"`(SELECT .*?)`", MANY, flags=re.DOTALL)
    text = (ROOT / "examples/study_float64.toml").read_text("utf-8")
    text = text.replace("two_layer_bogie", str(ROOT / "examples/two_layer_bogie")).replace(
        "count = 500", "count = 40"
    )
    (tmp_path / "study.toml").write_text(text, "utf-8")
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(cli, ["study", "study.toml", "-o", "study.sqlite", "--workers", "1"]).exit_code == 0
    with sqlite3.connect("study.sqlite") as store:
        rows = store.execute(" ".join(query.split())).fetchall()
    assert rows
    assert all(growth > 0 for _, _, growth in rows)
    assert "certify(open_study(" in MANY
    found = open_study("study.sqlite")
    answer = certify(found.problem(7), region="unstable", digits=15, check=False)
    (stored,) = [result for index, _, result in found.results() if index == 7]
    assert stored.unstable == answer.unstable


def test_no_block_of_readme_is_left_out() -> None:
    """What is no Python (which runs whole) is a command, a verifier, the drawing, or one of these."""
    outside = re.sub(r"```python\n.*?```", "", README, flags=re.DOTALL)
    assert "```" not in outside
    blocks = [line.strip() for line in outside.splitlines() if re.match(r"    [a-z]", line)]
    tried = [line for line in blocks if re.match(r"mpsolve |python \S+(verify\w*|check)\.py ", line)]
    installing = ["pip install . && mpsolve certify examples/rail_60e1.toml", "pip install '.[test]' && pytest"]
    assert [line for line in blocks if line not in tried] == [*installing, "pip install python-flint"]


PAGES = "\n".join(file.read_text("utf-8") for file in sorted((ROOT / "docs").rglob("*.md")))


def test_every_option_that_a_page_shows_is_one() -> None:
    """An option is known to the command of its line; those of README and By example run in test_readme.py."""
    context = Context(cli)
    lines = re.findall(r"^(?:    |\$ )?mpsolve (\S+) (-.*|\S*[./=].*)$", README + PAGES, flags=re.MULTILINE)
    assert len(lines) > 60
    for line in lines:
        command = cli.get_command(context, line[0])
        assert command is not None, line
        words = line[1].split()
        if isinstance(command, Group):
            command = command.get_command(context, words[0])
            assert command is not None, line
        known = {name for p in command.params if isinstance(p, Option) for name in (*p.opts, *p.secondary_opts)}
        shown = set(re.findall(r"(?<=\s)(--?[a-z][\w-]*)", " " + line[1].split("  #")[0]))
        assert shown <= known | {"--help"}, line


@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_every_help_has_an_example_of_its_own(name: str) -> None:
    text = CliRunner().invoke(cli, [name, "--help"]).output
    assert EXAMPLES[name].split(" -")[0] in " ".join(text.split()) or EXAMPLES[name] in text
    assert text.count("Example:") == 1


def test_no_command_lacks_an_example() -> None:
    assert set(EXAMPLES) == set(cli.list_commands(Context(cli)))
