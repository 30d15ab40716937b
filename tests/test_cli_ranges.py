"""The commands about ranges: what they say, in whose units, their files and exit statuses."""

from __future__ import annotations

import csv
import json
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner, Result
from flint import arb

from mpsolve.cli import cli
from mpsolve.cli_ranges import _asking
from mpsolve.proof.effort import Effort

EXAMPLES = Path(__file__).parents[1] / "examples"
RAIL, PLAIN = EXAMPLES / "rail_60e1.toml", EXAMPLES / "dimensionless.toml"
CATENARY = """
title = "Contact wire"
v = 139
[track]
model = "euler-bernoulli"
EI = 130
m = 1.35
k = 100
c = 0.5
N = -20000
[[vehicle]]
model = "mass"
M = 10
position = 0
[[vehicle]]
model = "mass"
M = 10
position = 1
"""
TABLE = """
problem = "pair.toml"
over = "v=0.5..0.7"
digits = 6
[rows]
parameter = "gap[0]"
values = [1.5]
[columns]
parameter = "scale.mass"
values = [0.1, 1]
"""
ONSET = 0.66691895728454957
"""Of two masses 70 at the distance 1.5, η_b = 0.05; found by an engine of its own for this beam, now gone."""
Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """The command in a working directory with some inputs."""
    monkeypatch.chdir(tmp_path)
    for name, text in {"wire": CATENARY, "table": TABLE, "pair": PLAIN.read_text("utf-8")}.items():
        Path(f"{name}.toml").write_text(text, encoding="utf-8")
    return lambda *arguments: CliRunner().invoke(cli, [str(x) for x in arguments], catch_exceptions=False)


def test_a_certificate_is_written_and_read(run: Run) -> None:
    made = run("crossings", PLAIN, "--over", "v=0.6..0.7", "--certificate", "a.json")
    assert made.exit_code == 0
    read = run("verify", "a.json")
    assert read.exit_code == 0
    assert "1 crossing of the real axis" in read.stdout


def test_an_answer_without_certificate_says_why(run: Run) -> None:
    made = run("onset", "wire.toml", "--over", "v=20..30", "--effort", "0.001", "--certificate", "a.json")
    assert made.exit_code != 0
    assert "no certificate is written" in made.output
    assert not Path("a.json").exists()


def test_the_onset_is_that_of_the_paper_s_own_proof(run: Run) -> None:
    """In the paper's ratios, as another program with certificates of its own had it."""
    data = json.loads(run("onset", PLAIN, "--over", "v=0.6..0.7", "--digits", 20, "--json").stdout)
    value = data["answer"]["value"]
    assert value["decimal"].startswith("0.66691895728454957")
    assert value["lower"] <= ONSET <= value["upper"]
    assert len(data["certificate"]) == 64
    assert data["trust"].startswith("Proved: a certificate")
    assert data["ranges"]["v"]["high"] == {"exact": "7/10", "decimal": "0.7"}


def test_the_crossings_are_those_of_the_paper_s_own_proof(run: Run) -> None:
    result = run("crossings", PLAIN, "--over", "v=0.6..0.7", "--json", "-o", "c.csv")
    found = json.loads(result.stdout)["answer"]["crossings"]
    assert [abs(float(one["value"]["decimal"]) - ONSET) < 1e-12 for one in found] == [True]
    with Path("c.csv").open(encoding="utf-8", newline="") as file:
        heading, *rows = csv.reader(file)
    assert heading == ["v", "q [√(k/m)]", "direction"]
    assert len(rows) == len(found) == 1


