"""A spectrum's answers: stability needs the whole half-plane, a root's frequency and times are balls."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import pytest
from flint import acb, arb

from mpsolve.numbers.rootball import Symmetry
from mpsolve.outcome import Reason, Status
from mpsolve.problem.problem import Problem
from mpsolve.spectrum.regions import Answered, Below, HalfPlane, Rectangle, Sheet
from mpsolve.spectrum.spectrum import Root, Spectrum
from mpsolve.tracks import String
from mpsolve.vehicles import Mass

PROBLEM = Problem(String(T=1, m=1, k=1, c="0.1"), [Mass(1)], v=0)


def root(re: str, im: str) -> Root:
    return Root(acb(arb(re), arb(im)), 1, Symmetry.NONE, PROBLEM)


def spectrum(region: Answered, unstable: int | None, status: Status = Status.PROVED, **rest: Any) -> Spectrum:
    return Spectrum(PROBLEM, region, 15, status, unstable=unstable, **rest)


def test_frequency_growth_and_times() -> None:
    one = root("3.5", "-0.25")
    assert one.frequency.overlaps(arb("3.5") / (2 * arb.pi()))
    assert abs(float(one.frequency) - 3.5 / (2 * math.pi)) < 1e-15
    assert float(one.growth) == 0.25
    assert abs(float(one.doubling_time) - math.log(2) / 0.25) < 1e-14
    assert float(root("-3.5", "0.25").frequency) == float(one.frequency)
    assert float(root("3.5", "0.25").growth) == -0.25
    assert root("3.5", "0").doubling_time > 10**300  # a frequency that is exactly real, without damping


@pytest.mark.parametrize(
    ("region", "unstable", "status", "stable"),
    [
        (HalfPlane(), 0, Status.PROVED, True),
        (Below(Fraction(1), Fraction(5)), 0, Status.UNVERIFIED, True),
        (Sheet(), 0, Status.PROVED, True),
        (Sheet(), 2, Status.PROVED, False),
        (HalfPlane(Fraction(9)), 0, Status.PROVED, None),
        (HalfPlane(Fraction(9)), 1, Status.PROVED, False),
        (Below(Fraction(1), Fraction(5), Fraction(5)), 0, Status.PROVED, None),
        (Rectangle(0, 1, -1, 0), 0, Status.PROVED, None),
        (Rectangle(0, 1, -1, 0), 1, Status.PROVED, False),
        (HalfPlane(), None, Status.UNDECIDED, None),
        (HalfPlane(), 0, Status.UNDECIDED, None),
    ],
)
def test_stable(region: Answered, unstable: int | None, status: Status, stable: bool | None) -> None:
    assert spectrum(region, unstable, status).stable is stable


def test_no_truth_value() -> None:
    with pytest.raises(TypeError, match=r"ask for \.proved"):
        assert spectrum(HalfPlane(), 0)


def test_a_card_in_the_problems_units() -> None:
    found = spectrum(HalfPlane(), 2, count=2, roots=(root("-3.5", "-0.25"), root("3.5", "-0.25")))
    page = found._repr_html_()
    assert "UNSTABLE" in page
    assert "frequency [Hz]" in page
    assert "±3.5" in page
    open_ = spectrum(HalfPlane(), None, Status.UNDECIDED, reason=Reason("count", "no <way>", {}, "try & see"))
    assert "UNDECIDED: no &lt;way&gt;: try &amp; see" in open_._repr_html_()
