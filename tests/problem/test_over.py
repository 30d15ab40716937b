"""Ranges as they are written: exact ends, a unit for both, an end that is open, each mistake quoted."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.problem.over import parse_over, parse_overs

PAIR = Problem(
    tracks.EulerBernoulli(EI="6.4 MN m²", m="60 kg/m", k="1 MPa", c="770 N s/m²"),
    [vehicles.Mass("10 t").at(0), vehicles.Mass("10 t").at("340 cm")],
    v="360 km/h",
)


@pytest.mark.parametrize(
    ("text", "low", "high", "unit"),
    [
        ("v=0..400km/h", 0, Fraction(1000, 9), "km/h"),
        ("v = 100 .. 400 km/h", Fraction(250, 9), Fraction(1000, 9), "km/h"),
        ("v=36 km/h..20 m/s", 10, 20, "m/s"),
        ("v=36 km/h..72", 10, 20, "km/h"),
        ("v=0..100", 0, 100, "m/s"),
        ("v=0..", 0, None, "m/s"),
        ("v=36km/h..", 10, None, "km/h"),
        ("track.k=0.5..2 MN/m²", 500_000, 2_000_000, "MN/m²"),
        ("vehicles.M=1..20 t", 1000, 20_000, "t"),
        ("vehicles[1].M=0..20t", 0, 20_000, "t"),
        ("gap[0]=.5...75", Fraction(1, 2), Fraction(3, 4), "m"),
        ("scale.mass=1/2..3", Fraction(1, 2), 3, ""),
    ],
)
def test_ranges(text: str, low: Fraction, high: Fraction | None, unit: str) -> None:
    over = parse_over(text, PAIR)
    assert (over.low, over.high, over.unit) == (low, high, unit)
    assert over.path == text.partition("=")[0].strip()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("0..400km/h", "names no parameter"),
        ("v=400km/h", "has no range"),
        ("v=..400", "no lower end"),
        ("v=400..0", "do not ascend"),
        ("v=5..5", "do not ascend"),
        ("v=-5..5", "must not go below 0"),
        ("v=0..5 kg", "whose unit is kg, but the velocity is in m/s"),
        ("speed=0..5", "'speed', which is unknown: the parameters are v, "),
        ("track.kk=0..5", "did you mean track.k"),
        ("gap[1]=0..5", "is unknown"),
        ("vehicle[1].M=1..2 t", r"so write vehicles\[0\].M for the rearmost, or vehicles.M"),
        ("v=0..fast", "'fast' is not a number"),
    ],
)
def test_mistakes_are_quoted(text: str, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        parse_over(text, PAIR)
    assert caught.value.key == "--over"


def test_ends_are_shown_in_the_unit_that_was_written() -> None:
    over = parse_over("v=0..400km/h", PAIR)
    assert over.shown(over.high or Fraction(0)) == 400
    assert over.si == "m/s"


def test_a_value_outside_the_range_is_told() -> None:
    assert parse_over("v=0..400km/h", PAIR).outside(PAIR) is None
    told = parse_over("v=0..90km/h", PAIR).outside(PAIR)
    assert told is not None
    assert told.code == "value-outside-range"
    assert "v is 360 km/h, outside the range from 0 to 90 km/h" in str(told)
    assert parse_over("scale.mass=2..3", PAIR).outside(PAIR) is None
    assert parse_over("v=500km/h..", PAIR).outside(PAIR) is not None


def test_several_ranges() -> None:
    assert [over.path for over in parse_overs(["v=0..100", "vehicles.M=1..20 t"], PAIR)] == ["v", "vehicles.M"]
    with pytest.raises(InputError, match="names v twice"):
        parse_overs(["v=0..100", "v=5.."], PAIR)
