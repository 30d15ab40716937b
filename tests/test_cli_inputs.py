"""The commands for input files: new, work-out and its examples, schema."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli
from mpsolve.cli_inputs import work_out
from mpsolve.problem.inputfile import read_problem
from mpsolve.schemas.catalogue import CATALOGUE, listing


def run(*arguments: str) -> tuple[int, str, str]:
    result = CliRunner().invoke(cli, ["new", *arguments])
    return result.exit_code, result.stdout, result.stderr


def test_a_file_is_written_once(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    assert run("ballasted", "--vehicle", "shinkansen", "--v", "300 km/h", "-o", str(file)) == (0, f"{file}\n", "")
    assert read_problem(file).problem.v * 36 == 3000
    status, _, said = run("slab", "-o", str(file))
    assert status == 2
    assert "exists: give the path of a new file" in said


def test_the_terminal_gets_the_text_or_the_list() -> None:
    assert 'model = "string"' in run("contact-wire")[1]
    assert "zhai-2004" in run()[1]


def test_a_name_that_there_is_not() -> None:
    status, out, said = run("balasted")
    assert (status, out) == (2, "")
    assert said == "mpsolve: TRACK: is 'balasted', which is unknown: did you mean ballasted?\n"


def test_several_in_a_row(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    assert run("slab", "--count", "3", "--spacing", "25 m", "-o", str(file))[0] == 0
    assert [one.position for one in read_problem(file).problem.vehicles] == [0, 25, 50]


@pytest.mark.parametrize("name", sorted(work_out.commands))
def test_the_example_in_the_help_runs(name: str) -> None:
    example = re.search(r"Example: mpsolve (.+)", work_out.commands[name].help or "")
    assert example is not None
    result = CliRunner().invoke(cli, shlex.split(example[1]))
    assert result.exit_code == 0, result.output
    assert " = " in result.output.splitlines()[0]
    assert len(result.output.splitlines()) >= 2


def test_a_mistake_is_one_sentence() -> None:
    result = CliRunner().invoke(cli, ["work-out", "per-metre", "--k", "180 kN/mm", "--spacing", "0.6 kg"])
    assert result.exit_code == 2
    assert result.stderr.startswith("mpsolve: --spacing: is '0.6 kg', whose unit is kg")


def test_half_a_sleeper_alone() -> None:
    words = ["work-out", "per-metre", "--m", "145kg", "--spacing", "0.6m", "--layer", "sleepers"]
    result = CliRunner().invoke(cli, words)
    assert result.exit_code == 0, result.output
    assert 'm_sleeper = "725/3 kg/m"  # 241.7 kg/m' in result.output


@pytest.mark.parametrize(("layer", "key"), [([], "k_pad"), (["--layer", "ballast"], "k_ballast")])
def test_the_key_is_that_of_the_layer(layer: list[str], key: str) -> None:
    for words in (["per-metre", "--k", "60kN/mm", "--spacing", "0.6m"],
                  ["damping", "--k", "100 MN/m²", "--loss", "0.2", "--frequency", "100 Hz"]):  # fmt: skip
        result = CliRunner().invoke(cli, ["work-out", *words, *layer])
        assert f"{key if words[0] == 'per-metre' else key.replace('k', 'c', 1)} = " in result.output
        assert ("say --layer ballast" in result.output) == (not layer)


def test_another_material() -> None:
    words = ["work-out", "axial-force", "--area", "70 cm²", "--warmer", "10 K"]
    result = CliRunner().invoke(cli, [*words, "--modulus", "100 GPa", "--expansion", "1e-5 1/K"])
    assert 'N = "70 kN"' in result.output  # E A α ΔT


def test_all_schemas() -> None:
    for name, (_, make) in CATALOGUE.items():
        result = CliRunner().invoke(cli, ["schema", name])
        assert result.exit_code == 0
        assert json.loads(result.stdout) == make()
    assert CliRunner().invoke(cli, ["schema"]).stdout == listing()


def test_another_schema() -> None:
    result = CliRunner().invoke(cli, ["schema", "poem"])
    assert (result.exit_code, result.stdout) == (2, "")
    assert "which is unknown" in result.stderr
