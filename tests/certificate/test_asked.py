"""What is counted for what was asked, and the height that a refusal names."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Case, InputError, PhysicalCase, Problem, Rectangle, tracks, vehicles
from mpsolve.certificate.asked import asked_region, default_region, has_whole_sheet, is_damped
from mpsolve.problem.cases import as_problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.regions import Below, HalfPlane

LOW = Fraction(2) / (2 * Fraction("1.07"))
"""c/2m: the wire's waves that are slow in space decay at this rate."""
WIRE = reduce_problem(Problem(tracks.String(T=27_000, m="1.07", k=500, c=2), vehicles.Mass("8.5"), v=100))
SHEAR = tracks.Timoshenko(EI="6.4e6", m=60, S="2e8", J="0.2", k="1e6", c=770)
TOUCHING = reduce_problem(Problem(SHEAR, vehicles.Mass(1000), v=60))
"""Its rotation is not damped: the cuts come down to the real axis."""


def test_what_was_asked_for() -> None:
    box = Rectangle(0, 20, -1, 0)
    assert asked_region(WIRE, "unstable") == HalfPlane()
    assert asked_region(WIRE, ("below", "0.9")) == Below(Fraction(9, 10))
    assert asked_region(WIRE, box) is box
    assert asked_region(WIRE, HalfPlane(Fraction(3))) == HalfPlane(Fraction(3))


def test_left_out_it_ends_just_below_the_lowest_cut() -> None:
    found = asked_region(WIRE, None)
    assert isinstance(found, Below)
    assert LOW * Fraction(9, 10) < found.height < LOW
    assert asked_region(TOUCHING, None) == HalfPlane()


@pytest.mark.parametrize("region", [("below", 1), Rectangle(0, 20, -1, 1)])
def test_the_height_that_a_refusal_names_is_allowed(region: object) -> None:
    with pytest.raises(InputError, match=r"begin at Im q = 0\.93") as caught:
        asked_region(WIRE, region)
    named = Fraction(re.findall(r"up to ([0-9.]+)$", str(caught.value))[0])
    assert LOW * Fraction(999, 1000) < named < LOW
    assert isinstance(asked_region(WIRE, ("below", named)), Below)


@pytest.mark.parametrize(
    ("region", "words"), [(("below", 1), 'ask for "unstable"'), (Rectangle(0, 20, -1, 1), "give im_max up to 0")]
)
def test_where_cuts_touch_the_real_axis(region: object, words: str) -> None:
    with pytest.raises(InputError, match="come down to Im q = 0") as caught:
        asked_region(TOUCHING, region)
    assert words in str(caught.value)


def test_no_region() -> None:
    with pytest.raises(InputError, match="region: is 'sheet'"):
        asked_region(WIRE, "sheet")


@pytest.mark.parametrize(
    ("given", "whole", "default"),
    [
        (Case(alpha="0.5", eta_b="0.1", eta_m=5), True, "sheet"),
        (Case(alpha="0.5", eta_b="0.1", eta_m=[5] * 4, positions=range(4)), True, "sheet"),
        (Case(alpha="0.5", eta_b="1.1", eta_m=5), False, None),  # its cuts leave their line
        (PhysicalCase(EI=1, m=1, k=1, c="0.1", v="0.5", masses=[(1, x) for x in range(3)]), True, None),
        (PhysicalCase(EI=1, m=1, k=1, v="0.5", masses=[(1, x) for x in range(3)]), True, "sheet"),
        (Problem(tracks.String(T=1, m=1, k=1, c="0.1"), vehicles.Mass(1), v=0), False, None),
    ],
)
def test_what_is_asked_for_by_default(given: Any, whole: bool, default: str | None) -> None:
    meant = as_problem(given)
    assert (has_whole_sheet(meant), default_region(given, meant)) == (whole, default)
    assert is_damped(meant) is not (getattr(given, "c", 1) == 0)
