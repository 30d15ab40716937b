"""A velocity in km/h that stands for one in m/s is told, by the title or by the missing unit."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from mpsolve import Case, Problem, read_problem, tracks, vehicles
from mpsolve.cli import cli
from mpsolve.presets.written import input_file, names
from mpsolve.problem.inputfile import read_source
from mpsolve.problem.titled import Title, titled

RAIL: dict[str, Any] = {"EI": "6.4e6", "m": 60, "k": "1e6", "c": 770}
EXAMPLES = Path(__file__).parents[2] / "examples"


def changed(v: object = 100) -> Problem:
    return Problem(tracks.EulerBernoulli(**RAIL), [vehicles.Mass(900).at(0), vehicles.Mass(900).at("2.5")], v=v)


def test_a_title_in_kilometres_an_hour() -> None:
    (said,) = titled(changed(), "Bogie at 100 km/h")
    assert str(said) == (
        'v is 100 m/s, which is 360 km/h, but the title says 100 km/h: write v = "100 km/h", if that is meant'
    )
    assert not titled(changed(), "A bogie, at 100 m/s (360 km/h)")
    assert not titled(changed(), "100 wheels")
    assert not titled(Case(alpha=1, eta_b="0.1", eta_m=[1]), "1 km/h")


@pytest.mark.parametrize("v", ["100", "100.0 # of the line", '"100"'])
def test_a_bare_velocity(v: str, tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(
        f"v = {v}\n"
        + """
[track]
model = "euler-bernoulli"
EI = 6.4e6
m = 60
k = 1e6
c = 770
[[vehicle]]
model = "mass"
M = 900
""",
        "utf-8",
    )
    source = read_problem(file)
    (said,) = titled(source.given, pickle.loads(pickle.dumps(source.title)))
    told = (
        "v stands without a unit: 100 m/s, which is 360 km/h: "
        'write v = "100 km/h", if that is meant, or v = "100 m/s"'
    )
    assert str(said) == told
    result = CliRunner().invoke(cli, ["onset", str(file), "--over", "track.c=600..700", "--effort", "0.1"])
    assert f"Warning: {told}." in result.stdout


@pytest.mark.parametrize("v", ['"100 m/s"', '"360 km/h"', "100 # m/s, as the old line", "84", '"300 m/s"'])
def test_a_velocity_that_is_meant(v: str, tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(f"[physical]\nEI = 6.4e6\nm = 60\nk = 1e6\nv = {v}\n[[mass]]\nM = 9\nposition = 0\n", "utf-8")
    source = read_source(file)
    assert not titled(source.given, source.title)
    file.write_text(file.read_text("utf-8").replace(f"v = {v}", "v = 100"), "utf-8")
    source = read_source(file)
    assert [one.code for one in titled(source.given, source.title)] == ["velocity-without-unit"]


def test_wires_and_presets_and_examples_are_let_be(tmp_path: Path) -> None:
    wire = Problem(tracks.String(T=27000, m="1.07", k=500, c=2), vehicles.Mass(9).at(0), v=100)
    assert not titled(wire, Title("", bare=True))
    assert titled(changed(), Title("", bare=True))
    for name in names("track"):
        file = tmp_path / f"{name}.toml"
        file.write_text(input_file(name), "utf-8")
        source = read_source(file)
        assert not titled(source.given, source.title), name
    for file in EXAMPLES.glob("*.toml"):
        if {"vehicle", "physical"} & {line.strip("[] ") for line in file.read_text("utf-8").splitlines()}:
            source = read_source(file)
            assert not titled(source.given, source.title), file.name
