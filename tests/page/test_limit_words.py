"""Limits in words: in tonnes and metres, with the difference on the right side."""

from __future__ import annotations

from fractions import Fraction

from flint import arb

from mpsolve import Case, read_problem
from mpsolve.numbers.spoken import spoken
from mpsolve.outcome import Reason
from mpsolve.page.limit_words import limit_rows, mass_named, told
from mpsolve.page.parts import Parts, gather
from mpsolve.ranges.margin import Margin

OVER = (Fraction(2000), Fraction(40000))


def tonnes(x: object) -> str:
    return spoken(x, "kg")


def row(stable: bool | None, below: object = None, above: object = None) -> tuple[str, str]:
    found = Margin("m", Fraction(9800), OVER, stable, below, above, Reason("open", "it is open", {}, "wait"))
    said = told("mass", found, tonnes)
    return said.limit, said.spare


def test_every_side() -> None:
    assert row(True, None, arb(12400)) == ("unstable above 12.4 t", "2.6 t to spare")
    assert row(True, arb(9000)) == ("unstable below 9 t", "800 kg down to spare")
    assert row(False, arb(9000)) == ("stable below 9 t", "800 kg too much")
    assert row(False, None, arb(12400)) == ("stable above 12.4 t", "2.6 t too little")
    assert row(True) == ("stable all the way from 2 t to 40 t", "no limit in this range")
    assert row(None) == ("undecided: it is open: wait", "")


def gathered(name: str) -> Parts:
    source = read_problem(f"examples/{name}.toml")
    return gather(source.given, "", digits=15, seconds=60, tell=lambda *_: None)


def test_rows_of_a_page() -> None:
    rows = limit_rows(gathered("dimensionless"))
    assert [(one.name, one.own, one.limit, one.spare) for one in rows] == [
        ("velocity", "α = 0.67", "stable below α = 0.6669", "α = 0.003081 too much"),
        ("mass ratio η_M of each", "70", "stable below 66.72", "3.282 too much"),
        ("distance", "1.5", "stable below 1.493, stable above 1.941", "0.006764 too much, 0.4408 too little"),
    ]
    rail = gathered("rail_60e1")
    assert [one.own for one in limit_rows(rail)] == ["360 km/h", "10 t", "3.4 m"]
    assert isinstance(rail.given, Case) is False
    assert mass_named(rail)[0] == "each of the 2 masses"
