"""The commands response and compare, from a file to a file."""

from __future__ import annotations

import csv
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

from mpsolve import Case, PhysicalCase, certify, merged, response, superposition
from mpsolve.cli import cli
from mpsolve.problem.casefile import read_case
from mpsolve.vehicles.load import Load

TEXT = """title = "two"
[dimensionless]
alpha = 0.67
eta_b = 0.05
eta_m = [70, 70]
positions = [0, 1.5]
[[load]]
constant = 1
[[load]]
constant = 1
amplitude = 0.2
frequency = 0.3
"""
CASE = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
LOADS = (Load(), Load(1, "0.2", "0.3"))


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "case.toml"
    path.write_text(TEXT, encoding="utf-8")
    return path


def run(*arguments: object) -> Result:
    return CliRunner().invoke(cli, [str(a) for a in arguments])


def test_response_writes_tables_and_pictures(file: Path, tmp_path: Path) -> None:
    expected = response(CASE, LOADS, None, np.linspace(0, 20, 5))
    table = tmp_path / "out.csv"
    result = run("response", file, "-o", table, "--to", "20", "--points", "5")
    assert result.exit_code == 0, result.output
    assert "induced frequency" in result.output
    assert "w_st = χ/(2k) · unit force" in result.output
    with table.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    for k, row in enumerate(rows):
        assert float(row["tau"]) == expected.tau[k]
        assert float(row["w[xi=1.5]"]) == pytest.approx(expected.w[1, k], abs=1e-12)
        assert float(row["contact_force[1]"]) == pytest.approx(expected.contact_forces[0, k], abs=1e-12)
    arrays = tmp_path / "out.npz"
    assert run("response", file, "-o", arrays, "--to", "20", "--points", "5", "--xi", "0,0.5").exit_code == 0
    with np.load(arrays) as held:
        assert np.allclose(held["w"][0], expected.w[0], rtol=0, atol=1e-8)
        assert np.array_equal(held["xi"], [0, 0.5])
    pytest.importorskip("matplotlib")
    picture = tmp_path / "out.png"
    assert run("response", file, "-o", picture, "--to", "20", "--points", "50").exit_code == 0
    assert picture.read_bytes()[:4] == b"\x89PNG"


