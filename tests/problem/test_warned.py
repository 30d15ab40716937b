"""One sentence for each mistake that people make, and none for what is right."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from mpsolve import Case, Problem, read_problem, tracks, vehicles
from mpsolve.presets.written import input_file, names
from mpsolve.problem.warned import warned

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


def test_two_masses_at_one_place() -> None:
    twins = Problem(tracks.EulerBernoulli(**RAIL), [vehicles.Mass(900), vehicles.Mass(800)], v=100)
    (said,) = warned(twins)
    assert said.code == "contacts-at-one-place"
    assert str(said) == (
        "two vehicles, mass and mass, stand at one place, x = 0 m: "
        "give one of them another position, if that is not meant"
    )
    assert codes(Case(alpha="0.5", eta_b="0.1", eta_m=[1, 1], positions=[2, 2])) == ["contacts-at-one-place"]


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
