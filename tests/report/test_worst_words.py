"""The least stable value in words: whether it grows, where, how fast, and how far the proof goes."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from flint import acb, arb

from mpsolve import Problem, tracks, vehicles
from mpsolve.outcome import Reason, Status
from mpsolve.ranges.onset import Kind, Onset
from mpsolve.ranges.worst import Worst
from mpsolve.report.ranges_asked import asked
from mpsolve.report.worst_words import said_of_onset_at_worst, said_of_worst

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PROBLEM = Problem(TRACK, [vehicles.Mass(9000).at(0), vehicles.Mass(9000).at("3.4")], v=20)
QUESTION = asked(PROBLEM, "Pair", ["gap[0]=1m..5m"])
OVER = {"gap[0]": (Fraction(1), Fraction(5))}


def worst(q: complex, where: str = "inside", **more: object) -> Worst:
    ball = acb(arb(q.real, 1e-16), arb(q.imag, 1e-17))
    return Worst(PROBLEM, OVER, Status.UNVERIFIED, value=arb(2.5, 1e-16), q=ball, where=where, **more)


def test_growth_has_its_doubling_time() -> None:
    said = said_of_worst(worst(12 - 0.5j), QUESTION)
    assert said.verdict.startswith("UNSTABLE: the fastest growing vibration grows fastest at gap[0] = 2.5 m, inside")
    assert "growth: 0.5" in said.text
    assert "(doubles in 1.386 s)" in said.text
    assert said.grows


def test_decay_has_its_half_life_and_its_reach() -> None:
    said = said_of_worst(worst(12 + 0.25j, "end", reach=Fraction(300)), QUESTION)
    assert said.verdict.startswith("STABLE: the least damped vibration decays most slowly at")
    assert "where the range ends" in said.verdict
    assert "(halves in 2.773 s)" in said.text
    assert "compared up to Re q = 300 rad/s" in said.text
    assert not said.grows


def test_what_no_contact_feels_is_left_out() -> None:
    alone = vehicles.Vehicle(M=[[9, 0], [0, 1]], C=[[0, 0], [0, 0]], K=[[0, 0], [0, 5]], B=[[1], [0]], places=[0])
    found = replace(worst(12 + 0.25j, reach=Fraction(300)), problem=Problem(TRACK, alone, v=20))
    assert "no contact feels are left out" in said_of_worst(found, QUESTION).text
    assert "no contact" not in said_of_worst(worst(12 + 0.25j), QUESTION).text


def test_what_is_undecided_says_why() -> None:
    why = Reason("effort", "the effort is spent", {}, "allow more")
    said = said_of_worst(Worst(PROBLEM, OVER, Status.UNDECIDED, why), QUESTION)
    assert said.verdict == "UNDECIDED: the effort is spent: allow more."


def test_where_nothing_is_lowest_it_is_stable_for_a_reason() -> None:
    said = said_of_worst(Worst(PROBLEM, OVER, Status.UNVERIFIED, note="nothing grows on this beam"), QUESTION)
    assert said.verdict == "STABLE: nothing grows on this beam."
    assert not said.grows


@pytest.mark.parametrize("kind", [Kind.CROSSES, Kind.STABLE])
def test_an_onset_at_the_worst_value_names_both_ranges(kind: Kind) -> None:
    first = asked(PROBLEM, "", ["v=0..90 km/h"])
    both = {"v": (Fraction(0), Fraction(25)), **OVER}
    crosses = {"value": arb(20, 1e-15), "q": arb(12, 1e-15), "worst": arb(2.5, 1e-15), "where": "start"}
    more = crosses if kind is Kind.CROSSES else {}
    found = Onset(PROBLEM, both, Status.UNVERIFIED, kind=kind, **more)
    said = said_of_onset_at_worst(found, first, QUESTION)
    assert said.verdict.startswith("For every gap[0] from 1 m to 5 m: STABLE for ")
    assert ("worst gap[0]: 2.5" in said.text) == (kind is Kind.CROSSES)
    assert "v from 0 km/h to 90 km/h, gap[0] from 1 m to 5 m" in said.text
    assert said.grows == (kind is Kind.CROSSES)


def test_what_grows_from_the_start_on_is_said_of_one_value() -> None:
    both = {"v": (Fraction(0), Fraction(25)), **OVER}
    found = Onset(PROBLEM, both, Status.UNVERIFIED, kind=Kind.UNSTABLE_FROM_START, worst=arb(2.5), where="inside")
    said = said_of_onset_at_worst(found, asked(PROBLEM, "", ["v=0..90 km/h"]), QUESTION)
    assert said.verdict.startswith("At gap[0] = 2.5 m: UNSTABLE already at v")
    assert said.grows
