"""The command critical: every velocity of a range, as text, JSON and a chart."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from mpsolve import critical_velocities, read_problem
from mpsolve.cli import cli

BOGIE = "examples/two_layer_bogie.toml"


def run(*arguments: object) -> Result:
    return CliRunner().invoke(cli, [str(a) for a in arguments])


def test_text_and_json_say_the_same() -> None:
    known = critical_velocities(read_problem(BOGIE).problem.track, 500)
    assert "slower waves of this track follow a constant force at any velocity" in run("critical", BOGIE).output
    text, data = run("critical", BOGIE, "--omega", 500), run("critical", BOGIE, "--omega", 500, "--json")
    assert (text.exit_code, data.exit_code) == (0, 0), text.output
    assert len(known) == 4
    assert [one["v"][:8] for one in json.loads(data.output)["velocities"]] == [
        one.value.str(20, radius=False)[:8] for one in known
    ]
    assert all(one.value.str(12, radius=False)[:10] in text.output for one in known)
    assert "the list is complete for 0 ≤ v ≤ 2000" in text.output
    assert run("critical", BOGIE, "--from", 1300, "--to", 1400).output.count("km/h") == 0


@pytest.mark.parametrize("file", [BOGIE, "examples/dimensionless.toml"])
def test_the_chart_is_written(file: str, tmp_path: Path) -> None:
    chart = tmp_path / "chart.svg"
    result = run("critical", file, "--to", 1500, "-o", chart)
    assert result.exit_code == 0, result.output
    assert "<svg" in chart.read_text("utf-8")


@pytest.mark.parametrize(
    ("options", "said"),
    [(["--omega", "x"], "omega"), (["--from", 5, "--to", 1], "--to"), (["-o", "chart.gif"], "chart.gif")],
)
def test_options_that_cannot_be_used_are_named(options: list[object], said: str) -> None:
    result = run("critical", BOGIE, *options)
    assert result.exit_code == 2
    assert said in result.output + result.stderr
