"""One sentence for each mistake that people make, and none for what is right."""

from __future__ import annotations

import pickle
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from mpsolve import Case, Problem, read_problem, tracks, vehicles
from mpsolve.cli import cli
from mpsolve.presets.written import input_file, names
from mpsolve.problem.inputfile import read_source
from mpsolve.problem.warned import Title, titled, warned

RAIL: dict[str, Any] = {"EI": "6.4e6", "m": 60, "k": "1e6", "c": 770}
PAIR = [vehicles.Mass(900).at(0), vehicles.Mass(900).at("2.5")]
EXAMPLES = Path(__file__).parents[2] / "examples"


def codes(problem: Any, frequencies: Any = ()) -> list[str]:
    return [reason.code for reason in warned(problem, frequencies)]


def changed(**changes: Any) -> Problem:
    return Problem(tracks.EulerBernoulli(**{**RAIL, **changes}), PAIR, v=100)


def test_nothing_is_said_of_what_is_right(tmp_path: Path) -> None:
    assert not warned(changed())
    for name in names("track"):
        file = tmp_path / f"{name}.toml"
        file.write_text(input_file(name), "utf-8")
        assert not warned(read_problem(file).problem), name
    for name in ("two_layer_bogie", "train_8_coaches", "rail_60e1", "dimensionless"):
        assert not warned(read_problem(EXAMPLES / f"{name}.toml").given), name


MASS = vehicles.Mass(900)
AXLES = vehicles.Vehicle(
    M=[[900, 0], [0, 900]], C=[[0] * 2] * 2, K=[[0] * 2] * 2, B=[[1, 0], [0, 1]], places=[0, "0.001"]
)


def test_two_masses_at_one_place() -> None:
    twins = Problem(tracks.EulerBernoulli(**RAIL), [vehicles.Mass(900), vehicles.Mass(800)], v=100)
    (said,) = warned(twins)
    assert said.code == "contacts-at-one-place"
    assert str(said) == (
        "two vehicles, mass and mass, stand at one place, x = 0 m: "
        "give one of them another position, if that is not meant"
    )
    assert codes(Case(alpha="0.5", eta_b="0.1", eta_m=[1, 1], positions=[2, 2])) == ["contacts-at-one-place"]


@pytest.mark.parametrize(
    ("given", "gap"),
    [
        (Problem(tracks.EulerBernoulli(**RAIL), [MASS.at(0), MASS.at("1e-7 mm")], v=100), "1e-7 mm"),
        (Problem(tracks.EulerBernoulli(**RAIL), [MASS.at("1e-10"), MASS.at("-0.004")], v=100), "4 mm"),
        (Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1), [MASS.at(0), MASS.at("1e-10")], v="0.5"), "1e-10"),
        (Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1), [MASS.at(0), MASS.at("0.004")], v="0.5"), None),
        (Problem(tracks.EulerBernoulli(**RAIL), [MASS.at(0), MASS.at("0.1")], v=100), None),
        (Problem(tracks.EulerBernoulli(**RAIL), [AXLES], v=100), "1 mm"),
        (Case(alpha="0.5", eta_b="0.1", eta_m=[1, 1], positions=[2, "2.0000000001"]), "1e-10"),
        (Case(alpha="0.5", eta_b="0.1", eta_m=[1, 1], positions=[2, "2.0001"]), None),
    ],
)
def test_contacts_that_all_but_meet(given: Any, gap: str | None) -> None:
    """A position in the wrong unit: the answer is right, but about something else than was meant."""
    near = [one for one in warned(given) if one.code == "contacts-nearly-at-one-place"]
    assert [one.numbers["gap"] for one in near] == [gap] * (gap is not None)
    assert all(str(one).endswith(f"stand only {gap} apart: check their positions") for one in near)


BOGIE = vehicles.Bogie(wheel=900, frame=1300, inertia=700, wheelbase="2.5", k="1.2e6", c=4000)


@pytest.mark.parametrize(
    ("placed", "said"),
    [
        ([BOGIE, BOGIE], ["contacts-at-one-place"]),
        ([BOGIE.at(5), BOGIE.at(0), BOGIE.at(5)], ["contacts-at-one-place"]),
        ([BOGIE.at(0), BOGIE.at(1)], ["vehicles-overlap"]),
        (vehicles.train(BOGIE, 40, 2), ["vehicles-overlap"]),
        ([vehicles.Mass(900).at(1), BOGIE], ["vehicles-overlap"]),
        ([BOGIE.at(0), BOGIE.at("2.6")], []),
        (vehicles.train(BOGIE, 40, 20), []),
    ],
)
def test_vehicles_in_each_other(placed: Any, said: list[str]) -> None:
    assert codes(Problem(tracks.EulerBernoulli(**RAIL), placed, v=70)) == said