def test_lines_are_followed_and_written(run: Run) -> None:
    result = run("lines", PLAIN, "--over", "v=0.6..0.7", "--points", 3, "-o", "lines.csv")
    assert result.exit_code == 0
    assert "lies on one of 2 lines" in result.stdout
    with Path("lines.csv").open(encoding="utf-8", newline="") as file:
        heading, *rows = csv.reader(file)
    assert heading == ["line", "v", "Re q [√(k/m)]", "Im q [√(k/m)]", "end"]
    assert len(rows) == 6
    assert run("lines", PLAIN, "--over", "v=0.6..0.7", "--points", 3, "-o", "lines.svg").exit_code == 0
    assert ET.fromstring(Path("lines.svg").read_text("utf-8")).tag.endswith("svg")


def test_units_and_the_default_range(run: Run) -> None:
    result = run("onset", RAIL)
    assert (result.exit_code, result.stderr) == (0, "")
    assert "STABLE for v from 0 km/h to 688.3 km/h, where a vibration at 3.13 Hz begins to grow." in result.stdout
    assert "v: 191.183147740034 m/s (688.3 km/h)" in result.stdout
    assert "v is 360 km/h, 328.3 km/h (47.7 %) below the onset." in result.stdout
    assert "The range: v from 0 km/h to 720 km/h (give others with --over)." in result.stdout
    assert "Proved: a certificate" in result.stdout


def test_a_contact_wire_is_not_called_stable_for_every_velocity(run: Run) -> None:
    """Its α = 2 is 26 m/s, but it runs at 139: the default range holds that."""
    result = run("onset", "wire.toml", "--json")
    data = json.loads(result.stdout)
    assert float(data["ranges"]["v"]["high"]["decimal"]) >= 139
    assert data["answer"]["kind"] in ("crosses", "unstable_from_start", "undecided")
    assert (result.exit_code == 1) == (data["answer"]["kind"] == "undecided")


def test_a_range_that_holds_the_speed_of_waves(tmp_path: Path) -> None:
    file = tmp_path / "wire.toml"
    track = '[track]\nmodel = "string"\nT = 27000\nm = 1.07\nk = 500\nc = 2\n'
    file.write_text(f'v = 70\n{track}[[vehicle]]\nmodel = "mass"\nposition = 0\nM = 20\n', encoding="utf-8")
    told = CliRunner().invoke(cli, ["crossings", str(file), "--over", "v=0..1000km/h"])
    assert told.exit_code == 0, told.output
    assert "from 571.9 km/h on: stable" in told.output
    assert "Note: left out: v = 158.851015 m/s itself (waves of the string, √(T/m))" in told.output
    assert "Proved, without certificate: by a theorem" in told.output


def test_a_value_outside_the_range_is_told(run: Run) -> None:
    result = run("onset", RAIL, "--over", "v=0..200km/h")
    assert result.exit_code == 0
    assert "STABLE for every v from 0 km/h to 200 km/h." in result.stdout
    assert "Warning: v is 360 km/h, outside the range from 0 to 200 km/h" in result.stdout


def test_all_unstable_parts(run: Run) -> None:
    result = run("onset", PLAIN, "--over", "v=0.6..0.7", "--all")
    assert result.exit_code == 0
    assert "UNSTABLE in one part of the range of v." in result.stdout
    assert "v from 0.666918957284550 to 0.7: 2 roots grow" in result.stdout


def test_little_effort_is_undecided(run: Run) -> None:
    result = run("onset", PLAIN, "--over", "v=0..1", "--effort", "0.01")
    assert result.exit_code == 1
    assert result.stdout.splitlines()[1].startswith("UNDECIDED: ")
    assert "--effort SECONDS" in result.stdout
    assert "Proved" not in result.stdout


def test_robust(run: Run) -> None:
    over = ("--over", "v=0..80 m/s", "--over", "track.k=0.9..1.1 MN/m²")
    result = run("robust", RAIL, *over)
    assert (result.exit_code, "STABLE for all these values." in result.stdout) == (0, True)
    assert "Warning: v is 100 m/s, outside" in result.stdout
    wide = ("--over", "v=190..210 m/s", "--over", "track.k=0.9..1.1 MN/m²")
    result = run("robust", RAIL, *wide, "--json", "-o", "box.svg")
    assert "unstable here" in Path("box.svg").read_text("utf-8")
    data = json.loads(result.stdout)
    assert (result.exit_code, data["answer"]["stable"]) == (0, False)
    assert data["verdict"] == "UNSTABLE for some of these values."