def test_compare_holds_the_curves_against_each_other(file: Path, tmp_path: Path) -> None:
    table = tmp_path / "out.csv"
    result = run("compare", file, "-o", table, "--to", "20", "--points", "3")
    assert result.exit_code == 0, result.output
    with table.open(encoding="utf-8", newline="") as stream:
        last = list(csv.DictReader(stream))[-1]
    tau = np.linspace(0, 20, 3)
    whole = response(CASE, LOADS, None, tau)
    assert float(last["complete"]) == pytest.approx(whole.w[0, -1], abs=1e-12)
    added = sum(part.w[0, -1] for part in superposition(CASE, LOADS, None, tau))
    assert float(last["superposition"]) == pytest.approx(added, abs=1e-12)
    assert float(last["one merged mass"]) == pytest.approx(merged(CASE, LOADS, None, tau).w[0, -1], abs=1e-12)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("response", "FILE", "-o", "x.txt"), ".csv"),
        (("response", "FILE", "-o", "x.csv", "--to", "-1"), "--to"),
        (("response", "FILE", "-o", "x.csv", "--xi", "a"), "xi"),
        (("compare", "FILE", "-o", "x.npz"), ".csv"),
    ],
)
def test_input_that_cannot_be_used_is_named(
    file: Path, tmp_path: Path, arguments: tuple[str, ...], said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = run(*(file if a == "FILE" else a for a in arguments))
    assert result.exit_code == 2
    assert said in result.output
    assert sorted(p.name for p in tmp_path.iterdir()) == ["case.toml"]


PHYSICAL = """[physical]
EI = 6.4e6
m = 60
k = 1e6
c = 770
v = 100
[[mass]]
M = 10000
position = 0
[[mass]]
M = 2000
position = 3.4
"""


def test_a_physical_file_gives_its_units_and_the_weights_where_it_has_no_force(tmp_path: Path) -> None:
    file, table, arrays = tmp_path / "case.toml", tmp_path / "out.csv", tmp_path / "out.npz"
    file.write_text(PHYSICAL, encoding="utf-8")
    case = read_case(file)
    assert isinstance(case, PhysicalCase)
    expected = response(case, tau=np.linspace(0, 20, 5))
    assert expected.loads[1].constant == Fraction("19613.3")
    assert "mm" in run("response", file, "-o", table, "--to", "20", "--points", "5").output
    with table.open(encoding="utf-8", newline="") as stream:
        last = list(csv.DictReader(stream))[-1]
    chi = (1e6 / (4 * 6.4e6)) ** 0.25
    assert float(last["t [s]"]) == pytest.approx(20 / (1e6 / 60) ** 0.5, rel=1e-12)
    assert float(last["w[xi=0] [mm]"]) == pytest.approx(1e3 * chi / 2e6 * expected.w[0, -1], rel=1e-9)
    assert float(last["contact_force[2] [kN]"]) == pytest.approx(expected.contact_forces[1, -1] / 1e3, rel=1e-9)
    assert run("response", file, "-o", arrays, "--to", "20", "--points", "5").exit_code == 0
    with np.load(arrays) as held:
        assert held["unit_names"].tolist() == ["s", "mm", "kN"]
        assert held["w"][0, -1] * held["units"][1] == pytest.approx(float(last["w[xi=0] [mm]"]), rel=1e-12)
    result = run("compare", file, "-o", table, "--to", "20", "--points", "3")
    assert "mm" in result.output
    assert "complete [mm]" in table.read_text("utf-8").splitlines()[0]


def test_places_that_differ_in_their_last_digits_are_two_columns(file: Path, tmp_path: Path) -> None:
    table = tmp_path / "out.csv"
    places = "0.12345678901,0.12345678902,1"
    assert run("response", file, "-o", table, "--to", "8", "--points", "2", "--xi", places).exit_code == 0
    header = table.read_text("utf-8").splitlines()[0].split(",")
    assert [name for name in header if name.startswith("w[")] == [f"w[xi={x}]" for x in places.split(",")]


def test_a_curve_that_cannot_be_computed_is_left_out_of_the_comparison(tmp_path: Path) -> None:
    """The force meets the induced frequency of the doubled mass, not one of the pair."""
    doubled = certify(Case(alpha="0.5", eta_b=0, eta_m=140), digits=30).roots[-1].q.real.str(20, radius=False)
    text = TEXT.replace("0.67", "0.5").replace("0.05", "0").replace("0.3", doubled)
    file, table = tmp_path / "case.toml", tmp_path / "out.csv"
    file.write_text(text, encoding="utf-8")
    result = run("compare", file, "-o", table, "--to", "20", "--points", "3")
    assert result.exit_code == 0, result.output
    assert "one merged mass: left out, loads: act at" in result.output
    assert table.read_text("utf-8").startswith("tau,complete,steady and harmonic,superposition,finite beam")


def test_too_many_panels_are_refused(file: Path, tmp_path: Path) -> None:
    places = ",".join(str(k) for k in range(25))
    result = run("response", file, "-o", tmp_path / "out.png", "--points", "2", "--xi", places)
    assert (result.exit_code, "has 25 places" in result.output) == (2, True)


@pytest.mark.parametrize("command", ["response", "compare"])
def test_without_a_file_to_write_it_is_told_alone(command: str, tmp_path: Path) -> None:
    """In s up to 2 s for a file with [track]."""
    given = tmp_path / "oscillator.toml"
    given.write_text(
        'v = "30 m/s"\n[track]\nmodel = "euler-bernoulli"\nEI = 6.4e6\nm = 60\nk = 1e6\nc = 4e4\n'
        '[[vehicle]]\nmodel = "oscillator"\nwheel = 1000\nbody = 5000\nk = 1e6\nc = 1e5\n'
    )
    before = sorted(tmp_path.iterdir())
    told = run(command, given, "--points", 21)
    assert told.exit_code == 0, told.output
    assert ("contact is kept" in told.output) or ("finite track" in told.output)
    assert sorted(tmp_path.iterdir()) == before
    stated = run(command, given, "--points", 21, "--to", "2 s")
    assert stated.output == told.output


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--roughness", "20,0.8"), "--roughness: amplitude is 20 m beside a wavelength of 0.8 m: write '20 µm'"),
        (("--roughness", "1 µm,0"), "--roughness: wavelength is 0, not above 0"),
        (("--roughness", "20"), "--roughness: is '20': give two lengths"),
        (("--out-of-round", "0.1 mm,0.46 m,3,9"), "--out-of-round: contact is 9: give a whole number from 1 to 2"),
        (("--xi", "0 km,1 kg"), "--xi: is '1 kg', whose unit is kg, but the place is in m"),
    ],
)
def test_lengths_are_told_by_their_options(options: tuple[str, str], said: str) -> None:
    """A wave of 20 m on the rail went without a word; places had no units."""
    result = CliRunner().invoke(cli, ["response", "examples/two_layer_bogie.toml", "--to", "0.1", *options])
    assert result.exit_code == 2
    assert result.stderr.startswith(f"mpsolve: {said}")


def test_places_may_have_units() -> None:
    outputs = {CliRunner().invoke(cli, ["response", "examples/two_layer_bogie.toml", "--to", "0.1", "--xi", x]).output
               for x in ("0,1.5", "0 mm,1500 mm")}  # fmt: skip
    assert len(outputs) == 1
    assert "rail: largest deflection" in outputs.pop()
