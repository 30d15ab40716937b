"""A file with any track and any vehicles gives the problem that Python gives, or a sentence that names the key."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from track_models import random_tracks
from vehicle_models import BOGIE, TYPICAL, random_vehicles

from mpsolve import PhysicalCase, tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.numbers.model import Model
from mpsolve.problem.casefile import read_input
from mpsolve.problem.cases import as_problem
from mpsolve.problem.inputfile import read_problem
from mpsolve.problem.problem import Problem
from mpsolve.vehicles.load import Load

EXAMPLES = Path(__file__).parents[2] / "examples"
TRACK = """
v = 40.5
[track]
model = "string"
T = 27000
m = 1.07
k = "1000/3"
"""
WHEEL = """
[[vehicle]]
model = "mass"
M = 8.5
"""
BOTH = TRACK + WHEEL
COACH = TRACK + "[[vehicle]]\nmodel = 'coach'\nbody = 1\ninertia = 1\npivots = 1\n"


@pytest.fixture
def written(tmp_path: Path) -> Path:
    return tmp_path / "problem.toml"


def toml(value: Any) -> str:
    if isinstance(value, tuple):
        return "[" + ", ".join(map(toml, value)) + "]"
    return f'"{value}"'


def section(head: str, model: Model, **more: Any) -> str:
    """A model as a section of a file; a part, as the bogie of a coach, is a section in it."""
    name = head.strip("[]")
    lines = [head] + ([f'model = "{model.name}"'] if "." not in name else [])
    parts = {key: value for key, value in model.parameters.items() if isinstance(value, Model)}
    lines += [f"{key} = {toml(value)}" for key, value in (model.parameters | more).items() if key not in parts]
    return "\n".join(lines) + "\n" + "".join(section(f"[{name}.{key}]", part) for key, part in parts.items())


def read(written: Path, text: str) -> Problem:
    written.write_text(text, "utf-8")
    return read_problem(written).problem


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    random_tracks(),
    st.lists(st.tuples(random_vehicles(), st.fractions(-9, 9, max_denominator=8)), min_size=1, max_size=3),
)
def test_every_model_can_be_written(written: Path, track: tracks.Track, placed: list[Any]) -> None:
    text = 'v = "7/3"\n' + section("[track]", track)
    text += "".join(section("[[vehicle]]", vehicle, position=x) for vehicle, x in placed)
    assert read(written, text) == Problem(track, [vehicle.at(x) for vehicle, x in placed], v="7/3")


def test_vehicles_by_matrices_and_trains(written: Path) -> None:
    own, text = TYPICAL["matrices"], TRACK
    text += section("[[vehicle]]", own, position=-3)
    text += '[[vehicle]]\nmodel = "mass"\nM = 2\ncount = 3\nspacing = 2.5\nposition = 1\n'
    expected = [own.at(-3), vehicles.Mass(2).at(1), vehicles.Mass(2).at("3.5"), vehicles.Mass(2).at(6)]
    assert read(written, text) == Problem(tracks.String(27000, "1.07", "1000/3"), expected, v="40.5")


def test_title_loads_and_path(written: Path) -> None:
    load = "[[load]]\nconstant = 100\n[[load]]\namplitude = 0.5\nfrequency = 12\nphase = 0.1\n"
    written.write_text('title = "Wire"\n' + BOTH + WHEEL + load, "utf-8")
    found = read_problem(str(written))
    assert (found.title, found.path, found.case) == ("Wire", written, None)
    assert found.loads == (Load(100), Load(1, "0.5", 12, "0.1"))
    written.write_text(BOTH, "utf-8")
    assert read_problem(written).loads is None


@pytest.mark.parametrize("name", ["rail_60e1", "dimensionless", "loads"])
def test_the_files_of_today_stay_valid(name: str) -> None:
    path = EXAMPLES / f"{name}.toml"
    found, source = read_problem(path), read_input(path)
    assert (found.problem, found.title, found.loads) == (as_problem(source.case), source.title, source.loads)
    assert found.case == source.case


def test_the_forces_of_a_physical_case_are_in_newton(written: Path) -> None:
    written.write_text(
        "[physical]\nEI = 1\nm = 1\nk = 4\nv = 1\n[[mass]]\nM = 3\nposition = 0\nP = 5\nP_A = 2\nomega_f = 7\n",
        "utf-8",
    )
    found = read_problem(written)
    assert isinstance(found.case, PhysicalCase)
    assert found.loads == (Load(5, 2, 7),)
    assert found.problem.vehicles[0].vehicle.M == 3


def test_the_example() -> None:
    found = read_problem(EXAMPLES / "two_layer_bogie.toml")
    assert found.problem.track == tracks.TwoLayer(
        EI=Fraction("210e9") * Fraction("3038.30e-8"), m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper=250,
        k_ballast="100e6", c_ballast="8e4",
    )  # fmt: skip
    half = {key: value if key == "wheelbase" else Fraction(value) / 2 for key, value in BOGIE.items()}
    assert found.problem.vehicles == (vehicles.Bogie(**half, k_contact="1.4e9").at(0),)
    assert found.problem.v == 100
    assert "360 km/h" in found.title


@pytest.mark.parametrize(
    ("text", "key", "said"),
    [
        ("", "", "holds no problem"),
        ("[trakc]\n" + WHEEL.strip(), "trakc", "did you mean track"),
        ("[trakc]\n", "trakc", "did you mean track"),
        (WHEEL, "track", "missing"),
        (TRACK, "vehicle", "missing"),
        (BOTH.replace("v = 40.5", ""), "v", "velocity in m/s"),
        (BOTH.replace("v = 40.5", "v = -1"), "v", "below 0"),
        (BOTH.replace("v = 40.5", "v = [1]"), "v", "not a number"),
        ("title = 3\n" + BOTH, "title", "not a text"),
        ("speed = 3\n" + BOTH, "speed", "is unknown"),
        (BOTH + "[physical]\n", "physical", "stands beside"),
        (BOTH.replace('"string"', '"strnig"'), "track.model", "did you mean string"),
        (BOTH.replace('"string"', '"zzz"'), "track.model", "the models are string, euler-bernoulli"),
        (BOTH.replace('"string"', "3"), "track.model", "unknown"),
        (BOTH.replace('model = "string"', ""), "track.model", "missing"),
        ("track = 5\nv = 1\n" + WHEEL, "track", "not a section"),
        (BOTH.replace("T = 27000", ""), "track.T", "give the tension in N"),
        (BOTH.replace("T = 27000", "T = 0"), "track.T", "above 0"),
        (BOTH.replace("T = 27000", "T = true"), "track.T", "not a number"),
        (BOTH.replace("k = ", "stiffness = "), "track.stiffness", "unknown"),
        (BOTH.replace("m = 1.07", "m = 1.07\nt = 3"), "track.t", "did you mean T"),
        (BOTH.replace("M = 8.5", ""), "vehicle[1].M", "mass on one rail in kg"),
        (BOTH + WHEEL.replace("8.5", "-1"), "vehicle[2].M", "above 0"),
        (BOTH + "postion = 3\n", "vehicle[1].postion", "did you mean position"),
        (BOTH + 'position = "x"\n', "vehicle[1].position", "not a number"),
        (BOTH + "count = 3\n", "vehicle[1].spacing", "missing"),
        (BOTH + "spacing = 3\n", "vehicle[1].count", "missing"),
        (BOTH + "count = 1.5\nspacing = 3\n", "vehicle[1].count", "whole number"),
        (BOTH + "count = 2\nspacing = -3\n", "vehicle[1].spacing", "above 0"),
        (TRACK + "[vehicle]\nmodel = 'mass'\n", "vehicle", "double brackets"),
        ("vehicle = [3]\n" + TRACK, "vehicle[1]", "not a section"),
        ("vehicle = []\n" + TRACK, "vehicles", "at least one"),
        (BOTH + "[[load]]\n[[load]]\n", "load", "is given for 2, not 1 contacts"),
        (BOTH + "[[load]]\nconstnat = 3\n", "load[1].constnat", "did you mean constant"),
        (BOTH + "[[load]]\namplitude = 'a'\n", "load[1].amplitude", "not a number"),
        (COACH, "vehicle[1].bogie", "missing"),
        (COACH + "bogie = 3\n", "vehicle[1].bogie", "section"),
        (COACH + "k2 = 1\n[vehicle.bogie]\nwheel = 0\n"
         "frame = 1\ninertia = 1\nwheelbase = 1\nk = 1\n", "vehicle[1].bogie.wheel", "above 0"),
        (TRACK + "[[vehicle]]\nmodel = 'matrices'\nM = [[1]]\nC = [[0]]\nK = [[0, 1]]\nB = [[1]]\nplaces = [0]\n",
         "vehicle[1].K", "1 × 1"),
        ("[dimensionless]\nalpha = 'root4(2)'\neta_b = 0\neta_m = [1]\npositions = [0]\n", "dimensionless.alpha",
         "irrational"),
    ],
)  # fmt: skip
def test_mistakes_are_named_by_their_key(written: Path, text: str, key: str, said: str) -> None:
    written.write_text(text, "utf-8")
    with pytest.raises(InputError, match=said) as caught:
        read_problem(written)
    assert caught.value.key == (key or str(written))


def test_values_may_carry_units(written: Path) -> None:
    text = """
