"""A value that is refused is told as it was written, with its own unit: in files, commands and the library."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from mpsolve import (
    Case,
    PhysicalCase,
    Problem,
    onset,
    receptance,
    stability_table,
    tracks,
    train_velocities,
    vehicles,
)
from mpsolve.cli import cli
from mpsolve.engineering import per_metre
from mpsolve.errors import InputError
from mpsolve.problem.casefile import read_input
from mpsolve.problem.inputfile import read_problem
from mpsolve.studies.axes import read_axes

BEAM = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=1000)
PROBLEM = Problem(BEAM, [vehicles.Mass(900).at(0), vehicles.Mass(900).at(3)], v=10)
ALONE = Problem(BEAM, vehicles.Mass(900), v=10)
FILE = """v = {v}
[track]
model = "euler-bernoulli"
EI = "6.4 MN m²"
m = "60 kg/m"
k = {k}
c = "1 kN s/m²"
[[vehicle]]
model = "mass"
M = {M}
count = 2
spacing = {spacing}
"""
PAPER = """[physical]
EI = 6.4e6
m = 60
k = {k}
v = 10
[[mass]]
M = "900 kg"
position = 0
"""


def in_table(k: str) -> Any:
    return stability_table(PROBLEM, over={"v": (0, 9)}, rows={"track.k": [k]}, columns={"track.c": [1]})


@pytest.mark.parametrize(
    ("refused", "told"),
    [
        (lambda: tracks.EulerBernoulli(EI="-6.4 MN m²", m=60, k=1), "EI: is -6.4 MN m², but must be above 0"),
        (lambda: tracks.EulerBernoulli(EI=1, m=60, k=1, c="-2 kN s/m²"), "c: is -2 kN s/m², but must not be below 0"),
        (lambda: tracks.EulerBernoulli(EI=-6400000, m=60, k=1), "EI: is -6.4e+6, but must be above 0"),
        (lambda: vehicles.Mass("0 t"), "M: is 0 t, but"),
        (lambda: Problem(BEAM, vehicles.Mass(1), v="-36 km/h"), "v: is -36 km/h, but"),
        (lambda: vehicles.train(vehicles.Mass(1), 3, "-25 mm"), "spacing: is -25 mm, but"),
        (lambda: PROBLEM.changed("track.k", "-2 kN/m²"), "track.k: is -2 kN/m², but"),
        (lambda: PROBLEM.changed("gap[0]", "-20 mm"), "gap[0]: is -20 mm, but"),
        (lambda: onset(PROBLEM, over={"v": ("-36 km/h", "5 km/h")}), "v: is -36 km/h, but"),
        (lambda: onset(PROBLEM, over={"v": ("36 km/h", "5 km/h")}), "v: ends at 5 km/h, not above its start 36 km/h"),
        (
            lambda: train_velocities(ALONE, 25, v=("9 km/h", "5 km/h")),
            "v: ends at 5 km/h, not above its start 9 km/h",
        ),
        (lambda: receptance(BEAM, 0, 1, v="-36 km/h"), "v: is -36 km/h, but"),
        (lambda: per_metre("-180 kN/mm", "0.6 m"), "k: is -180 kN/mm, but"),
        (lambda: read_axes({"v": ["-36 km/h"]}, "grid", PROBLEM), "parameters.v[1]: is -36 km/h, but"),
        (lambda: in_table("-2 kN/m²"), "rows.values[1]: is -2 kN/m², but"),
        (lambda: PhysicalCase(EI=1, m=1, k=-5, v=0, masses=[(1, 0)]), "k: is -5, but"),
        (lambda: Case(alpha=-1, eta_b=0, eta_m=[1], positions=[0]), "alpha: is -1, but"),
    ],
)
def test_in_the_library(refused: Callable[[], Any], told: str) -> None:
    with pytest.raises(InputError) as caught:
        refused()
    assert str(caught.value).startswith(told)


@pytest.mark.parametrize(
    ("key", "value", "told"),
    [
        ("v", "-36 km/h", "v: is -36 km/h, but"),
        ("k", "-2 kN/m²", "track.k: is -2 kN/m², but"),
        ("M", "-1.5 t", "vehicle[1].M: is -1.5 t, but"),
        ("spacing", "-25 mm", "vehicle[1].spacing: is -25 mm, but"),
    ],
)
def test_in_files(tmp_path: Path, key: str, value: str, told: str) -> None:
    values = {"v": "10", "k": "1e6", "M": "900", "spacing": "3"} | {key: f'"{value}"'}
    file = tmp_path / "mine.toml"
    file.write_text(FILE.format(**values), "utf-8")
    with pytest.raises(InputError) as caught:
        read_problem(file)
    assert str(caught.value).startswith(told)
    shown = CliRunner().invoke(cli, ["certify", str(file)])
    assert (shown.exit_code, told in shown.stderr) == (2, True)


def test_in_files_of_the_paper(tmp_path: Path) -> None:
    file = tmp_path / "paper.toml"
    file.write_text(PAPER.format(k='"-2 kN/m²"'), "utf-8")
    with pytest.raises(InputError, match=r"physical\.k: is -2 kN/m², but must be above 0"):
        read_input(file)


def test_on_the_command_line(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(FILE.format(v="10", k="1e6", M="900", spacing="3"), "utf-8")
    for arguments, told in (
        (["certify", str(file), "--region", "below=-30 1/min"], "-30 1/min"),
        (["certify", str(file), "--region", "60 1/min,30 1/min,-1,0"], "is 30 1/min, not above re_min = 60 1/min"),
        (["onset", str(file), "--over", "track.k=-2..5 kN/m²"], "'-2'"),
        (["response", str(file), "--to", "-5 ms"], "-5 ms"),
        (["new", "ballasted", "--v", "-36 km/h"], "-36 km/h"),
        (["work-out", "per-metre", "--k", "-180 kN/mm", "--spacing", "0.6 m"], "-180 kN/mm"),
    ):
        shown = CliRunner().invoke(cli, arguments)
        assert (shown.exit_code, told in shown.stderr) == (2, True), (arguments, shown.stderr)
