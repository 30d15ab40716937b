"""The cards of the first screen: they say what the parts say, with the right sign and unit."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import arb

from mpsolve import Case, Load, Problem, certify, critical_velocities, response, tracks, vehicles
from mpsolve.outcome import Reason
from mpsolve.page.budget import Part
from mpsolve.page.limits import Reach
from mpsolve.page.parts import Parts
from mpsolve.page.words import cards, contact_card, contact_names, growth_card, speech, velocity_card, wave_card
from mpsolve.ranges.onset import Kind
from mpsolve.vibration.liftoff import Event

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=250)
NONE: Part[Any] = Part("x", reason="it is not asked for")


def reach(kind: str, value: Any = None, high: int = 400, reason: Reason | None = None) -> Part[Any]:
    return Part("onset", Reach(Kind(kind), Fraction(0), Fraction(high), value, reason))


def parts(problem: Problem = PAIR, **more: Any) -> Parts:
    found = certify(problem, region="unstable", digits=15)
    made = Parts(problem, problem, "", Fraction(400), found, NONE, NONE, NONE, NONE, NONE, NONE)
    return replace(made, **more)


def test_too_fast_and_slow_enough() -> None:
    crossing = reach("crosses", arb(191))
    card = velocity_card(parts(reach=crossing))
    assert card.figure == "stable below 687.6 km/h"
    assert "212.4 km/h above it" in card.sentence
    slow = velocity_card(parts(PAIR.changed("v", 150), reach=crossing))
    assert "leaves 147.6 km/h: it runs at 78.5 % of the limit" in slow.sentence


@pytest.mark.parametrize(
    ("kind", "figure"),
    [("stable", "no change"), ("unstable_from_start", "unstable from the start"), ("undecided", "undecided")],
)
def test_other_answers(kind: str, figure: str) -> None:
    assert velocity_card(parts(reach=reach(kind))).figure == figure


def test_what_is_open_further_up_is_said() -> None:
    card = velocity_card(parts(reach=reach("stable", high=200, reason=Reason("effort", "time is up", {}, ""))))
    assert (card.figure, card.status) == ("not up to 720 km/h", "proved")
    assert "Beyond that it is open." in card.sentence


def test_growth_doubles_in_a_time() -> None:
    card = growth_card(parts())
    assert card is not None
    assert card.figure.startswith("doubles in")
    assert card.status == "proved"
    calm = growth_card(parts(PAIR.changed("v", 100), spectrum=certify(PAIR.changed("v", 100), region=("below", 5))))
    assert calm is not None
    assert calm.sentence.startswith("Of the vibrations in the table the one at")  # others decay faster, or are beyond


def test_lift_off_and_late() -> None:
    motion = SimpleNamespace(lift_off=Event(0.02, 2, 1e-6), times=[0.0, 1.0])
    card = contact_card(parts(response=Part("response", motion)))
    assert card.figure == "after 20 ms"
    assert card.sentence.startswith("The weight of the vehicle is put at once on a smooth rail")
    assert "then contact 2, counted from the rear" in card.sentence
    assert "not growth" not in card.sentence
    late = contact_card(parts(response=Part("response", reason="no time", late=True)))
    assert late.figure == "not in time"


def test_a_lift_off_of_a_stable_case_is_told_from_growth() -> None:
    slow = PAIR.changed("v", 100)
    calm = certify(slow, region="unstable", digits=15)
    motion = SimpleNamespace(lift_off=Event(0.02, 2, 1e-6), times=[0.0, 1.0])
    said = contact_card(parts(slow, response=Part("response", motion), spectrum=calm)).sentence
    assert "It is the swing of this sudden start, not growth." in said


def test_the_contact_is_the_one_whose_force_ends() -> None:
    """Of two the rear one, number 1."""
    motion = response(PAIR.changed("v", 100), times=np.linspace(0, 1, 400))
    assert motion.lift_off is not None
    assert contact_card(parts(response=Part("response", motion))).sentence.endswith(
        "then contact 1, counted from the rear (wheel of vehicle 1), lifts off first. The model says nothing of "
        "what follows."
    )
    k = int(np.argmin(abs(motion.times - motion.lift_off.time)))
    assert abs(motion.contact_force[0, k]) < 2000
    assert motion.contact_force[1, k] > 20000


def test_the_papers_ratios_have_no_units() -> None:
    case = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
    said = speech(replace(parts(), given=case))
    assert said.velocity(Fraction(2, 3)) == "α = 0.6667"
    assert speech(parts()).velocity(Fraction(70)) == "252 km/h"


def test_slow_waves_are_named_on_layers_only() -> None:
    layers = tracks.TwoLayer(
        EI="6.4e6", m=60, k_pad="3e8", c_pad="3e4", m_sleeper=250, k_ballast="1e8", c_ballast="8e4"
    )
    on_layers = Problem(layers, vehicles.Mass(900).at(0), v=70)
    for problem, slow in ((PAIR, False), (on_layers, True)):
        found = critical_velocities(problem.track)
        card = wave_card(replace(parts(), problem=problem, critical=Part("critical velocities", found)))
        assert card is not None
        assert ("shorter and slower waves" in card.sentence) is slow
        assert "Two waves merge there" in card.sentence
        assert re.search(r"This case runs at \d[\d.]* % of it", card.sentence)
        assert "followed by a free wave" not in card.sentence


def test_advice_is_that_of_the_command() -> None:
    late = Reason("effort", "time is up", {}, "allow more effort, with effort=Effort(seconds=…)")
    first = cards(parts(reach=reach("undecided", reason=late)))[0]
    assert "allow more with --effort SECONDS" in first.sentence
    assert "Effort(" not in first.sentence


def test_no_lift_off_says_how_long_and_how_much() -> None:
    slow = PAIR.changed("v", 100)
    rail, force = np.array([[0.0, 0.0031]]), np.array([[0.0, 98100.0]])
    motion = SimpleNamespace(lift_off=None, unjudged=(), times=[0.0, 2.0], rail=rail, contact_force=force)
    swings = certify(slow, region=("below", 5), digits=15)
    said = contact_card(parts(slow, response=Part("response", motion), spectrum=swings)).sentence
    assert said.startswith("Not within 2 s (eight periods of the lowest frequency) after the weight of the vehicle")
    assert "Meanwhile the rail sinks by at most 3.1 mm, and one contact presses with at most 98.1 kN." in said
    weight = sum(float(placed.vehicle.M) for placed in slow.vehicles)
    assert said.endswith(
        f"All masses of the file together are {weight / 1000:g} t, as a rule those over one rail: "
        f"at rest {weight * 9.80665 / 2000:.3g} kN a contact, on average."
    )


def test_of_a_contact_that_nothing_presses_nothing_is_said() -> None:
    """Two harmonic forces without a constant one: the forces are tension in turns, and no lift-off is told."""
    loads = [Load(0, 1000, 100), Load(0, 1000, 100)]
    motion = response(PAIR.changed("v", 100), loads, times=[0, 1])
    assert motion.lift_off is None
    card = contact_card(parts(response=Part("response", motion)))
    assert (card.figure, card.status) == ("not judged", "open")


def test_contacts_are_called_by_the_wheels_over_them() -> None:
    bogie = vehicles.Bogie(wheel=900, frame=2000, inertia=1500, wheelbase=2, k=10**6)
    assert contact_names(Problem(TRACK, bogie.at(0), v=10)) == ["rear wheel", "front wheel"]


def test_a_range_from_almost_zero() -> None:
    found = Reach(Kind.CROSSES, Fraction(1, 20), Fraction(400), arb(191))
    assert velocity_card(parts(reach=Part("onset", found))).sentence.endswith(
        "Every velocity from practically zero on was looked at."
    )
    found = Reach(Kind.CROSSES, Fraction(10), Fraction(400), arb(191))
    assert velocity_card(parts(reach=Part("onset", found))).sentence.endswith(
        "Every velocity from 36 km/h on was looked at."
    )
