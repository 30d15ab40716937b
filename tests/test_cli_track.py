"""The commands about a track and its trains: critical, receptance, train."""

from __future__ import annotations

import csv
import io
import json
from math import pi
from pathlib import Path
from time import process_time

import pytest
from click.testing import CliRunner, Result

from mpsolve import critical_velocities, read_problem
from mpsolve.cli import cli

EXAMPLES = Path(__file__).parents[1] / "examples"
BOGIE, PLAIN = EXAMPLES / "two_layer_bogie.toml", EXAMPLES / "dimensionless.toml"


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


def table(*arguments: str) -> list[dict[str, str]]:
    result = CliRunner().invoke(cli, ["receptance", *arguments])
    assert result.exit_code == 0, result.output
    lines = [line for line in result.stdout.splitlines() if not line.startswith("#")]
    return list(csv.DictReader(io.StringIO("\n".join(lines))))


def test_hertz_and_centimetres() -> None:
    assert table(str(BOGIE), "--omega", "0,1 Hz,2") == table(str(BOGIE), "--omega", "0 Hz,1 Hz,2")
    spoken = table(str(BOGIE), "--omega", "10 Hz,20 Hz,3", "--xi", "0,150 cm")
    plain = table(str(BOGIE), "--omega", f"{20 * pi!r},{40 * pi!r},3", "--xi", "0,1.5")
    assert len(spoken) == len(plain)
    for a, b in zip(spoken, plain, strict=True):
        assert a.keys() == b.keys()
        for key in a:
            assert float(a[key]) == pytest.approx(float(b[key]), rel=1e-9)


@pytest.mark.parametrize(
    ("file", "omega", "xi", "said"),
    [
        (BOGIE, "1 m,2,3", "0", "--omega: is '1 m', whose unit is m"),
        (BOGIE, "1,2,3", "1 kg", "--xi: is '1 kg', whose unit is kg"),
        (BOGIE, "1 Hz,2,3", "0", "where 2 stands without a unit: write it at both ends"),
        (PLAIN, "1 Hz,2,3", "0", "--omega: is '1 Hz'"),
    ],
)
def test_wrong_units(file: Path, omega: str, xi: str, said: str) -> None:
    result = CliRunner().invoke(cli, ["receptance", str(file), "--omega", omega, "--xi", xi])
    assert result.exit_code == 2
    assert said in result.stderr


def test_a_name_in_json_is_enough(tmp_path: Path) -> None:
    file = tmp_path / "contacts.json"
    words = ["receptance", str(BOGIE), "--omega", "10,20,2", "--contacts", "-o", str(file)]
    assert CliRunner().invoke(cli, words).exit_code == 0
    assert json.loads(file.read_text("utf-8"))["contacts"]["places"] == [-1.28, 1.28]


def test_it_says_that_disturbances_grow_along_a_stable_train() -> None:
    done = CliRunner().invoke(cli, ["train", str(EXAMPLES / "endless_train.toml")])
    assert done.exit_code == 0
    assert "grows as it runs back" in done.output
    assert "train of 16: stable" in done.output
    assert "back: at most between 7.0697 and 7.06972" in done.output


def test_json_holds_the_same() -> None:
    done = CliRunner().invoke(cli, ["train", str(EXAMPLES / "endless_train.toml"), "--json"])
    content = json.loads(done.output)
    assert (content["stable"], content["train"]["stable"], content["train"]["count"]) == (False, True, 16)
    assert content["computed"]["long_trains_grow"] is False
    assert 7.06 < content["train"]["back"]["low"] <= content["train"]["back"]["high"] < 7.08


@pytest.mark.parametrize("words", [["--spacing", "0"], []])
def test_one_vehicle_needs_a_distance(words: list[str], tmp_path: Path) -> None:
    file = tmp_path / "one.toml"
    text = (EXAMPLES / "endless_train.toml").read_text("utf-8")
    file.write_text(text.replace("count = 16\nspacing = 1.5\n", ""), encoding="utf-8")
    done = CliRunner().invoke(cli, ["train", str(file), *words])
    assert done.exit_code == 2
    assert "spacing" in done.output


@pytest.mark.slow
def test_eight_coaches_are_answered_within_their_time() -> None:
    started = process_time()
    done = CliRunner().invoke(cli, ["train", str(EXAMPLES / "train_8_coaches.toml"), "--effort", "4"])
    assert process_time() - started < 7
    assert done.exit_code in (0, 1)
    assert "no motion grows" in done.output or "undecided" in done.output
    assert "train of 8: stable" in done.output
    assert "back: " in done.output


def test_units_of_critical_velocities() -> None:
    """A dimensionless file was answered in m/s and km/h; a frequency in Hz was refused, balls were printed raw."""
    paper = run("critical", "examples/dimensionless.toml", "--to", "5").output
    assert paper.startswith("v = 1: two waves")
    assert "m/s" not in paper
    assert "rad" not in paper
    assert run("critical", "examples/dimensionless.toml", "--to", "5 m/s").exit_code == 2
    in_hertz, in_radians = (run("critical", BOGIE, "--omega", x) for x in ("10 Hz", f"{20 * pi} rad/s"))
    assert (in_hertz.exit_code, in_hertz.output) == (0, in_radians.output)
    assert "+/-" not in in_hertz.output
    assert "km/h)" in in_hertz.output
    assert "1000 ≤ v ≤ 1300 m/s" in run("critical", BOGIE, "--from", "3600 km/h", "--to", "1300").output
