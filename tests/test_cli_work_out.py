"""The example in each help text runs, and prints formula, value and line."""

from __future__ import annotations

import re
import shlex

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli
from mpsolve.cli_work_out import work_out


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