@pytest.mark.parametrize(("EI", "meant"), [("6.4", "6.4 MN m²"), ("6.4e12", "6.4 MN m²")])
def test_a_bending_stiffness_a_million_off(EI: str, meant: str) -> None:
    (said,) = warned(changed(EI=EI))
    assert said.code == "bending-stiffness-unlikely"
    assert f'write EI = "{meant}"' in said.remedy
    assert not warned(changed(EI=Fraction(64 * 10**5)))


def test_kilometres_an_hour() -> None:
    (said,) = warned(Problem(tracks.EulerBernoulli(**RAIL), PAIR, v=250))
    assert str(said) == 'v is 250 m/s, which is 900 km/h: write v = "250 km/h", if km/h is meant'
    assert not warned(Problem(tracks.EulerBernoulli(**RAIL), PAIR, v="250 km/h"))
    (said,) = warned(Problem(tracks.EulerBernoulli(**RAIL), PAIR, v="1000 km/h"))
    assert str(said) == "v is 277.8 m/s, which is 1000 km/h: check it, if that is not meant"


def test_more_than_critical_damping() -> None:
    (said,) = warned(changed(c="1.2e5"))
    assert said.code == "overdamped"
    assert said.numbers["times"] == "7.7"
    assert "track.c is 120000 N s/m² (120 kN s/m²), 7.7 times the critical damping" in said.message
    assert "either c is too large or k too small" in said.remedy
    quarter = vehicles.Oscillator(wheel=900, body=10_000, k=10**6, c=300_000)
    assert codes(Problem(tracks.EulerBernoulli(**RAIL), quarter, v=1)) == ["overdamped"]
    assert codes(Case(alpha="0.5", eta_b="1.1", eta_m=[1])) == ["overdamped"]


def test_frequencies_beyond_the_model() -> None:
    layers = tracks.TwoLayer(
        EI="6.4e6", m=60, k_pad="3e8", c_pad="3e4", m_sleeper=250, k_ballast="1e8", c_ballast="8e4"
    )
    problem = Problem(layers, PAIR, v=70)
    assert codes(problem, [40.0, 300.0]) == []
    assert codes(problem, [900.0]) == ["beam-without-shear"]
    assert codes(problem, [3.0, 1600.0]) == ["beam-without-shear", "sleepers-smeared"]
    stiff = tracks.Timoshenko(EI="6.4e6", m=60, S="2e8", J="0.24", k="1e8", c="3e4")
    assert codes(Problem(stiff, PAIR, v=70), [1600.0]) == []


def test_ratios_have_no_units_that_could_be_wrong() -> None:
    paper = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
    assert not warned(Problem(paper, [vehicles.Mass(70).at(0)], v=200), [1e6])
    assert not warned(Case(alpha="1.5", eta_b="0.1", eta_m=[1]))


RAIL: dict[str, Any] = {"EI": "6.4e6", "m": 60, "k": "1e6", "c": 770}
EXAMPLES = Path(__file__).parents[2] / "examples"


def at_speed(v: object = 100) -> Problem:
    return Problem(tracks.EulerBernoulli(**RAIL), [vehicles.Mass(900).at(0), vehicles.Mass(900).at("2.5")], v=v)


def test_a_title_in_kilometres_an_hour() -> None:
    (said,) = titled(at_speed(), "Bogie at 100 km/h")
    assert str(said) == (
        'v is 100 m/s, which is 360 km/h, but the title says 100 km/h: write v = "100 km/h", if that is meant'
    )
    assert not titled(at_speed(), "A bogie, at 100 m/s (360 km/h)")
    assert not titled(at_speed(), "100 wheels")
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
    assert titled(at_speed(), Title("", bare=True))
    for name in names("track"):
        file = tmp_path / f"{name}.toml"
        file.write_text(input_file(name), "utf-8")
        source = read_source(file)
        assert not titled(source.given, source.title), name
    for file in EXAMPLES.glob("*.toml"):
        if {"vehicle", "physical"} & {line.strip("[] ") for line in file.read_text("utf-8").splitlines()}:
            source = read_source(file)
            assert not titled(source.given, source.title), file.name
