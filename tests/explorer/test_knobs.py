"""Sliders lead where they say, stand where a value is, and fields show what can be typed again."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.explorer.knobs import Knob, field_text, knobs, own_size
from mpsolve.numbers.units import in_unit

PROBLEM = Problem(
    tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770, N=-1000), [vehicles.Mass(900).at(0)], v=Fraction(250, 9)
)


@pytest.mark.parametrize(
    "knob",
    [
        Knob(Fraction(60), Fraction(0)),
        Knob(Fraction(0), Fraction(1000)),
        Knob(Fraction(0), Fraction(1000), both=True),
    ],
)
def test_position_and_value_belong_together(knob: Knob) -> None:
    for position in (knob.least, 20, 73, 100):
        assert knob.position(Fraction(knob.value(position))) == pytest.approx(position, abs=1)


def test_the_ends() -> None:
    about, up = Knob(Fraction(60), Fraction(0)), Knob(Fraction(0), Fraction(1000))
    assert [about.value(x) for x in (-100, 0, 100)] == ["6", "60", "600"]
    assert [up.value(x) for x in (0, 50, 100)] == ["0", "125", "1000"]
    assert (about.position(Fraction(10**9)), about.position(Fraction(0)), up.position(Fraction(0))) == (100, -100, 0)


def test_what_may_be_negative_has_a_symmetric_linear_slider() -> None:
    found = knobs(PROBLEM, PROBLEM.parameters)
    assert set(found) == set(PROBLEM.parameters)
    assert found["track.eta"].base == 0 < found["track.eta"].reach
    assert not found["track.eta"].both
    force = found["track.N"]
    assert (force.least, force.value(0)) == (-100, "0")
    assert Fraction(force.value(-50)) == -Fraction(force.value(50)) == -force.reach / 2
    assert force.position(-force.reach / 4) == -25
    assert -100 < force.position(Fraction(-1000)) <= 0


def test_what_is_left_out_begins_at_the_size_of_its_like() -> None:
    bogie = vehicles.Bogie(wheel=1500, frame=3000, inertia=155, wheelbase="2.5", k="4.8e9", c=250)
    problem = Problem(PROBLEM.track, bogie, v=20)
    absent = dict.fromkeys(("vehicles[0].body", "vehicles[0].k_contact"))
    found = knobs(problem, {**problem.parameters, **absent})
    assert found["vehicles[0].k_contact"] == Knob(Fraction("4.8e9"), Fraction(0))
    assert found["vehicles[0].body"].base >= 3000
    assert float(found["vehicles[0].body"].value(-100)) > 0


def test_a_size_of_the_problem_s_own_has_its_unit() -> None:
    """N/m² and N m² differ by the fourth power of the track's length, of some metres."""
    ratio = own_size(PROBLEM, "N m²") / own_size(PROBLEM, "N/m²")
    assert 1 <= ratio <= 1000
    assert 1e4 <= own_size(PROBLEM, "N/m²") <= 1e8  # k is 1e6


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("250/9", "27.7778"),
        ("6380430", "6.38043e6"),
        ("300000000", "300e6"),
        ("0.0001", "0.0001"),
        ("-1000", "-1000"),
    ],
)
def test_what_a_field_shows_can_be_typed(value: str, text: str) -> None:
    assert field_text(Fraction(value)) == text
    assert in_unit(text, "m", "x") == pytest.approx(Fraction(value), rel=1e-5)
