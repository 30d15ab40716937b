"""response and compare on files in SI: m, s, N in tables with units, pictures, a film, the first lift-off."""

from __future__ import annotations

import csv
import json
import xml.etree.ElementTree as ET
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner, Result

from mpsolve import out_of_round, rail_roughness, read_problem, response
from mpsolve.cli import cli
from mpsolve.vibration import vibrate

BOGIE = Path("examples/two_layer_bogie.toml")
MASSES = Path("examples/rail_60e1.toml")


def run(*arguments: object) -> Result:
    return CliRunner().invoke(cli, [str(a) for a in arguments])


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def test_a_table_in_SI_with_units(tmp_path: Path) -> None:
    table = tmp_path / "out.csv"
    result = run("response", BOGIE, "-o", table, "--to", "0.2 s", "--points", "21", "--xi", "0,3.4")
    assert result.exit_code == 0, result.output
    assert "induced frequency 6.76444 Hz decays" in result.output
    assert "contact is kept up to 0.2 s." in result.output
    found = response(read_problem(BOGIE).problem, times=np.linspace(0, 0.2, 21), places=[0, "3.4"])
    for k, row in enumerate(rows_of(table)):
        assert float(row["t [s]"]) == found.times[k]
        assert float(row["w at x = 3.4 m [m]"]) == pytest.approx(found.rail[1, k], abs=1e-15)
        assert float(row["frame pitch [rad]"]) == pytest.approx(found.vehicle["frame pitch"][k], abs=1e-15)
        assert float(row["contact force 2 [N]"]) == pytest.approx(found.contact_force[1, k], abs=1e-6)
        assert row["within the model [1]"] == "1.0"


def test_what_is_beyond_the_model_is_marked(tmp_path: Path) -> None:
    """A file of the paper's beam in SI, with its time in s; the masses leave the rail at 0.317 s."""
    table = tmp_path / "out.csv"
    result = run("response", MASSES, "-o", table, "--to", "1 s", "--points", "101")
    assert result.exit_code == 0, result.output
    assert "contact 1 lifts off at t = 0.317316" in result.output
    marks = [row["within the model [1]"] for row in rows_of(table)]
    assert marks == ["1.0"] * 32 + ["0.0"] * 69
    picture = tmp_path / "out.svg"
    assert run("response", MASSES, "-o", picture, "--to", "1 s", "--points", "51").exit_code == 0
    assert "<svg" in picture.read_text("utf-8")


def test_arrays_and_a_film(tmp_path: Path) -> None:
    arrays, film = tmp_path / "out.npz", tmp_path / "film.svg"
    result = run(
        "response", MASSES, "-o", arrays, "--to", "1 s", "--points", "11", "--animate", film, "--initial", "rest"
    )
    assert result.exit_code == 0, result.output
    with np.load(arrays) as found:
        assert found["rail"].shape == (2, 11)
        assert found["vehicle"].shape == (2, 11)
        assert found["within"].tolist() == [True] * 4 + [False] * 7
    root = ET.parse(film).getroot()
    moved = [one.attrib["attributeName"] for one in root.iter("{http://www.w3.org/2000/svg}animate")]
    assert moved == ["points", "stroke", "cy", "cy", "y", "y", "cx"]
    assert "beyond the model" in film.read_text("utf-8")


@pytest.mark.parametrize(
    ("option", "text", "rough"),
    [
        ("--roughness", "20 µm, 0.8 m", lambda problem: rail_roughness(problem, "2e-5", "0.8")),
        ("--out-of-round", "0.1 mm,0.46 m,3,2", lambda problem: out_of_round(problem, "1e-4", "0.46", 3, 2)),
        ("--out-of-round", "0.1 mm, 0.46", lambda problem: out_of_round(problem, "1e-4", "0.46")),
    ],
)
def test_a_rough_rail_and_uneven_wheels(option: str, text: str, rough: Any, tmp_path: Path) -> None:
    table = tmp_path / "out.csv"
    given = [BOGIE, "-o", table, "--to", "0.05 s", "--points", 11, "--initial", "steady", option, text]
    result = run("response", *given)
    assert result.exit_code == 0, result.output
    problem = read_problem(BOGIE).problem
    times = np.linspace(0, 0.05, 11)
    known = response(problem, times=times, initial="steady", irregularities=rough(problem)).contact_force[1]
    assert [float(row["contact force 2 [N]"]) for row in rows_of(table)] == pytest.approx(known, rel=1e-9)
    assert known.std() > 100


def test_compare_holds_the_other_ways_against_it(tmp_path: Path) -> None:
    table = tmp_path / "out.csv"
    result = run("compare", MASSES, "-o", table, "--to", "0.3 s", "--points", "16")
    assert result.exit_code == 0, result.output
    rows = rows_of(table)
    for name in ("complete", "superposition", "one merged mass", "finite track"):
        assert f"{name} [m]" in rows[0]
    apart = [abs(float(row["complete [m]"]) - float(row["finite track [m]"])) for row in rows]
    assert max(apart) < 2e-3 * max(abs(float(row["complete [m]"])) for row in rows)


