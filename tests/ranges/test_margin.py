"""Margins: the nearest changes are those that certify sees on both sides, and what is open stays open."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from typing import Any

import pytest
from flint import arb

from mpsolve import Case, Problem, certify, tracks, vehicles
from mpsolve.outcome import Reason, Status
from mpsolve.problem.cases import as_problem
from mpsolve.ranges.margin import Margin, margin, margin_in, stable_region
from mpsolve.ranges.unstable import Unstable, UnstableRanges

CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
PROBLEM = as_problem(CASE)


def stable(path: str, value: Any) -> bool | None:
    return certify(PROBLEM.changed(path, value), region="unstable", digits=15, check=False).stable


def test_too_heavy_by_a_little() -> None:
    found = margin(CASE, "scale.mass", (Fraction(1, 5), Fraction(4)))
    assert (found.stable, found.above) == (False, None)
    assert str(found.below).startswith("[0.95310799780")
    assert stable("scale.mass", "0.9531")
    assert stable("scale.mass", "0.9532") is False


def test_a_window_in_the_distance_has_two_ends() -> None:
    found = margin(PROBLEM, "scale.gap", (Fraction(1, 2), Fraction(2)))
    low, high = float(found.below.mid()), float(found.above.mid())
    assert found.stable is False
    assert low < 1 < high
    assert [stable("scale.gap", f"{x:.6f}") for x in (low - 1e-4, low + 1e-4, high - 1e-4, high + 1e-4)] == [
        True, False, False, True
    ]  # fmt: skip


def parts(*ends: tuple[Any, Any, bool], status: Status = Status.UNVERIFIED) -> UnstableRanges:
    """Unstable parts with their ends, and whether they begin with the range."""
    each = tuple(Unstable(arb(a), arb(b), None if first else arb(1), 2) for a, b, first in ends)
    return UnstableRanges(
        CASE, {"v": (Fraction(0), Fraction(10))}, status, Reason("open", "is open", {}, "wait"), intervals=each
    )


@pytest.mark.parametrize(
    ("ends", "own", "said"),
    [
        ([], 5, (True, None, None)),
        ([(0, 10, True)], 5, (False, None, None)),
        ([(6, 7, False), (7, 10, False)], 5, (True, None, 6)),
        ([(6, 7, False), (7, 10, False)], 8, (False, 6, None)),
        ([(1, 2, False), (6, 7, False)], 5, (True, 2, 6)),
        ([(0, 2, True), (6, 7, False)], 1, (False, None, 2)),
    ],
)
def test_neighbouring_parts_are_one(ends: Any, own: int, said: Any) -> None:
    found = margin_in(parts(*ends), Fraction(own))
    assert (found.stable, *(x and float(x.mid()) for x in (found.below, found.above))) == said


def test_what_is_open_says_why() -> None:
    assert margin_in(parts(status=Status.UNDECIDED), Fraction(5)).reason is not None
    at_the_limit = margin_in(parts((5, 7, False)), Fraction(5))
    assert isinstance(at_the_limit, Margin)
    assert at_the_limit.stable is None


def test_what_is_left_out_of_velocities_leaves_a_margin_open() -> None:
    """No claim is made of the velocity of the waves."""
    wire = Problem(tracks.String(T=27000, m="1.07", k=500, c=2), [vehicles.Mass(20).at(0)], v=100)
    found = margin(wire, "v", (Fraction(0), Fraction(300)))
    assert (found.stable, found.reason and found.reason.code) == (None, "left-out")
    assert margin(wire, "v", (Fraction(0), Fraction(150))).stable is True


TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=150)
HALF = Fraction(1, 2)


def test_it_is_stable_at_every_corner_and_holds_the_case() -> None:
    box = stable_region(PAIR, {"v": HALF, "track.k": HALF}, 30)
    assert box is not None
    assert box["v"][0] < 150 < box["v"][1] < Fraction(191)
    for v, k in product(*box.values()):
        corner = PAIR.changed("v", v).changed("track.k", k)
        assert certify(corner, region="unstable", digits=15, check=False).stable


def test_there_is_none_round_what_grows_and_none_of_what_is_0() -> None:
    assert stable_region(PAIR.changed("v", 250), {"v": HALF}, 30) is None
    assert stable_region(PAIR, {"v": HALF, "track.N": HALF}, 30) is None
    assert stable_region(PAIR, {"v": HALF}, 0) is None