v = "360 km/h"
[track]
model = "euler-bernoulli"
EI = "6.4 MN m²"
m = "60 kg/m"
k = "1 MN/m²"
c = "0.77 kN s/m²"
N = "-200 kN"
[[vehicle]]
model = "oscillator"
position = "250 cm"
wheel = "900 kg"
body = "12.5 t"
k = "35 kN/mm"
c = "4 kN s/m"
count = 2
spacing = "20 m"
[[load]]
constant = "98 kN"
frequency = "20 rad/s"
[[load]]
"""
    problem = read(written, text)
    beam = tracks.EulerBernoulli(EI=6_400_000, m=60, k=10**6, c=770, N=-200_000)
    quarter = vehicles.Oscillator(wheel=900, body=12_500, k=35 * 10**6, c=4000)
    assert problem == Problem(beam, [quarter.at("2.5"), quarter.at("22.5")], v=100)
    assert read_problem(written).loads == (Load(98_000, 0, 20, 0), Load())


def test_units_in_a_file_of_the_paper(written: Path) -> None:
    written.write_text(
        '[physical]\nEI = "6.4 MN m²"\nm = "60 kg/m"\nk = "1 MPa"\nv = "360 km/h"\n'
        '[[mass]]\nM = "10 t"\nposition = "50 cm"\nP = "98 kN"\n',
        "utf-8",
    )
    case = read_problem(written).case
    assert isinstance(case, PhysicalCase)
    assert (case.EI, case.k, case.v, case.masses[0].M) == (6_400_000, 10**6, 100, 10_000)
    assert (case.masses[0].position, case.masses[0].P) == (Fraction(1, 2), 98_000)


@pytest.mark.parametrize(
    ("old", "new", "key", "said"),
    [
        ("T = 27000", 'T = "27 kN m"', "track.T", "'27 kN m', whose unit is N m, but the tension is in N"),
        ("m = 1.07", 'm = "1,07 kg/m"', "track.m", "'1,07 kg/m', with a comma"),
        ("M = 8.5", 'M = "8.5 KG"', "vehicle[1].M", "did you mean kg"),
        ("v = 40.5", 'v = "40.5 km"', "v", "'40.5 km', whose unit is m, but the velocity is in m/s"),
    ],
)
def test_a_wrong_unit_is_told_in_the_words_of_the_file(
    written: Path, old: str, new: str, key: str, said: str
) -> None:
    with pytest.raises(InputError, match=said) as caught:
        read(written, BOTH.replace(old, new))
    assert caught.value.key == key


def test_matrices_take_units_of_rotations_too(written: Path) -> None:
    text = TRACK + (
        '[[vehicle]]\nmodel = "matrices"\nM = [["3 t", 0], [0, "5 t m²"]]\nC = [[0, 0], [0, 0]]\n'
        'K = [["5 kN/mm", 0], [0, "2 kN m"]]\nB = [[1, 1], ["-125 cm", "1.25 m"]]\nplaces = ["-125 cm", 1.25]\n'
    )
    own = read(written, text).vehicles[0].vehicle
    assert isinstance(own, vehicles.Vehicle)
    assert own.M == ((3000, 0), (0, 5000))
    assert own.K == ((5_000_000, 0), (0, 2000))
    assert own.B[1] == own.places == (Fraction(-5, 4), Fraction(5, 4))
    with pytest.raises(InputError, match="whose unit is m/s"):
        read(written, text.replace('"3 t"', '"3 m/s"'))