def test_robust_in_parts_that_a_file_keeps(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mpsolve.studies.robust._PARTS", 2)
    kept = ("robust", PLAIN, "--over", "v=0.2..0.21", "--store", "box.sqlite", "--workers", 1)
    result = run(*kept, "--boxes", 1)
    assert (result.exit_code, "UNDECIDED: 2 of 2 parts are open" in result.stdout) == (1, True)
    result = run(*kept)
    assert (result.exit_code, "STABLE for all these values." in result.stdout) == (0, True)
    assert "2 of its 2 parts have one each, in box.sqlite" in result.stdout
    assert run("status", "box.sqlite").stdout.endswith("2 of 2 entries finished: 2 proved.\nbox.sqlite\n")


def test_a_chart_and_its_files(run: Run) -> None:
    over = ("--over", "v=0.64..0.7", "--over", "scale.mass=0.8..1.2", "--depth", 2)
    result = run("chart", PLAIN, *over, "-o", "chart.svg", "--certificate", "chart.json")
    assert result.exit_code == 0
    assert "The certificate states the number of each cell" in result.stdout
    assert json.loads(Path("chart.json").read_text("ascii"))["kind"] == "chart"
    assert "of the chart is decided" in result.stdout
    svg = Path("chart.svg").read_text("utf-8")
    assert ET.fromstring(svg).tag.endswith("svg")
    assert "velocity ratio α" in svg
    run("chart", PLAIN, *over, "-o", "chart.csv")
    with Path("chart.csv").open(encoding="utf-8", newline="") as file:
        heading, *rows = csv.reader(file)
    assert heading == ["v low", "v high", "scale.mass low", "scale.mass high", "roots"]
    assert len(rows) == 16
    assert {row[4] for row in rows} <= {"0", "2", "boundary", "open"}
    assert ("0.64", "0") in {(row[0], row[4]) for row in rows}


def test_a_table_of_any_problem(run: Run) -> None:
    result = run("table", "table.toml", "--workers", 1)
    assert (result.exit_code, result.stderr) == (0, "")
    lines = result.stdout.splitlines()
    assert (
        lines[0] == '"gap[0] \\ scale.mass: onset of v",0.1,1' or lines[0] == "gap[0] \\ scale.mass: onset of v,0.1,1"
    )
    assert lines[1] == "1.5,stable,0.666919"
    result = run("table", "table.toml", "--workers", 1, "-o", "t.json")
    assert "2 entries: 1 proved, 1 stable." in result.stdout
    entry = json.loads(Path("t.json").read_text("utf-8"))["entries"][0][1]
    middle, radius = ((int(x), e) for x, e in entry["balls"][0])
    assert arb(middle, radius).overlaps(arb("0.66691895728454957 +/- 1e-17"))


@pytest.mark.parametrize(
    ("arguments", "key", "said"),
    [
        (["onset", "none.toml"], "none.toml", ""),
        (["onset", RAIL, "--over", "v=0.."], "--over", "no upper end"),
        (["onset", RAIL, "--over", "v"], "--over", "v=0..400km/h"),
        (["onset", RAIL, "--over", "speed=0..1"], "--over", "the parameters are"),
        (["onset", RAIL, "--over", "v=0..1", "--over", "track.k=1..2"], "over", "give one path"),
        (["onset", PLAIN, "--over", "v=0..3km/h"], "--over", "the file holds the paper's ratios"),
        (["onset", PLAIN, "--digits", "14"], "digits", ""),
        (["onset", PLAIN, "--effort", "0"], "effort", ""),
        (["onset", "pair.toml", "-o", "pair.toml"], "output", ""),
        (["crossings", PLAIN, "-o", "no/c.json"], "output", ""),
        (["crossings", PLAIN, "-o", "c.txt"], "output", ".json, .csv"),
        (["robust", PLAIN], "--over", "is missing"),
        (["robust", PLAIN, "--over", "v=0..1", "--boxes", 9], "--boxes", "without --store"),
        (["robust", PLAIN, "--over", "v=0..1", "--dask", "a:1"], "--dask", "without --store"),
        (["robust", PLAIN, "--over", "v=0..1", "--store", "s", "--effort", 1], "--effort", "give --boxes"),
        (["robust", PLAIN, "--over", "v=0..1", "--workers", 0], "--workers", "is 0"),
        (["chart", PLAIN, "-o", "c.png"], "output", ".svg"),
        (["chart", PLAIN, "--over", "v=0..1"], "over", "a chart is over two parameters"),
        (["table", "table.toml", "-o", "a.txt"], "output", ".csv, .json"),
        (["table", "table.toml", "--workers", "0"], "workers", ""),
    ],
)
def test_bad_input_names_its_key_in_one_sentence(run: Run, arguments: list[object], key: str, said: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.removeprefix("mpsolve: ").removeprefix("--").startswith(f"{key.removeprefix('--')}: ")
    assert result.stderr.count("\n") == 1
    assert said in result.stderr


def test_what_looks_like_a_mistake_is_told(tmp_path: Path) -> None:
    """EI a million off, where the question is about v; not km/h for m/s, as the file's own v plays no part."""
    text = (Path(__file__).parents[1] / "examples/rail_60e1.toml").read_text("utf-8")
    file = tmp_path / "rail.toml"
    file.write_text(re.sub(r"EI = \S+", "EI = 6.4", text), "utf-8")
    done = CliRunner().invoke(cli, ["robust", str(file), "--over", "v=0..1"])
    assert "Warning: track.EI is 6.4 N m²" in done.output
    assert 'write EI = "6.4 MN m²"' in done.output


def test_worst_in_the_units_that_were_written(run: Run) -> None:
    result = run("worst", RAIL, "--over", "gap[0]=1m..5m")
    assert result.exit_code == 0
    assert (
        "STABLE: the least damped vibration decays most slowly at gap[0] = 4.815 m, inside the range."
        in result.stdout
    )
    assert "halves in 14.61 s" in result.stdout
    result = run("worst", PLAIN, "--json")  # from half to twice the distance
    data = json.loads(result.stdout)
    assert (result.exit_code, data["question"], data["answer"]["where"]) == (0, "worst", "inside")
    assert data["ranges"]["gap[0]"]["high"]["decimal"] == "3"


def test_onset_at_the_worst_value_of_another_parameter(run: Run) -> None:
    result = run("onset", PLAIN, "--over", "scale.mass=0.01..1", "--worst", "gap[0]=1..2")
    assert result.exit_code == 0
    assert "For every gap[0] from 1 to 2: STABLE for scale.mass from 0.01 to 0.5929" in result.stdout
    assert "worst gap[0]: 1.697045734437" in result.stdout
    result = run("onset", PLAIN, "--over", "scale.mass=0.01..1", "--worst", "gap[0]=1..2", "--all")
    assert (result.exit_code, "give one of the two" in result.stderr) == (2, True)


def test_the_effort_is_one_of_all_ranges() -> None:
    def left(whole: Effort | None) -> Effort | None:
        """What is handed on to be spent on the next range."""
        question: Any = SimpleNamespace(given=None, over={})
        return _asking(lambda _, effort, **__: effort, lambda found, _: found, whole)(question, None)  # type: ignore[return-value]

    whole = Effort(seconds=100)
    whole.started -= 70
    rest = left(whole)
    assert rest is not None
    assert 29 < rest.seconds < 30
    assert rest.whole is whole
    whole.started -= 70
    assert left(whole).seconds == 10  # some in any case
    assert left(None) is None
