"""What reports say where a speed of short waves is left out of a range: no verdict speaks of the whole."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace

import pytest

from mpsolve import Problem, Status, crossings, onset, tracks, unstable_ranges, vehicles
from mpsolve.numbers.balls import arb
from mpsolve.ranges.crossed import Crossings
from mpsolve.ranges.onset import Kind, Onset, _read
from mpsolve.ranges.seen import BEYOND
from mpsolve.ranges.unstable import shared
from mpsolve.report.ranges_asked import asked
from mpsolve.report.ranges_words import report_of, said_of_crossings, said_of_onset, said_of_ranges

WIRE = Problem(tracks.String(T=27000, m="1.07", k=500, c=2), [vehicles.Mass(20).at(0)], v=100)
ASKED = asked(WIRE, "", ["v=0..300"])
OVER = {"v": (Fraction(0), Fraction(300))}


@pytest.mark.parametrize(
    "ask", [(onset, said_of_onset), (unstable_ranges, said_of_ranges), (crossings, said_of_crossings)]
)
def test_what_is_left_out_is_told(ask: tuple[object, object]) -> None:
    prove, say = ask
    said = say(prove(WIRE, over=OVER), ASKED)  # type: ignore[operator]
    assert "but see what is left out" in said.verdict
    assert "Note: left out: v = 158.851015 m/s itself" in said.text
    assert "certificate: left out" not in said.text


def test_all_of_a_range_is_told_so() -> None:
    said = said_of_onset(onset(WIRE, over={"v": (0, 150)}), asked(WIRE, "", ["v=0..150"]))
    assert said.verdict == "STABLE for every v from 0 m/s to 150 m/s."


def test_what_is_slower_than_the_answer_is_told() -> None:
    beam = Problem(tracks.EulerBernoulli(EI=6.4e6, m=60, k=1e6, c=770, eta=1e-5), vehicles.Mass(900), v=10)
    for low, told in (("0", True), ("1", False)):
        question = asked(beam, "", [f"v={low}..20"])
        text = said_of_onset(onset(beam, over=question.over, check=False), question).text
        assert ("Nothing is claimed of slower velocities" in text) == told


def test_an_onset_in_what_is_left_out() -> None:
    """Stable below the speed and unstable above it: the value is all that lies between, and it has no frequency."""
    whole = crossings(WIRE, over=OVER)
    low, high = whole.parts
    low = replace(low, over={"v": (Fraction(0), Fraction(150))})
    high = replace(high, over={"v": (Fraction(170), Fraction(300))}, counts=(2,))
    found: Crossings = replace(whole, parts=(low, high), counts=(0, 2))
    first = _read(found, Onset(WIRE, OVER, **shared(found)))
    assert (first.kind, first.q) == (Kind.CROSSES, None)
    assert first.value.contains(arb(150))
    assert first.value.contains(arb(170))
    said = said_of_onset(first, ASKED)
    assert (
        said.verdict == "STABLE for v from 0 m/s to 150 m/s, UNSTABLE just beyond 170 m/s; but see what is left out."
    )
    assert "frequency" not in said.text


def test_several_ranges_have_one_title_and_one_sentence_of_what_is_assumed() -> None:
    """`onset` printed both twice where it looked at two ranges."""
    said = said_of_onset(onset(WIRE, over={"v": (0, 50)}, check=False), asked(WIRE, "One axle", ["v=0..50"]))
    text = report_of([said, said])
    assert text.startswith("One axle\nSTABLE")
    assert text.endswith("FLINT's ball arithmetic.\n")
    assert (text.count("One axle"), text.count("Assumed, not proved"), text.count("STABLE")) == (1, 1, 2)
    assert report_of([replace(said, asked=ASKED)]).startswith("STABLE")


def test_why_there_is_no_certificate_stands_once() -> None:
    proofs = (SimpleNamespace(base=SimpleNamespace(status=Status.PROVED)),)
    for note, said in ((f"it is late; {BEYOND}", ": it is late. The roots"), (BEYOND, "has passed. The roots")):
        found = Onset(WIRE, OVER, Status.UNVERIFIED, kind=Kind.STABLE, note=note, proofs=proofs)  # type: ignore[arg-type]
        text = said_of_onset(found, ASKED).text
        assert f"\nNote: {BEYOND}.\n" in text
        assert said in text
        assert text.count("it is late") == note.count("late")