def test_compare_leaves_out_what_is_late(tmp_path: Path) -> None:
    few = run("compare", MASSES, "-o", tmp_path / "out.csv", "--to", "0.3 s", "--points", "16", "--effort", "1e-3")
    assert few.exit_code == 1
    assert few.stderr.startswith("mpsolve: the effort of 0.001 s of processor time was spent before the motion was")
    assert "--effort SECONDS" in few.stderr
    started = process_time()
    some = run("compare", MASSES, "-o", tmp_path / "out.csv", "--to", "40 s", "--points", "99", "--effort", "1.5")
    assert process_time() - started < 3
    assert some.exit_code == 0
    assert (
        "finite track: left out, the effort of 1.5 s of processor time was spent before it was computed"
        in some.output
    )


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["examples/dimensionless.toml", "--to", "2 s"], "--to: is 2 s, but the file is dimensionless"),
        (["examples/dimensionless.toml", "--initial", "steady"], "--initial: is for a motion in s"),
        ([str(BOGIE), "--to", "0 s"], "--to: is 0 s: give a time above 0"),
        ([str(BOGIE), "--to", "x"], "--to"),
        ([str(BOGIE), "--to", "1e9 s"], "--to: end at 1e+09 s"),
        ([str(BOGIE), "--to", "1 s", "--animate", "film.gif"], "film.gif"),
        ([str(BOGIE), "--to", "1 s", "--roughness", "20 µm"], "--roughness: is '20 µm': give two lengths"),
        ([str(BOGIE), "--to", "1 s", "--roughness", "20 µm, 3 kg"], "--roughness"),
        ([str(BOGIE), "--to", "1 s", "--out-of-round", "1 mm, 0.5 m, 0"], "--out-of-round: order is 0"),
        ([str(BOGIE), "--to", "1 s", "--out-of-round", "1 mm, 1 m", "--roughness", "1 mm, 1 m"], "one of them"),
        (["examples/dimensionless.toml", "--roughness", "1 mm, 1 m"], "--roughness: is for a motion in s"),
    ],
)
def test_options_that_cannot_be_used_are_named(arguments: list[str], said: str, tmp_path: Path) -> None:
    result = run("response", arguments[0], "-o", tmp_path / "out.csv", *arguments[1:])
    assert result.exit_code == 2, result.output
    assert said in result.output + result.stderr


def test_an_effort_is_kept_and_what_is_known_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`response` of many times had no limit. Where nothing is known nothing is written; else the rest is left out."""
    table = tmp_path / "out.json"
    none = run("response", BOGIE, "-o", table, "--effort", "1e-9")
    assert (none.exit_code, table.exists()) == (1, False)
    assert (
        none.stderr == "mpsolve: the effort of 1e-09 s of processor time is spent: allow more with --effort SECONDS\n"
    )
    assert run("response", BOGIE, "--effort", "0").exit_code == 2
    monkeypatch.setattr("mpsolve.vibration.vibrate._CHUNK", 50)
    spent = iter([0.0] * 3 + [1e9] * 100)

    def read_off(*given: Any) -> Any:
        monkeypatch.setattr("mpsolve.proof.effort.process_time", lambda: next(spent))
        return own(*given)

    own = vibrate._read_off
    monkeypatch.setattr(vibrate, "_read_off", read_off)
    part = run("response", BOGIE, "-o", table, "--to", "0.2 s", "--points", "401", "--effort", "1e6")
    assert part.exit_code == 1
    assert part.output.startswith("Not all that was asked for: the effort of 1e+06 s of processor time is spent")
    columns = {one["name"]: one["values"] for one in json.loads(table.read_text("utf-8"))["columns"]}
    assert 50 <= len(columns["t"]) < 401
    assert {len(values) for values in columns.values()} == {len(columns["t"])}
    assert f"contact is kept up to {columns['t'][-1]:.6g} s." in part.output


UNPRESSED = """
v = 30
track = {model = "euler-bernoulli", EI = 6.4e6, m = 60, k = 1e7, c = 5e4}
vehicle = [{model = "mass", M = 900}, {model = "mass", M = 900, position = 3}]
load = [{constant = FIRST, amplitude = 1000, frequency = 100}, {constant = 9000}]
"""


@pytest.mark.parametrize("first", ["-9000", "0"])
def test_a_contact_that_nothing_presses_is_not_said_to_be_kept(tmp_path: Path, first: str) -> None:
    """Its force is tension, at rest or in turns: "contact is kept" would be wrong, and a lift-off means nothing."""
    source, table = tmp_path / "in.toml", tmp_path / "out.csv"
    source.write_text(UNPRESSED.replace("FIRST", first), "utf-8")
    result = run("response", source, "-o", table, "--to", "0.5 s", "--points", "101")
    assert result.exit_code == 0, result.output
    assert min(float(row["contact force 1 [N]"]) for row in rows_of(table)) < -500
    assert (
        "contact 1: no constant force presses it, so it cannot be judged.\nthe other contacts are kept up to 0.5 s."
        in (result.output)
    )
    assert "contact is kept" not in result.output
    source.write_text(UNPRESSED.replace("FIRST", first).replace("9000}]", "0}]"), "utf-8")
    result = run("response", source, "-o", table, "--to", "0.5 s", "--points", "11")
    assert "contact 2: no constant force" in result.output
    assert " kept" not in result.output
