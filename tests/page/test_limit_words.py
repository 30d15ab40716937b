"""Limits in words: in tonnes and metres, with the difference on the right side."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

from flint import arb

from mpsolve import Case, Problem, certify, crossings, read_problem, tracks, vehicles
from mpsolve.numbers.spoken import spoken
from mpsolve.outcome import Reason
from mpsolve.page.budget import Part
from mpsolve.page.limit_words import Row, limit_rows, mass_named, told
from mpsolve.page.limits import Reach
from mpsolve.page.parts import Parts, gather
from mpsolve.ranges.margin import Margin
from mpsolve.ranges.onset import Kind

OVER = (Fraction(2000), Fraction(40000))


def tonnes(x: object) -> str:
    return spoken(x, "kg")


def row(stable: bool | None, below: object = None, above: object = None) -> tuple[str, str]:
    found = Margin("m", Fraction(9800), OVER, stable, below, above, Reason("open", "it is open", {}, "wait"))
    said = told("mass", found, tonnes)
    return said.limit, said.spare


def test_every_side() -> None:
    assert row(True, None, arb(12400)) == ("unstable just above 12.4 t", "2.6 t to spare")
    assert row(True, arb(9000)) == ("unstable just below 9 t", "800 kg down to spare")
    assert row(False, arb(9000)) == ("stable just below 9 t", "800 kg too much")
    assert row(False, None, arb(12400)) == ("stable just above 12.4 t", "2.6 t too little")
    assert row(True) == ("stable all the way from 2 t to 40 t", "no limit in this range")
    assert row(None) == ("undecided: it is open: wait", "")


PAIR = Problem(
    tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770),
    [vehicles.Mass(6406).at(0), vehicles.Mass(6406).at("3.4")],
    v="264.75",
)


def velocity_row(found: Reach, problem: Problem = PAIR) -> Row:
    none: Part[Any] = Part("x", reason="it is not asked for")
    spectrum = certify(problem, region="unstable", digits=15, check=False)
    reach = Part("onset", found)
    made = Parts(problem, problem, "", Fraction(400), spectrum, reach, none, none, none, none, none)
    return limit_rows(replace(made, mass=none, distance=None))[0]


def test_a_case_in_a_stable_part_above_the_first_limit_is_not_too_fast() -> None:
    """Unstable from 202.6 to 253.0 m/s and from 283.9 on: at 264.75 m/s the case is stable."""
    edges = [crossing.value for crossing in crossings(PAIR, over={"v": (180, 300)}, check=False).crossings]
    assert len(edges) == 3
    found = Reach(Kind.CROSSES, Fraction(0), Fraction(400), edges[0])
    first = velocity_row(found)
    assert first.limit == "stable below 729.4 km/h"
    assert first.spare == "223.7 km/h above it, and stable again"
    assert velocity_row(found, PAIR.changed("v", 230)).spare == "98.64 km/h too much"
    assert velocity_row(found, PAIR.changed("v", 180)).limit == "unstable just above 729.4 km/h"


def test_growth_at_the_start_of_the_velocities_says_nothing_of_higher_ones() -> None:
    found = velocity_row(Reach(Kind.UNSTABLE_FROM_START, Fraction(100), Fraction(400)))
    assert (found.limit, found.spare) == ("unstable already at 360 km/h", "")


def test_a_velocity_outside_of_what_was_looked_at_is_open() -> None:
    found = velocity_row(Reach(Kind.CROSSES, Fraction(300), Fraction(400), arb(350)))
    assert (found.limit, found.status) == ("undecided: it lies outside of the range that was looked at", "open")


def gathered(name: str) -> Parts:
    source = read_problem(f"examples/{name}.toml")
    return gather(source.given, "", digits=15, seconds=60, tell=lambda *_: None)


def test_rows_of_a_page() -> None:
    rows = limit_rows(gathered("dimensionless"))
    assert [(one.name, one.own, one.limit, one.spare) for one in rows] == [
        ("velocity", "α = 0.67", "stable below α = 0.6669", "α = 0.003081 too much"),
        ("mass ratio η_M of each", "70", "stable just below 66.72", "3.282 too much"),
        (
            "distance",
            "1.5",
            "stable just below 1.493, stable just above 1.941",
            "0.006764 too much, 0.4408 too little",
        ),
    ]
    rail = gathered("rail_60e1")
    assert [one.own for one in limit_rows(rail)] == ["360 km/h", "10 t", "3.4 m"]
    assert isinstance(rail.given, Case) is False
    assert mass_named(rail)[0] == "each of the 2 masses"
