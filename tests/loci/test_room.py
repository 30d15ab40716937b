"""Kinds of tubes: a box is on one side of the cuts, or in the gap; the gap is that of exact arithmetic."""

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import Case
from mpsolve.loci.room import ABOVE, BELOW, GAP, Room, SheetRoom
from mpsolve.numbers.balls import acb
from mpsolve.problem.cases import as_problem
from mpsolve.problem.family import family_of
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem

PROBLEM = as_problem(Case(alpha="0.8", eta_b="0.05", eta_m=(40, 40), positions=(0, 1)))


def room(path: str = "v", low: str = "0.5", high: str = "1.2") -> SheetRoom:
    family = family_of(PROBLEM, {path: (Fraction(low), Fraction(high))})
    return SheetRoom(*(float(x) for x in family.box[0]), family=family)


@pytest.mark.parametrize("v", ["0.5", "0.8", "0.99"])
def test_the_gap_ends_at_the_branch_point(v: str) -> None:
    x = float(v)
    gap = room().gap((x, x))
    line = on_line(reduce_problem(PROBLEM.changed("v", Fraction(x))))
    assert line is not None
    assert line.in_gap(Fraction(gap))
    assert not line.in_gap(Fraction(gap * (1 + 1e-6)))
    wide = room().gap((x - 0.01, x))
    assert 0 < wide < gap


def test_there_is_no_gap_where_the_cuts_have_joined() -> None:
    assert room().gap((1.0, 1.0)) == 0
    assert room().gap((0.9, 1.1)) == 0


def test_boxes_are_placed_on_their_side() -> None:
    here, ends = room(), (0.8, 0.81)
    assert here.placed(0.01 + 0.06j, 0.02, ends, BELOW, False) == (0.01 + 0.06j, GAP)
    middle, kind = here.placed(0.9 + 0.06j, 0.02, ends, BELOW, False) or (0j, 9)
    assert kind == BELOW
    assert middle.imag == pytest.approx(0.05 - 0.02 / 8)
    assert here.fits(middle, 0.02, ends, BELOW)
    assert not here.fits(middle, 0.02, ends, ABOVE)
    assert not here.fits(middle, 0.02, ends, GAP)
    middle, kind = here.placed(0.9 + 0.04j, 0.02, ends, ABOVE, False) or (0j, 9)
    assert (kind, middle.imag > 0.05) == (ABOVE, True)
    assert here.placed(0.9 + 0.05j, 0.02, ends, GAP, True) is None  # it would not be known on which side it begins
    assert here.placed(0.9 + 0.06j, 0.02, ends, GAP, False)[1] == ABOVE  # type: ignore[index]


def test_roots_are_told_by_their_side() -> None:
    here = room()
    kinds = [here.kind_of(complex(1, y), 1e-3, 0.8) for y in (0.04, 0.0495, 0.06)]
    assert kinds == [BELOW, GAP, ABOVE]
    assert here.holds(acb(0.9, 0.04), BELOW, 0.8)
    assert not here.holds(acb(0.9, 0.06), BELOW, 0.8)
    assert here.holds(acb(0.01, 0.06), BELOW, 0.8)  # through the gap
    assert not here.holds(acb(0.9, 0.04), ABOVE, 0.8)


def test_damping_moves_the_line() -> None:
    here = room("track.c", "0.08", "0.12")
    low, high = here.height((here.low, here.high))
    family = here.family
    truth = [
        float(x * family.units[0]) / 2 / float(family.frequency_unit)
        for x in (Fraction(here.low), Fraction(here.high))
    ]
    assert np.allclose([low, high], truth, rtol=1e-12)
    assert low <= truth[0] * (1 + 1e-15)


def test_a_region_has_one_side() -> None:
    plain = Room(0.5, 1.0, 0.04)
    assert plain.kind_of(1 + 1j, 0.1, 0.7) == BELOW
    assert plain.placed(0.5 + 0.05j, 0.01, (0.5, 0.6), BELOW, True)[0].imag <= 0.04  # type: ignore[index]
    assert not plain.fits(0.01j, 0.01, (0.5, 0.6), GAP)
