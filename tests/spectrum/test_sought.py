"""Rectangles hold all roots that were counted, and some hints are near each of them."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mpsolve import Case, Rectangle
from mpsolve.problem.cases import as_problem
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.count import count_roots
from mpsolve.spectrum.regions import Below, HalfPlane
from mpsolve.spectrum.sheet import count_sheet
from mpsolve.spectrum.sought import areas_of, hints_of, weight_of

# what cxroots finds in rectangles off the cuts (tests/bench/bench_certify.py), without the mirrors −q̄
ROOTS = {
    ("0.67", "0.05"): (0.1558609630593 - 2.7230128e-05j, 0.1323182116424 + 0.00384893354525j),
    ("1.2", "0.05"): (0.1538 - 0.1002j, 0.1283 + 0.1325j),
    ("0.5", "0"): (0.1419 + 0j, 0.1725 + 0j),
}


def pair(alpha: str, eta_b: str) -> Any:
    return reduce_problem(as_problem(Case(alpha=alpha, eta_b=eta_b, eta_m=["70"] * 2, positions=["0", "1.5"])))


@pytest.mark.parametrize(("alpha", "eta_b"), ROOTS)
def test_on_the_sheet(alpha: str, eta_b: str) -> None:
    reduced = pair(alpha, eta_b)
    line = on_line(reduced)
    assert line is not None
    count = count_sheet(line, Effort())
    areas, hints = areas_of(reduced, count), hints_of(reduced, count)
    unit = float(reduced.frequency_unit)
    for root in ROOTS[alpha, eta_b]:
        q = root / unit
        assert any(area.holds(q, 1e-6) for area in areas)
        assert np.abs(hints - q).min() < 0.4 * abs(q)
    assert len(set(hints.tolist())) == len(hints)
    sizes = [area.size for area in areas if area.im_min < float(line.height)]
    assert sizes == sorted(sizes)
    assert weight_of(reduced, count.region)(0.3 + 1j) == 2
    assert weight_of(reduced, count.region)(1e-12 + 1j) == 1


def test_below_a_height_and_in_a_rectangle() -> None:
    reduced = pair("0.67", "0.05")
    unit = float(reduced.frequency_unit)
    slow, fast = (root / unit for root in ROOTS["0.67", "0.05"])
    for region, within in (
        (HalfPlane(), [True, False]),
        (Below(Fraction("0.04")), [True, True]),
        (Rectangle(-1, "0.145", "-0.1", "0.04"), [True, True]),  # by its mirror
    ):
        count = count_roots(reduced, region, Effort(), lambda *_: None)
        areas = areas_of(reduced, count)
        assert [any(area.holds(q, 1e-9) for area in areas) for q in (slow, fast)] == within
        assert len(hints_of(reduced, count)) > 10
    weigh = weight_of(reduced, Rectangle(-1, "0.145", "-0.1", "0.04"))
    assert (weigh(slow), weigh(fast)) == (1, 2)
