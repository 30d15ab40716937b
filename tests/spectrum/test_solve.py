"""Every counted root is found and enclosed, against an independent table; what stays open says why, with a remedy."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from oracle_general.package import as_problem

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb
from mpsolve.numbers.rootball import RootBall
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.cover import OpenPieceError
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.candidates import Area, find_roots, nearest_root
from mpsolve.spectrum.reasons import reason_of
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle
from mpsolve.spectrum.solve import Found, _inside, solve

TABLE = json.loads((Path(__file__).parents[1] / "data" / "general_counts.json").read_text())
ROWS = {str(row.get("seed", row.get("name"))): row for row in TABLE}
GROWING = [
    "2",
    "4",
    "6",
    "12",
    "28",
    "78",
    "84",
    "97",
    "110",
    "123",
    "172",
    "divergence, weak damping",
    "two bogies on stiff contacts",
]
"""Among them a root a hair below the axis, one on the imaginary axis, and p-roots of very different sizes."""


def found_in(name: str, region: Any = HalfPlane(), seconds: float = 20) -> Found:  # noqa: B008 — frozen
    return solve(reduce_problem(as_problem(ROWS[name])), region, 20, Effort(seconds=seconds), lambda *_: None)


@pytest.mark.parametrize("name", GROWING)
def test_all_counted_roots_are_enclosed(name: str) -> None:
    found = found_in(name)
    assert found.reason is None
    assert found.count is not None
    assert found.count.total == ROWS[name]["count"] == sum(ball.multiplicity for ball in found.balls)
    for re, im in ROWS[name]["roots"]:
        q = complex(float(re), float(im))
        assert sum(abs(complex(one.q.mid()) - q) < 1e-6 * abs(q) for one in found.balls) == 1


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(name for name, row in ROWS.items() if row["count"] and "within" not in row))
def test_never_fewer_than_counted(name: str) -> None:
    found = found_in(name, seconds=10)
    assert found.reason is None or found.reason.code != "roots"


def test_a_lossless_oscillator_that_the_track_does_not_feel_has_no_root_below_the_line() -> None:
    """n₊ = 0: its own frequencies, 0.0465 and 8.27 on its contact spring, are real."""
    for region in (HalfPlane(), Rectangle(0, 9, -2, "-0.0001")):
        found = found_in("16", region)
        assert found.reason is None
        assert found.count is not None
        assert found.count.total == 0


def test_a_rectangle_beside_zero_holds_the_roots_of_floating_ice() -> None:
    """Roots of the table with Re q > 0 all lie in a rectangle that keeps away from q = 0, where waves meet."""
    roots = [(float(re), float(im)) for re, im in ROWS["79"]["roots"]]
    low, high = min(re for re, _ in roots), max(re for re, _ in roots)
    box = Rectangle(low / 2, 2 * high, 2 * min(im for _, im in roots), 0)
    beside = found_in("79", box)
    assert beside.reason is None
    assert len(beside.balls) == len(roots) == ROWS["79"]["count"] / 2


def test_reasons_have_codes_and_remedies() -> None:
    reduced = reduce_problem(as_problem(ROWS["2"]))
    place = reason_of(reduced, OpenPieceError(3.3 + 0.1j, 1e-9))
    assert place.code == "line"
    assert place.remedy
    assert reason_of(reduced, PrecisionError("a sentence")).message == "a sentence"


def test_newton_from_a_root_stays_there() -> None:
    row = ROWS["97"]
    reduced = reduce_problem(as_problem(row))
    q = complex(*map(float, row["roots"][0])) / float(reduced.frequency_unit)
    near = nearest_root(reduced, q * (1 + 1e-4))
    assert near is not None
    assert abs(near - q) < 1e-8 * abs(q)


def test_candidates_without_hints_are_the_roots() -> None:
    row = ROWS["84"]
    reduced = reduce_problem(as_problem(row))
    unit = float(reduced.frequency_unit)
    want = [complex(*map(float, root)) / unit for root in row["roots"]]
    size = 2 * max(abs(q) for q in want)
    found = find_roots(reduced, (Area(0.0, size, -size / 2, 0.0),), row["count"], np.zeros(0, complex))
    assert len(found) == len(want)
    for q in want:
        assert min(abs(found - q)) < 1e-6 * abs(q)


def ball(re: float, im: float, radius: float = 1e-9) -> RootBall:
    return RootBall(acb(arb(re, radius), arb(im, radius)), -40)


def test_inside_is_the_region_and_no_more() -> None:
    """Below a height with a disc: beside the disc, just below the axis, is outside."""
    held = Below(Fraction(1, 10), reach=Fraction(2), radius=Fraction(2))
    assert _inside(held, ball(1.999, 0.05))
    assert _inside(held, ball(0.5, -1.5))
    assert _inside(held, ball(0.5, 0, 1e-3))  # across the axis
    assert not _inside(held, ball(1.9999, -0.09))
    assert not _inside(held, ball(2.1, 0.05))
    assert not _inside(held, ball(0.5, 0.1))
    whole = Below(Fraction(1, 10), reach=Fraction(2))
    assert _inside(whole, ball(1.9999, -0.09))
    assert _inside(whole, ball(50, -1))
    assert not _inside(whole, ball(50, 0.01))
    assert not _inside(HalfPlane(Fraction(2)), ball(1.5, -1.5))
    assert not _inside(Rectangle(0, 1, -1, 0), ball(1, -0.5))
