"""What README and the page of examples show runs as it stands: the library, and every `mpsolve` command."""

from __future__ import annotations

import itertools
import re
import shlex
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click import Context
from click.testing import CliRunner

import mpsolve
from mpsolve.claims import Verdict
from mpsolve.claims.load import load
from mpsolve.cli import cli
from mpsolve.problem.casefile import DIMENSIONLESS, LOAD, MASS, PHYSICAL, read_input

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")
EXAMPLES = (ROOT / "docs/reference/by-example.md").read_text("utf-8")
INPUT = (ROOT / "docs/reference/input.md").read_text("utf-8").split("## Masses on one beam")[1]
TRIAL = (ROOT / "docs/how-to/paper.md").read_text("utf-8")
LIBRARY = EXAMPLES.split("## The library")[1]
SHOWN = re.findall(r"^    (\w+\(\S.*\)[\w.\[\]\"]*) +# (.*)$", LIBRARY, flags=re.MULTILINE)


def commands(page: str) -> list[str]:
    """The commands that a page shows, in its order."""
    return [line.split("#")[0].strip() for line in page.splitlines() if line.startswith("    mpsolve ")]


def test_the_library_example(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    code, _ = re.findall(r"```python\n(.*?)```", README, flags=re.DOTALL)
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    exec(code, names)
    assert (tmp_path / "pair.json").exists()
    assert len(code.strip().splitlines()) <= 12
    found = names["s"]
    said = (found.proved, found.stable, found.count, found.unstable, str(found.region), found.reason)
    shown = re.findall(r"s\.reason\)  # (.*)$", code, flags=re.MULTILINE)[0].split("…")
    printed = " ".join(map(str, said))
    assert (printed.startswith(shown[0].strip()), printed.endswith(shown[1].strip())) == (True, True)
    assert names["G"].shape == (2, 2)


def test_the_library_line_by_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each expression can be evaluated, and a ball that is shown begins with the digits of the true one."""
    monkeypatch.chdir(tmp_path)
    names = {name: getattr(mpsolve, name) for name in mpsolve.__all__}
    names["case"] = mpsolve.Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
    names |= {"times": np.linspace(0, 50, 101), "speeds": np.linspace(0.4, 0.6, 3), "dampings": [[0.1], [0.2]]}
    names["string"] = mpsolve.Problem(mpsolve.tracks.String(T=9, m=1, k=4, c=1), mpsolve.vehicles.Mass(2), v=1)
    names["problem"] = mpsolve.read_problem(ROOT / "examples/two_layer_bogie.toml").problem
    balls = 0
    for expression, said in SHOWN:
        if "examples/" in expression:  # a table and a study, whose commands run below
            assert (ROOT / re.findall(r'"(examples/[^"]*)"', expression)[0]).exists()
            continue
        value = eval(expression, names)
        if said.startswith("2: "):
            assert value == 2
        if said.startswith("["):
            digits = re.findall(r"\[(-?[\d.]+)…", said)[0]
            assert value.str(60, radius=False).startswith(digits), expression
            balls += 1
    assert len(SHOWN) == len(re.findall(r"^    \w", LIBRARY, flags=re.MULTILINE)) > 20
    assert balls > 2
    assert sorted(path.name for path in tmp_path.iterdir()) == ["seeds.csv"]


def test_the_pages_that_it_leads_to_exist() -> None:
    linked = re.findall(r"\]\((?!https?:)([^)#]+)\)", README)
    assert len(linked) > 10
    assert [path for path in linked if not (ROOT / path).exists()] == []


def test_every_command_is_shown() -> None:
    assert {shlex.split(command)[1] for command in commands(EXAMPLES)} == set(cli.list_commands(Context(cli)))


def test_readme_is_short_and_begins_with_the_two_commands() -> None:
    assert len(README.splitlines()) <= 130
    first = [line.strip() for line in README.splitlines() if line.startswith("    ")][:2]
    assert first == ["pip install . && mpsolve certify examples/rail_60e1.toml", "pip install '.[test]' && pytest"]


@pytest.mark.parametrize("page", [README, EXAMPLES], ids=["readme", "by-example"])
def test_the_commands(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In the page's order, in a folder with links to examples and certs: each exits with 0."""
    monkeypatch.chdir(tmp_path)
    for folder in ("examples", "certs"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    assert len(commands(page)) >= 6
    for command in commands(page):
        if page is README and command in commands(EXAMPLES):
            continue
        words = shlex.split(command)[1:]
        words += (
            ["--effort", "5"] if words[0] == "report" and "--effort" not in words else []
        )  # the rest is named as late
        paths = [str(p) for w in words for p in (sorted(tmp_path.glob(w)) if "*" in w else [w])]
        result = CliRunner().invoke(cli, paths)
        assert result.exit_code == 0, f"{command}: {result.output[-500:]}"


def test_the_input_files_that_are_shown_hold_every_key(tmp_path: Path) -> None:
    shown = re.findall(r"```toml\n(.*?)```", INPUT, flags=re.DOTALL)
    assert len(shown) == 2
    for text, known in zip(shown, ((PHYSICAL, MASS), (DIMENSIONLESS, LOAD)), strict=True):
        file = tmp_path / "case.toml"
        file.write_text(text, "utf-8")
        assert read_input(file).title in ("One axle", "")
        keys = set(re.findall(r"^(\w+) +=", text, flags=re.MULTILINE))
        assert keys - {"title"} == {*known[0], *known[1]}
    command = cli.get_command(Context(cli), "response")
    assert command is not None
    assert [name for name in (*list(MASS)[2:], *LOAD) if name not in (command.help or "")] == []


def test_the_paper_on_trial(tmp_path: Path) -> None:
    """The folder that is shown is a paper: its claim is proved, and refuted with another number."""
    lines = TRIAL[TRIAL.index("    from mpsolve") :].splitlines()
    code = "\n".join(line.removeprefix("    ") for line in itertools.takewhile(lambda x: x[:1] in ("", " "), lines))
    (tmp_path / "paper.py").write_text(code, "utf-8")
    paper = load(tmp_path)
    (claim,) = paper.claims
    assert claim.check(claim).verdict is Verdict.PROVED
    assert claim.check(replace(claim, printed={**claim.printed, "n": ("1",)})).verdict is Verdict.REFUTED
